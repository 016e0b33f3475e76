// The part of diffuse light on every surfel that its paint lets through.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_PIECES 2
#define BINDING_OPAQUES 3
#define BINDING_TEXELS 6
#define BINDING_PAINT_TABLES 7
#include "lib/linear.glsl"
#include "lib/painted_pieces.glsl"

layout(std430, set = 0, binding = 8) writeonly buffer Through { vec4 through[]; };

layout(push_constant) uniform Push {
  uint surfelCount;
  uint piecesPerSurfel;
};

void main() {
  uint i = linearIndex();
  if (i >= surfelCount) return;
  uint first = i * piecesPerSurfel;
  MediumData medium = mediumAt(objects[pieceAt(first).object], vec3(0.0));
  PaintEntry mean;
  bool found = isPainted(medium) && meanPaint(medium, first, first + piecesPerSurfel, mean);
  through[i] = found ? mean.entering : vec4(1.0);
}
