// How much of what a surface mirrors towards the camera is sky, of all that pixels see: rays of the
// GGX lobe that meet nothing. Each of a pixel's samples that see it has some of the lobe's rays.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SEEN 1
#define BINDING_SEEN_LIST 2
#define MESH_BINDING 8
#define BINDING_OBJECTS 4
#define BINDING_PIECE_CORNERS 5
#define BINDING_RAYS 6
#include "lib/bodies.glsl"
#include "lib/frame.glsl"
#include "lib/pi.glsl"
#include "lib/rays.glsl"
#include "lib/seen_list.glsl"
#include "lib/unit.glsl"

layout(std430, set = 0, binding = 7) buffer Light { vec4 light[]; };  // the share in w

layout(push_constant) uniform Push {
  uint first;
  uint nodeCount;  // of all surfels' trees
  uint piecesPerSurfel;
  uint rays;       // of one sample
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

// The widest go first: where those agree, so do the others within the lobe.
float shareOfSky(vec3 place, vec3 normal, vec3 facet, uint samples) {
  vec3 toCamera = normalize(frame.cameraPosition.xyz - place);
  vec3 across = unitOr(cross(normal, toCamera), normalize(cross(normal, normal.yzx + vec3(0.3, 0.5, 0.7))));
  vec3 along = cross(across, normal);
  vec3 places = abs(place);
  float start = startOf * max(max(places.x, places.y), places.z);
  vec3 origin = place + start * facet;
  RayTarget scene = RayTarget(0u, nodeCount, everyObject);
  uint sent = 0u;
  uint free = 0u;
  uint enough = max(raysInAll / 4u, 2u);
  for (uint left = raysInAll; left > 0u; --left) {
    bool agreed = free == 0u || free == sent;
    if (samples == everySample && raysInAll - left == enough && agreed) break;
    uint i = left - 1u;
    if ((samples >> i / rays & 1u) == 0u) continue;
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
  Seen seen = seenOfInvocation(first);
  if (!seen.there) return;
  MeshPlace place = seenPlace(seen.pixel, seen.word);
  light[seen.entry].w = shareOfSky(place.position, place.normal, place.facet, samplesOf(seen.word));
}
