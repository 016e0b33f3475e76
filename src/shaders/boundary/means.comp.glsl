// The half-space's exitance as its mean over every cluster, from that of surfels or of vertices.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/linear.glsl"
#include "shared/boundary.h"
#include "shared/surfels.h"

layout(constant_id = 0) const uint ofVertices = 1u;

layout(std430, set = 0, binding = 0) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 1) readonly buffer Pieces { SurfelPiece pieces[]; };
layout(std430, set = 0, binding = 2) readonly buffer Sources { Source sources[]; };
layout(std430, set = 0, binding = 3) readonly buffer Exitances { vec4 exitances[]; };
layout(std430, set = 0, binding = 4) writeonly buffer Means { vec4 means[]; };

layout(push_constant) uniform Push {
  uint clusterCount;
  uint piecesPerSurfel;
};

float areaOf(uint surfel) {
  float area = 0.0;
  for (uint s = 0u; s < sourcesPerSurfel; ++s)
    area += sources[sourcesPerSurfel * surfel + s].positionArea.w;
  return area;
}

// Interpolated in the middle of its pieces.
vec3 atVertices(uint surfel) {
  vec3 sum = vec3(0.0);
  float parts = 0.0;
  for (uint p = surfel * piecesPerSurfel; p < (surfel + 1u) * piecesPerSurfel; ++p) {
    SurfelPiece piece = pieces[p];
    vec2 at = vec2(piece.v0 + piece.v1 + piece.v2, piece.w0 + piece.w1 + piece.w2) / 3.0;
    sum += piece.fraction * ((1.0 - at.x - at.y) * exitances[piece.a].rgb +
                             at.x * exitances[piece.b].rgb + at.y * exitances[piece.c].rgb);
    parts += piece.fraction;
  }
  return parts > 0.0 ? sum / parts : vec3(0.0);
}

void main() {
  uint i = linearIndex();
  if (i >= clusterCount) return;
  vec3 sum = vec3(0.0);
  float all = 0.0;
  for (uint surfel = ranges[i].firstSurfel; surfel < ranges[i].endSurfel; ++surfel) {
    float area = areaOf(surfel);
    sum += area * (ofVertices != 0u ? atVertices(surfel) : exitances[surfel].rgb);
    all += area;
  }
  means[i] = vec4(all > 0.0 ? sum / all : vec3(0.0), 0.0);
}
