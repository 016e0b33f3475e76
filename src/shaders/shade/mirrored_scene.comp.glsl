// What surfaces mirror of the scene towards the camera: rays of the GGX lobe, and the light of the clusters that
// they meet. Where rays are few, this light is interpolated between clusters. Where the lobe is wide, 2×2 pixels of
// a translucent surface share its rays: each sends a quarter, and takes what those around it have found.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SEEN 1
#define BINDING_SEEN_LIST 2
#define MESH_BINDING 9
#define BINDING_OBJECTS 4
#define BINDING_PIECE_CORNERS 5
#define BINDING_RAYS 6
#define BINDING_CLUSTER_NODES 15
#define BINDING_CLUSTERS 16
#include "lib/bodies.glsl"
#include "lib/clusters_around.glsl"
#include "lib/frame.glsl"
#include "lib/rays.glsl"
#include "lib/reflected_rays.glsl"
#include "lib/seen_list.glsl"
#include "shared/boundary.h"
#include "shared/opaque.h"

layout(std430, set = 0, binding = 7) buffer Materials { SeenMaterial materials[]; };
layout(std430, set = 0, binding = 8) readonly buffer ClusterOfSurfel { uint clusterOfSurfel[]; };
layout(std430, set = 0, binding = 13) readonly buffer Exitances { vec4 exitances[]; };
layout(std430, set = 0, binding = 14) readonly buffer OpaqueExitances { vec4 opaqueExitances[]; };
layout(std430, set = 0, binding = 17) readonly buffer SkyShares { float skyShares[]; };

// For the first surfaces of a band's pixels: the summed radiance of bodies that some rays meet; w: how many do.
layout(std430, set = 0, binding = 18) buffer Met { vec4 met[]; };

layout(push_constant) uniform Push {
  uint first;
  uint nodeCount;  // of all surfels' trees
  uint piecesPerSurfel;
  uint translucent;  // 1: translucent surfaces too; `skyShares` says how much they mirror of the sky
  uint insides;      // 1: light that leaves bodies with an inside is known
  float alpha;       // of translucent surfaces without one of their own
  uint ownSurfaces;  // 1: `materials` has the roughness and the normal of translucent surfaces too
  uint firstRow;     // of the band
  uint rows;
  uint round;
};

#include "lib/neighbours.glsl"

// The rounds of MirroredScenePass.
const uint askingSome = 0u;
const uint takingAll = 1u;

// From this width of the lobe on, pixels need not tell apart what they mirror.
const float leastAlphaShared = 0.04;
const int widthOfSharing = 2;
const uint sharing = 4u;
const float asked = 1e-6;  // tells pixels whose rays meet nothing from those that send none

uint firstPieceOf(uint object) {
  return objects[object].table.y * piecesPerSurfel;
}

vec3 exitanceOf(uint cluster, bool opaque) {
  return opaque ? opaqueExitances[cluster].rgb : exitances[cluster].rgb;
}

// At a place of a body, by the clusters around, or else by its own.
vec3 exitanceAt(vec3 place, vec3 normal, ObjectData body, uint own) {
  bool opaque = isOpaque(body);
  vec3 sum = vec3(0.0);
  float all = 0.0;
  uint node = body.clusters.x;
  while (node < body.clusters.y) {
    uint i;
    float weight = weightOfNext(node, place, normal, i);
    if (weight <= 0.0) continue;
    sum += weight * exitanceOf(i, opaque);
    all += weight;
  }
  return all > 0.0 ? sum / all : exitanceOf(own, opaque);
}

// This many rays see patches of clusters as their mean.
const uint raysThatSmooth = 7u;

// w: whether it is known.
vec4 radianceAt(vec3 place, uint piece, vec3 direction, uint rays) {
  uint cluster = clusterOfSurfel[piece / piecesPerSurfel];
  ObjectData body = objects[objectOfPiece(piece)];
  bool opaque = isOpaque(body);
  float known = opaque ? 1.0 : insides != 0u ? clusters[cluster].second.w : 0.0;
  vec3 facet = facetNormal(piece);
  if (hasBack(body) && clusters[cluster].along.w * dot(facet, direction) > 0.0) cluster = backOf(cluster, body);
  if (rays >= raysThatSmooth || body.clusters.z == 0u) return vec4(exitanceOf(cluster, opaque) / pi, known);
  vec3 normal = dot(facet, direction) > 0.0 ? -facet : facet;
  return vec4(exitanceAt(place, normal, body, cluster) / pi, known);
}

// The wider the lobe, the more.
uint raysOf(float alpha) {
  return alpha < 0.002 ? 1u : clamp(uint(48.0 * alpha), 4u, mostMirroredRays);
}

// The widest rays go first: where those meet nothing, nor do the others within the lobe.
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
    vec3 origin = place.position + start * place.facet;
    RayHit hit = nearestHit(origin, direction, start, 3e38, RayTarget(0u, nodeCount, everyObject));
    sum += hit.piece == noPiece
               ? vec4(0.0, 0.0, 0.0, 1.0)
               : vec4(radianceAt(origin + hit.distance * direction, hit.piece, direction, count).rgb, 0.0);
  }
  return sent > 0.0 ? sum / sent : vec4(0.0, 0.0, 0.0, 1.0);
}

// How rough a mirroring surface is, and which way it faces.
struct Mirror {
  float alpha;
  vec3 normal;
};

Mirror mirrorOf(Seen seen, MeshPlace place) {
  if (ownSurfaces != 0u) return Mirror(materials[seen.entry].diffuse.w, materials[seen.entry].normal.xyz);
  return Mirror(alpha, place.normal);
}

// What every `every`-th ray of a translucent surface meets, without the sky, summed; w: how many meet it.
vec4 bodiesMet(MeshPlace place, Mirror mirror, uint firstRay, uint every) {
  uint count = raysOf(mirror.alpha);
  float start = startAbove(place.position);
  vec4 sum = vec4(0.0);
  for (uint i = firstRay; i < count; i += every) {
    vec3 direction = reflectedDirection(i, count, mirror.alpha, mirror.normal, place);
    if (direction == vec3(0.0)) continue;
    vec3 origin = place.position + start * place.facet;
    RayHit hit = nearestHit(origin, direction, start, 3e38, RayTarget(0u, nodeCount, everyObject));
    if (hit.piece == noPiece) continue;
    vec4 radiance = radianceAt(origin + hit.distance * direction, hit.piece, direction, count);
    sum += radiance.w * vec4(radiance.rgb, 1.0);
  }
  return sum;
}

// Otherwise it mirrors only sky.
bool mirrorsBodies(Seen seen) {
  return skyShares[seen.entry] < 1.0;
}

vec4 bodiesAround(Seen seen, MeshPlace place, Mirror mirror) {
  if (!mirrorsBodies(seen)) return vec4(0.0);
  vec4 sum = vec4(0.0);
  bool shares = isFirstSurface(seen) && mirror.alpha >= leastAlphaShared;
  ivec2 window = windowAround(seen.pixel, widthOfSharing);
  for (uint i = 0u; shares && i < sharing; ++i) {
    ivec2 other = pixelOfWindow(window, i, widthOfSharing);
    if (!isInBand(other)) continue;
    uint word = seenWord(other, 0u);
    if (samplesOf(word) == 0u) continue;
    if (other == seen.pixel || isOneSurface(place, seenPlace(other, word))) sum += met[indexOf(other)];
  }
  if (sum.w == 0.0) sum = bodiesMet(place, mirror, 0u, 1u);
  return sum.w > sharing * asked ? vec4(sum.rgb / sum.w, 1.0) : vec4(0.0);
}

// Which of 2×2 pixels it is.
uint cellOf(ivec2 pixel) {
  return uint(pixel.x & 1) + 2u * uint(pixel.y & 1);
}

void askOfTranslucent(Seen seen, MeshPlace place) {
  Mirror mirror = mirrorOf(seen, place);
  if (round == takingAll) {
    materials[seen.entry].around = bodiesAround(seen, place, mirror);
  } else if (isFirstSurface(seen)) {
    bool shares = mirrorsBodies(seen) && mirror.alpha >= leastAlphaShared;
    met[indexOf(seen.pixel)] = shares ? bodiesMet(place, mirror, cellOf(seen.pixel), sharing) + vec4(0.0, 0.0, 0.0, asked) : vec4(0.0);
  }
}

void main() {
  Seen seen = seenOfInvocation(first);
  if (!seen.there) return;
  MeshPlace place = seenPlace(seen.pixel, seen.word);
  if (!isOpaque(objects[place.object])) {
    if (translucent != 0u) askOfTranslucent(seen, place);
    return;
  }
  if (round == askingSome) return;
  SeenMaterial material = materials[seen.entry];
  // A surface that mirrors next to nothing needs no rays.
  if (material.metal.w <= 0.0 && material.dielectric == vec4(0.0)) return;
  materials[seen.entry].around = mirrored(place, material);
}
