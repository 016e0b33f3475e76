// What opaque surfaces mirror of the scene towards the camera: rays of the GGX lobe, and the light of
// the clusters that they meet.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SEEN 1
#define BINDING_SEEN_LIST 2
#define MESH_BINDING 9
#define BINDING_OBJECTS 4
#define BINDING_PIECE_CORNERS 5
#define BINDING_RAYS 6
#include "lib/bodies.glsl"
#include "lib/frame.glsl"
#include "lib/rays.glsl"
#include "lib/reflected_rays.glsl"
#include "lib/seen_list.glsl"
#include "shared/opaque.h"

layout(std430, set = 0, binding = 7) buffer Materials { SeenMaterial materials[]; };
layout(std430, set = 0, binding = 8) readonly buffer ClusterOfSurfel { uint clusterOfSurfel[]; };
layout(std430, set = 0, binding = 13) readonly buffer Exitances { vec4 exitances[]; };
layout(std430, set = 0, binding = 14) readonly buffer OpaqueExitances { vec4 opaqueExitances[]; };

layout(push_constant) uniform Push {
  uint first;
  uint nodeCount;  // of all surfels' trees
  uint piecesPerSurfel;
};

uint firstPieceOf(uint object) {
  return objects[object].table.y * piecesPerSurfel;
}

vec3 radianceAt(uint piece) {
  uint cluster = clusterOfSurfel[piece / piecesPerSurfel];
  bool opaque = isOpaque(objects[objectOfPiece(piece)]);
  return (opaque ? opaqueExitances[cluster].rgb : exitances[cluster].rgb) / pi;
}

// As many as the lobe is wide.
uint raysOf(float alpha) {
  return alpha < 0.002 ? 1u : clamp(uint(48.0 * alpha), 4u, mostMirroredRays);
}

// The widest go first: where those meet nothing, so do the others within the lobe.
vec4 mirrored(MeshPlace place, SeenMaterial material) {
  float alpha = material.diffuse.w;
  uint count = raysOf(alpha);
  uint enough = min(count, 3u);
  float start = startAbove(place.position);
  vec4 sum = vec4(0.0);
  float sent = 0.0;
  for (uint left = count; left > 0u; --left) {
    if (count - left == enough && sum.w == sent) break;
    vec3 direction = reflectedDirection(left - 1u, count, alpha, material.normal.xyz, place);
    if (direction == vec3(0.0)) continue;
    sent += 1.0;
    RayHit hit = nearestHit(place.position + start * place.facet, direction, start, 3e38,
                            RayTarget(0u, nodeCount, everyObject));
    sum += hit.piece == noPiece ? vec4(0.0, 0.0, 0.0, 1.0) : vec4(radianceAt(hit.piece), 0.0);
  }
  return sent > 0.0 ? sum / sent : vec4(0.0, 0.0, 0.0, 1.0);
}

void main() {
  Seen seen = seenOfInvocation(first);
  if (!seen.there) return;
  MeshPlace place = seenPlace(seen.pixel, seen.word);
  if (!isOpaque(objects[place.object])) return;
  SeenMaterial material = materials[seen.entry];
  // What mirrors next to nothing needs no rays.
  if (material.specular.w <= 0.0 && material.specular.rgb == vec3(0.0)) return;
  materials[seen.entry].around = mirrored(place, material);
}
