// Rays of what a surface mirrors towards the camera. Needs, before it, lib/frame.glsl, lib/bodies.glsl,
// and what lib/rays.glsl needs.
#ifndef OPALINE_LIB_REFLECTED_RAYS
#define OPALINE_LIB_REFLECTED_RAYS
#include "lib/mesh.glsl"
#include "lib/pi.glsl"
#include "lib/rays.glsl"
#include "lib/unit.glsl"

layout(push_constant) uniform Push {
  uint first;      // of the list, or of the picture's rows
  uint nodeCount;  // of all surfels' trees
  uint piecesPerSurfel;
  uint rays;       // of one sample
  uint raysInAll;  // of all samples
  float alpha;
};

// Rays leave a facet by that sine at least: interpolated normals mirror some into it.
const float leastSine = 0.02;

uint firstPieceOf(uint object) {
  return objects[object].table.y * piecesPerSurfel;
}

// The i-th normal of microfacets, as dense as GGX has them (Walter et al. 2007); the only one is the
// surface's. The last are turned most.
vec3 microfacet(uint i, vec3 normal, vec3 along) {
  if (raysInAll == 1u) return normal;
  float u = (float(i) + 0.5) / float(raysInAll);
  float angle = 2.0 * pi * (float(bitfieldReverse(i)) / 4294967296.0);
  float cosine = sqrt((1.0 - u) / (1.0 + (alpha * alpha - 1.0) * u));
  float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
  return sine * (cos(angle) * along + sin(angle) * cross(normal, along)) + cosine * normal;
}

const uint rayMeets = 0u;
const uint rayIsFree = 1u;
const uint noRay = 2u;  // it would enter the surface

// The i-th ray of the lobe at a place.
uint reflectedRay(uint i, MeshPlace place) {
  vec3 toCamera = normalize(frame.cameraPosition.xyz - place.position);
  vec3 across = unitOr(cross(place.normal, toCamera),
                       normalize(cross(place.normal, place.normal.yzx + vec3(0.3, 0.5, 0.7))));
  vec3 along = cross(across, place.normal);
  vec3 direction = reflect(-toCamera, microfacet(i, place.normal, along));
  if (dot(direction, place.normal) <= 0.0 && raysInAll > 1u) return noRay;
  float sine = dot(direction, place.facet);
  if (sine < leastSine) direction = normalize(direction + (leastSine - sine) * place.facet);
  float start = startAbove(place.position);
  bool meets = occluded(place.position + start * place.facet, direction, start, 3e38,
                        RayTarget(0u, nodeCount, everyObject));
  return meets ? rayMeets : rayIsFree;
}

#endif
