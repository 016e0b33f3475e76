// The mean normal that a texture gives each piece of a surfel, as lib/tilted_normal.glsl reads it.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_OPAQUES 3
#define BINDING_TEXELS 6
#define BINDING_PIECES 2
#include "lib/linear.glsl"
#include "lib/material.glsl"
#include "lib/piece.glsl"
#include "lib/piece_at.glsl"
#include "lib/piece_material.glsl"

layout(std430, set = 0, binding = 7) readonly buffer TriangleOfPiece { uint triangleOfPiece[]; };
layout(std430, set = 0, binding = 8) writeonly buffer Tilts { vec4 tilts[]; };

layout(push_constant) uniform Push {
  uint pieceCount;
};

vec4 tiltOf(uint i, OpaqueData material) {
  SurfelPiece piece = pieceAt(i);
  vec3 told = toldNormal(material, placeOfPiece(piece, material));
  float size = clamp(length(told), 1e-3, 1.0);
  told = unitOr(vec3(material.specularColor.w * told.xy, told.z), vec3(0.0, 0.0, 1.0));
  CornerTangents corners = tangents[triangleOfPiece[i]];
  vec2 middle = middleOf(cornersOf(piece));
  // At rest the tangents are of unit length.
  vec2 tangent = (1.0 - middle.x - middle.y) * corners.first.xy + middle.x * corners.first.zw +
                 middle.y * corners.last.xy;
  float parts = length(tangent);
  return parts > 0.0 ? vec4(size / parts * tangent, told.x, corners.last.z * told.y) : vec4(0.0);
}

void main() {
  uint i = linearIndex();
  if (i >= pieceCount) return;
  MediumData medium = mediumAt(objects[pieceAt(i).object], vec3(0.0));
  OpaqueData material = opaques[medium.tables.y];
  bool wanted = hasOwnSurface(medium) && isThere(material.normalTexture);
  tilts[i] = wanted ? tiltOf(i, material) : vec4(0.0);
}
