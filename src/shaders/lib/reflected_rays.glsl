// Directions in which a surface mirrors the camera. Needs, before it, lib/frame.glsl.
#ifndef OPALINE_LIB_REFLECTED_RAYS
#define OPALINE_LIB_REFLECTED_RAYS
#include "lib/mesh.glsl"
#include "lib/pi.glsl"
#include "lib/unit.glsl"

// How rough a mirroring surface is, and which way it faces.
struct Mirror {
  float alpha;
  vec3 normal;
};

// From this width of the lobe on, pixels need not tell apart what they mirror.
const float leastAlphaShared = 0.04;

// Rays leave a facet by this sine at least, because interpolated normals mirror some into it.
const float leastSine = 0.02;

// The i-th normal of `count` microfacets, distributed as in GGX (Walter et al. 2007). A single one is
// the surface's. The last are turned most.
vec3 microfacet(uint i, uint count, float alpha, vec3 normal, vec3 along) {
  if (count == 1u) return normal;
  float u = (float(i) + 0.5) / float(count);
  float angle = 2.0 * pi * (float(bitfieldReverse(i)) / 4294967296.0);
  float cosine = sqrt((1.0 - u) / (1.0 + (alpha * alpha - 1.0) * u));
  float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
  return sine * (cos(angle) * along + sin(angle) * cross(normal, along)) + cosine * normal;
}

// The i-th ray of the lobe at a place; 0 where it would enter the surface.
vec3 reflectedDirection(uint i, uint count, Mirror mirror, MeshPlace place) {
  vec3 normal = mirror.normal;
  vec3 toCamera = normalize(toCameraFrom(place.position));
  vec3 across = unitOr(cross(normal, toCamera), normalize(cross(normal, normal.yzx + vec3(0.3, 0.5, 0.7))));
  vec3 along = cross(across, normal);
  vec3 direction = reflect(-toCamera, microfacet(i, count, mirror.alpha, normal, along));
  if (dot(direction, normal) <= 0.0 && count > 1u) return vec3(0.0);
  float sine = dot(direction, place.facet);
  return sine < leastSine ? normalize(direction + (leastSine - sine) * place.facet) : direction;
}

#endif
