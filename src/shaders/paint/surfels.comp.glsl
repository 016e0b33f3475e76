// Of diffuse light on every surfel, the part that its paint lets through.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_OPAQUES 3
#define BINDING_TEXELS 6
#define BINDING_PAINT_TABLES 7
#include "lib/linear.glsl"
#include "lib/material.glsl"
#include "lib/paint_table.glsl"
#include "lib/piece_material.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Pieces { SurfelPiece pieces[]; };
layout(std430, set = 0, binding = 8) writeonly buffer Through { vec4 through[]; };

layout(push_constant) uniform Push {
  uint surfelCount;
  uint piecesPerSurfel;
};

void main() {
  uint i = linearIndex();
  if (i >= surfelCount) return;
  through[i] = vec4(1.0);
  MediumData medium = mediumAt(objects[pieces[i * piecesPerSurfel].object], vec3(0.0));
  if (!isPainted(medium)) return;
  OpaqueData material = opaques[medium.tables.y];
  vec3 sum = vec3(0.0);
  float count = 0.0;
  for (uint k = i * piecesPerSurfel; k < (i + 1u) * piecesPerSurfel; ++k) {
    SurfelPiece piece = pieces[k];
    if (piece.fraction <= 0.0) continue;
    sum += paintOf(medium, baseColorAt(material, placeOfPiece(piece, material)).rgb).entering.rgb;
    count += 1.0;
  }
  if (count > 0.0) through[i].rgb = sum / count;
}
