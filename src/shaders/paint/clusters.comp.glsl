// Means of a paint over every cluster, by the pieces of its surfels.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_PIECES 3
#define BINDING_OPAQUES 4
#define BINDING_TEXELS 7
#define BINDING_PAINT_TABLES 8
#include "lib/linear.glsl"
#include "lib/painted_pieces.glsl"
#include "shared/boundary.h"

layout(std430, set = 0, binding = 2) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 9) writeonly buffer ClusterPaints { ClusterPaint clusterPaints[]; };

layout(push_constant) uniform Push {
  uint clusterCount;
  uint piecesPerSurfel;
};

void main() {
  uint i = linearIndex();
  if (i >= clusterCount) return;
  clusterPaints[i] = ClusterPaint(vec4(vec3(1.0), 0.0), vec4(1.0), vec4(1.0), vec4(0.0), vec4(1.0), vec4(0.0));
  ClusterRange range = ranges[i];
  MediumData medium = mediumAt(objects[range.object], vec3(0.0));
  PaintEntry mean;
  if (!isPainted(medium) ||
      !meanPaint(medium, range.firstSurfel * piecesPerSurfel, range.endSurfel * piecesPerSurfel, mean))
    return;
  vec4 atSurface = 2.0 * medium.inside.diffusion.w * mean.source / mean.layer;
  clusterPaints[i] = ClusterPaint(vec4(mean.entering.rgb, 1.0), mean.layer, mean.leaving, mean.takenOff, mean.deep,
                                  vec4(atSurface.rgb, 0.0));
}
