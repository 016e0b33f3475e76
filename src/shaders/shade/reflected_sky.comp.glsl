// How much of what the surface mirrors towards the camera is sky, at every visible pixel: rays of the
// GGX lobe that meet nothing. One antialiasing sample takes some of the lobe's rays.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 4
#define BINDING_PIECE_CORNERS 5
#define BINDING_RAYS 6
#include "lib/bodies.glsl"
#include "lib/frame.glsl"
#include "lib/octahedron.glsl"
#include "lib/pi.glsl"
#include "lib/rays.glsl"
#include "lib/tile.glsl"
#include "lib/unit.glsl"

layout(set = 0, binding = 1) uniform sampler2D surfacePosition;
layout(set = 0, binding = 2) uniform sampler2D surfaceNormal;
layout(set = 0, binding = 3) uniform sampler2D surfaceFacet;
layout(set = 0, binding = 7, r32f) uniform writeonly image2D skyShare;

layout(push_constant) uniform Push {
  uint nodeCount;  // of all surfels' trees
  uint piecesPerSurfel;
  uint firstRay;
  uint rays;       // of this sample
  uint raysInAll;  // of all samples
  float alpha;
};

// Rays leave a facet by that sine at least: interpolated normals mirror some into it.
const float leastSine = 0.02;
// Where they start above it, in parts of the coordinates, which are rounded.
const float startOf = 1e-5;

uint firstPieceOf(uint object) {
  return objects[object].table.y * piecesPerSurfel;
}

// The i-th normal of microfacets, as dense as GGX has them (Walter et al. 2007); the only one is the
// surface's.
vec3 microfacet(uint i, vec3 normal, vec3 along) {
  if (raysInAll == 1u) return normal;
  float u = (float(i) + 0.5) / float(raysInAll);
  float angle = 2.0 * pi * (float(bitfieldReverse(i)) / 4294967296.0);
  float cosine = sqrt((1.0 - u) / (1.0 + (alpha * alpha - 1.0) * u));
  float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
  return sine * (cos(angle) * along + sin(angle) * cross(normal, along)) + cosine * normal;
}

float shareOfSky(vec3 place, vec3 normal, vec3 facet) {
  vec3 toCamera = normalize(frame.cameraPosition.xyz - place);
  if (dot(facet, toCamera) < 0.0) facet = -facet;
  vec3 across = unitOr(cross(normal, toCamera), normalize(cross(normal, normal.yzx + vec3(0.3, 0.5, 0.7))));
  vec3 along = cross(across, normal);
  vec3 places = abs(place);
  float start = startOf * max(max(places.x, places.y), places.z);
  vec3 origin = place + start * facet;
  RayTarget scene = RayTarget(0u, nodeCount, everyObject);
  uint sent = 0u;
  uint free = 0u;
  for (uint i = firstRay; i < firstRay + rays; ++i) {
    vec3 direction = reflect(-toCamera, microfacet(i, normal, along));
    if (dot(direction, normal) <= 0.0 && raysInAll > 1u) continue;
    float sine = dot(direction, facet);
    if (sine < leastSine) direction = normalize(direction + (leastSine - sine) * facet);
    ++sent;
    if (!occluded(origin, direction, start, 3e38, scene)) ++free;
  }
  return sent > 0u ? float(free) / float(sent) : 1.0;
}

void main() {
  ivec2 pixel = pixelOfInvocation();
  if (any(greaterThanEqual(pixel, imageSize(skyShare)))) return;
  vec4 surface = texelFetch(surfacePosition, pixel, 0);
  float share = 1.0;
  if (surface.w > 0.0)
    share = shareOfSky(surface.xyz, unitOr(texelFetch(surfaceNormal, pixel, 0).xyz, vec3(0.0, 1.0, 0.0)),
                       fromOctahedron(texelFetch(surfaceFacet, pixel, 0).xy));
  imageStore(skyShare, pixel, vec4(share));
}
