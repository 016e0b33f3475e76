// The boxes that rays are sent through, read as texels. Needs BINDING_RAYS.
#ifndef OPALINE_LIB_RAY_HIERARCHY
#define OPALINE_LIB_RAY_HIERARCHY
#include "lib/ray_box.glsl"
#include "lib/texels.glsl"

TEXELS(BINDING_RAYS, rayHierarchy);  // RayUnits, then RayBox

vec4 middleUnitOfBoxes() {
  return texelOf(rayHierarchy, 0);
}

uint piecesOfSurfels() {
  return uint(texelOf(rayHierarchy, 1).x);
}

RayBox boxOf(uint node) {
  return RayBox(floatBitsToUint(texelOf(rayHierarchy, int(node) + 2)));
}

#endif
