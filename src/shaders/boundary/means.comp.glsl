// The half-space's exitance as its mean over every cluster, from exitances of vertices, of surfels or of patches.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SOURCES 2
#define BINDING_PIECES 1
#include "lib/linear.glsl"
#include "lib/piece_at.glsl"
#include "lib/surfel_area.glsl"
#include "lib/texels.glsl"
#include "shared/boundary.h"

// CarryPass::From
const uint fromVertices = 0u;
const uint fromPatches = 2u;
layout(constant_id = 0) const uint from = fromVertices;

layout(std430, set = 0, binding = 0) readonly buffer Ranges { ClusterRange ranges[]; };
TEXELS(3, exitances);
layout(std430, set = 0, binding = 4) writeonly buffer Means { vec4 means[]; };
layout(std430, set = 0, binding = 5) readonly buffer Patches { vec4 patches[]; };

layout(push_constant) uniform Push {
  uint clusterCount;
  uint piecesPerSurfel;
};

vec3 exitanceAt(uint place) {
  return texelOf(exitances, int(place)).rgb;
}

// Interpolated in the middle of the surfel's pieces.
vec3 atVertices(uint surfel) {
  vec3 sum = vec3(0.0);
  float parts = 0.0;
  for (uint p = surfel * piecesPerSurfel; p < (surfel + 1u) * piecesPerSurfel; ++p) {
    SurfelPiece piece = pieceAt(p);
    vec2 at = vec2(piece.v0 + piece.v1 + piece.v2, piece.w0 + piece.w1 + piece.w2) / 3.0;
    sum += piece.fraction * ((1.0 - at.x - at.y) * exitanceAt(piece.a) + at.x * exitanceAt(piece.b) + at.y * exitanceAt(piece.c));
    parts += piece.fraction;
  }
  return parts > 0.0 ? sum / parts : vec3(0.0);
}

// Exitance times area, and area.
vec4 overSurfels(ClusterRange range) {
  vec4 sum = vec4(0.0);
  for (uint surfel = range.firstSurfel; surfel < range.endSurfel; ++surfel) {
    vec3 exitance = from == fromVertices ? atVertices(surfel) : exitanceAt(surfel);
    sum += areaOfSurfel(surfel) * vec4(exitance, 1.0);
  }
  return sum;
}

vec4 overPatches(ClusterRange range) {
  vec4 sum = vec4(0.0);
  for (uint i = range.firstPatch; i < range.firstPatch + patchesOf(range); ++i)
    sum += patches[i].w * vec4(exitanceAt(i), 1.0);
  return sum;
}

void main() {
  uint i = linearIndex();
  if (i >= clusterCount) return;
  vec4 sum = from == fromPatches ? overPatches(ranges[i]) : overSurfels(ranges[i]);
  means[i] = vec4(sum.w > 0.0 ? sum.rgb / sum.w : vec3(0.0), 0.0);
}
