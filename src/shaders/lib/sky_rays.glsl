// Rays of what translucent surfaces mirror of the sky towards the camera. Needs, before it,
// lib/frame.glsl, lib/bodies.glsl, and what lib/rays.glsl needs.
#ifndef OPALINE_LIB_SKY_RAYS
#define OPALINE_LIB_SKY_RAYS
#include "lib/rays.glsl"
#include "lib/reflected_rays.glsl"

layout(push_constant) uniform Push {
  uint first;      // of the list, or of the picture's rows
  uint nodeCount;  // of all surfels' trees
  uint piecesPerSurfel;
  uint rays;       // of one sample
  uint raysInAll;  // of all samples
  float alpha;
};

uint firstPieceOf(uint object) {
  return objects[object].table.y * piecesPerSurfel;
}

const uint rayMeets = 0u;
const uint rayIsFree = 1u;
const uint noRay = 2u;  // it would enter the surface

// The i-th of `count` rays of the lobe at a place.
uint reflectedRay(uint i, uint count, MeshPlace place) {
  vec3 direction = reflectedDirection(i, count, alpha, place.normal, place);
  if (direction == vec3(0.0)) return noRay;
  float start = startAbove(place.position);
  bool meets = occluded(place.position + start * place.facet, direction, start, 3e38,
                        RayTarget(0u, nodeCount, everyObject));
  return meets ? rayMeets : rayIsFree;
}

#endif
