// What surfaces mirror of the scene towards the camera: rays of the GGX lobe, and the light of the clusters that
// they meet. Where the lobe is narrow, this light is interpolated between clusters. Where it is wide, pixels share
// their rays: each sends different ones, and takes what those around it have found.
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
#include "lib/ray_start.glsl"
#include "lib/reflected_rays.glsl"
#include "lib/seen_list.glsl"
#include "lib/window_cell.glsl"
#include "shared/boundary.h"
#include "shared/opaque.h"

layout(std430, set = 0, binding = 7) buffer Materials { SeenMaterial materials[]; };
layout(std430, set = 0, binding = 8) readonly buffer ClusterOfSurfel { uint clusterOfSurfel[]; };
layout(std430, set = 0, binding = 13) readonly buffer Exitances { vec4 exitances[]; };  // or half-spaces' means
layout(std430, set = 0, binding = 14) readonly buffer OpaqueExitances { vec4 opaqueExitances[]; };
layout(std430, set = 0, binding = 17) readonly buffer SkyShares { float skyShares[]; };

// For the first surfaces of a band's pixels: the summed radiance of what rays meet; w: packed counts. One buffer is
// of the round before, the other of this one.
layout(std430, set = 0, binding = 18) readonly buffer MetBefore { vec4 metBefore[]; };
layout(std430, set = 0, binding = 19) writeonly buffer MetNow { vec4 metNow[]; };

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

#include "lib/exitance_met.glsl"
#include "lib/neighbours.glsl"

// The rounds of MirroredScenePass.
const uint sendingRays = 0u;
const uint averaging = 1u;
const uint taking = 2u;

uint firstPieceOf(uint object) {
  return objects[object].table.y * piecesPerSurfel;
}

// From this width of the lobe on, it sees patches of clusters as their mean.
const float leastAlphaOfMeans = 0.146;

// Weights of what is met are multiples of this.
const float leastWeight = 0.125;

// w: how much it counts, 0 where it is not known.
vec4 radianceAt(vec3 place, uint piece, vec3 direction, float itsAlpha) {
  uint cluster = clusterOfSurfel[piece / piecesPerSurfel];
  bool opaque = isOpaque(objects[objectOfPiece(piece)]);
  float counts = opaque ? 1.0 : insides != 0u ? leastWeight * floor(clusters[cluster].second.w / leastWeight + 0.5) : 0.0;
  return vec4(exitanceMet(place, piece, direction, itsAlpha < leastAlphaOfMeans) / pi, counts);
}

Mirror mirrorOf(Seen seen, MeshPlace place, bool opaque) {
  if (!opaque && ownSurfaces == 0u) return Mirror(alpha, place.normal);
  return Mirror(materials[seen.entry].diffuse.w, materials[seen.entry].normal.xyz);
}

// A surface that mirrors next to nothing needs no rays.
bool mirrorsBodies(Seen seen, bool opaque) {
  if (!opaque) return translucent != 0u && skyShares[seen.entry] < 1.0;
  return materials[seen.entry].metal.w > 0.0 || materials[seen.entry].dielectric != vec4(0.0);
}

// Which rays of the lobe a pixel sends: every `every`-th of `count`. Pixels of a window of this width share theirs.
struct Rays {
  uint count;
  uint every;
  int width;
};

Rays raysAlone(float itsAlpha) {
  return Rays(itsAlpha < 0.002 ? 1u : clamp(uint(48.0 * itsAlpha), 4u, mostMirroredRays), 1u, 1);
}

// From this width of the lobe on, 4×4 pixels share their rays; before, 2×2 do.
const float leastAlphaOf4 = 0.09;

Rays raysShared(float itsAlpha, bool opaque) {
  if (itsAlpha < leastAlphaShared) return raysAlone(itsAlpha);
  if (itsAlpha < leastAlphaOf4) return Rays(opaque ? 16u : 4u, 4u, 2);
  return Rays(opaque ? 32u : 16u, 16u, 4);
}

// What rays have met: the summed radiance of bodies, the sum of its weights, and how many rays met anything and were
// sent.
struct Found {
  vec3 sum;
  float weights;
  float any;
  float sent;
};

const Found nothing = Found(vec3(0.0), 0.0, 0.0, 0.0);

// Bits of the number of rays of a window, and of that of their weights. Together they are exact in a float.
const int bitsOfRays = 7;
const int bitsOfWeights = 10;

vec4 packed(Found found) {
  uint counts = uint(found.any) | uint(found.sent) << bitsOfRays | uint(found.weights / leastWeight) << 2 * bitsOfRays;
  return vec4(found.sum, float(counts));
}

void add(vec4 packedMet, inout Found found) {
  uint counts = uint(packedMet.w);
  found.sum += packedMet.rgb;
  found.any += float(bitfieldExtract(counts, 0, bitsOfRays));
  found.sent += float(bitfieldExtract(counts, bitsOfRays, bitsOfRays));
  found.weights += leastWeight * float(bitfieldExtract(counts, 2 * bitsOfRays, bitsOfWeights));
}

// The widest rays go first. Where so many of a pixel that shares none meet nothing, nor do the others.
const float enough = 3.0;

Found sendRays(MeshPlace place, Mirror mirror, bool opaque, uint cell, Rays rays) {
  RayStart start = rayStartOn(place);
  Found found = nothing;
  for (uint left = rays.count - cell; left > 0u && left <= rays.count; left -= rays.every) {
    if (rays.every == 1u && found.sent == enough && found.any == 0.0) break;
    uint i = left - 1u;
    vec3 direction = reflectedDirection(i, rays.count, mirror, place);
    if (direction == vec3(0.0)) continue;
    found.sent += 1.0;
    RayHit hit = nearestHit(start.origin, direction, start.least, 3e38, RayTarget(0u, nodeCount, everyObject));
    if (hit.piece == noPiece) continue;
    vec4 radiance = radianceAt(start.origin + hit.distance * direction, hit.piece, direction, mirror.alpha);
    found.sum += (opaque ? 1.0 : radiance.w) * radiance.rgb;
    found.weights += radiance.w;
    found.any += 1.0;
  }
  return found;
}

// What the pixels of a window around have found of the same surface. Windows of an even width lie to one side of the
// pixel by half a pixel; the second round's lie to the other.
Found foundAround(ivec2 pixel, MeshPlace place, int width) {
  ivec2 window = windowAround(round == taking ? pixel + 1 : pixel, width);
  Found found = nothing;
  for (uint i = 0u; i < uint(width * width); ++i) {
    ivec2 other = pixelOfWindow(window, i, width);
    if (!isInBand(other)) continue;
    uint word = seenWord(other, 0u);
    if (samplesOf(word) == 0u) continue;
    vec4 its = metBefore[indexOf(other)];
    if (its.w == 0.0) continue;
    if (other == pixel || isOneSurface(place, seenPlace(other, word))) add(its, found);
  }
  return found;
}

// See SeenMaterial::around.
vec4 aroundOf(Found found, bool opaque) {
  if (!opaque) return found.weights > 0.0 ? vec4(found.sum / found.weights, 1.0) : vec4(0.0);
  if (found.sent == 0.0) return vec4(0.0, 0.0, 0.0, 1.0);
  return vec4(found.sum, found.sent - found.any) / found.sent;
}

void main() {
  Seen seen = seenOfInvocation(first);
  if (!seen.there) return;
  MeshPlace place = seenPlace(seen.pixel, seen.word);
  bool opaque = isOpaque(objects[place.object]);
  Mirror mirror = mirrorOf(seen, place, opaque);
  Rays rays = raysShared(mirror.alpha, opaque);
  bool mirrors = mirrorsBodies(seen, opaque);
  bool shares = mirrors && rays.width > 1 && isFirstSurface(seen);
  if (round != taking) {
    if (!isFirstSurface(seen)) return;
    Found found = nothing;
    if (shares && round == sendingRays) found = sendRays(place, mirror, opaque, cellOf(seen.pixel, rays.width), rays);
    if (shares && round == averaging) found = foundAround(seen.pixel, place, rays.width);
    metNow[indexOf(seen.pixel)] = packed(found);
    return;
  }
  Found found = nothing;
  if (shares) found = foundAround(seen.pixel, place, rays.width);
  if (mirrors && found.sent == 0.0) found = sendRays(place, mirror, opaque, 0u, raysAlone(mirror.alpha));
  if (mirrors || !opaque) materials[seen.entry].around = aroundOf(found, opaque);
}
