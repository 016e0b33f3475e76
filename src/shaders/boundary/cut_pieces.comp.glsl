// Where opaque bodies have holes: pieces of surfels whose mean alpha is less than the cutoff get a negative
// part of their triangle, so that they have no area and no ray meets them.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_OPAQUES 3
#define BINDING_TEXELS 6
#include "lib/bodies.glsl"
#include "lib/linear.glsl"
#include "lib/material.glsl"
#include "lib/piece.glsl"
#include "lib/piece_material.glsl"

layout(std430, set = 0, binding = 2) buffer Pieces { SurfelPiece pieces[]; };

layout(push_constant) uniform Push {
  uint pieceCount;
};

void main() {
  uint i = linearIndex();
  if (i >= pieceCount) return;
  SurfelPiece piece = withoutSetBits(pieces[i]);
  ObjectData body = objects[piece.object];
  if (!isOpaque(body)) return;
  OpaqueData material = opaques[mediumAt(body, vec3(0.0)).tables.y];
  float cutoff = material.emission.w;
  bool cut = cutoff > 0.0 && baseColorAt(material, placeOfPiece(piece, material)).a < cutoff;
  pieces[i].fraction = cut ? -abs(piece.fraction) : abs(piece.fraction);
}
