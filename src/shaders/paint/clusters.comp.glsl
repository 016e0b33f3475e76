// Means of a paint over every cluster, by the pieces of its surfels.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_OPAQUES 4
#define BINDING_TEXELS 7
#define BINDING_PAINT_TABLES 8
#include "lib/linear.glsl"
#include "lib/material.glsl"
#include "lib/paint_table.glsl"
#include "lib/piece_material.glsl"
#include "shared/boundary.h"

layout(std430, set = 0, binding = 2) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 3) readonly buffer Pieces { SurfelPiece pieces[]; };
layout(std430, set = 0, binding = 9) writeonly buffer ClusterPaints { ClusterPaint clusterPaints[]; };

layout(push_constant) uniform Push {
  uint clusterCount;
  uint piecesPerSurfel;
};

ClusterPaint withoutPaint() {
  return ClusterPaint(vec4(vec3(1.0), 0.0), vec4(1.0), vec4(1.0), vec4(0.0), vec4(1.0), vec4(0.0));
}

void main() {
  uint i = linearIndex();
  if (i >= clusterCount) return;
  clusterPaints[i] = withoutPaint();
  ClusterRange range = ranges[i];
  MediumData medium = mediumAt(objects[range.object], vec3(0.0));
  if (!isPainted(medium)) return;
  OpaqueData material = opaques[medium.tables.y];
  ClusterPaint sum = ClusterPaint(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
  float count = 0.0;
  for (uint k = range.firstSurfel * piecesPerSurfel; k < range.endSurfel * piecesPerSurfel; ++k) {
    SurfelPiece piece = pieces[k];
    if (piece.fraction <= 0.0) continue;
    PaintEntry found = paintOf(medium, baseColorAt(material, placeOfPiece(piece, material)).rgb);
    sum.entering += found.entering;
    sum.layer += found.layer;
    sum.leaving += found.leaving;
    sum.takenOff += found.takenOff;
    sum.deep += found.deep;
    sum.atSurface += found.source;
    count += 1.0;
  }
  if (count == 0.0) return;
  sum.atSurface.rgb *= 2.0 * medium.inside.diffusion.w / sum.layer.rgb;
  clusterPaints[i] = ClusterPaint(vec4(sum.entering.rgb / count, 1.0), sum.layer / count, sum.leaving / count,
                                  sum.takenOff / count, sum.deep / count, sum.atSurface);
}
