// Rays for what translucent surfaces mirror of the sky towards the camera. Needs, before it,
// lib/frame.glsl, lib/bodies.glsl, and what lib/rays.glsl needs.
#ifndef OPALINE_LIB_SKY_RAYS
#define OPALINE_LIB_SKY_RAYS
#include "lib/rays.glsl"
#include "lib/ray_start.glsl"
#include "lib/reflected_rays.glsl"
#include "shared/sky_rays.h"

layout(push_constant) uniform Push {
  uint first;      // of the list, or of the picture's rows
  uint nodeCount;  // of all surfels' trees
  uint piecesPerSurfel;
  uint samples;  // of a pixel
  float alpha;
};

uint firstPieceOf(uint object) {
  return objects[object].table.y * piecesPerSurfel;
}

const uint rayMeets = 0u;
const uint rayIsFree = 1u;
const uint noRay = 2u;  // it would enter the surface

uint raysOfSample(float itsAlpha) {
  return uint(skyRaysOfSample(itsAlpha));
}

// Sends the i-th of `count` rays of the lobe at a place.
uint reflectedRay(uint i, uint count, MeshPlace place, Mirror mirror) {
  vec3 direction = reflectedDirection(i, count, mirror, place);
  if (direction == vec3(0.0)) return noRay;
  RayStart start = rayStartOn(place);
  bool meets = occluded(start.origin, direction, start.least, 3e38, RayTarget(0u, nodeCount, everyObject));
  return meets ? rayMeets : rayIsFree;
}

#endif
