// What clusters of opaque bodies give back of light and let through, and what they send out by themselves: means of
// their materials over their pieces, by the areas of these at rest. For linings, the share given back to the light in
// the body. Nothing between lining and body mirrors that light, except metal.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_OPAQUES 4
#define BINDING_TEXELS 7
#define BINDING_PIECES 3
#include "lib/lesser.glsl"
#include "lib/linear.glsl"
#include "lib/material.glsl"
#include "lib/piece_at.glsl"
#include "lib/piece_material.glsl"
#include "lib/pi.glsl"
#include "shared/boundary.h"

layout(std430, set = 0, binding = 2) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 8) writeonly buffer Shares { OpaqueShare shares[]; };
layout(std430, set = 0, binding = 9) readonly buffer ObjectOf { uint objectOf[]; };  // of vertices

layout(push_constant) uniform Push {
  uint clusterCount;
  uint piecesPerSurfel;
};

// Mean over the hemisphere of Schlick's reflectance, for light from everywhere.
vec3 mirroredBy(vec3 headOn, float grazing) {
  return clamp(headOn + (vec3(grazing) - headOn) / 21.0, 0.0, 1.0);
}

void main() {
  uint i = linearIndex();
  if (i >= clusterCount) return;
  ClusterRange range = ranges[i];
  OpaqueShare sum = OpaqueShare(vec4(0.0), vec4(0.0), vec4(0.0));
  bool isLining = range.kind == lining;
  uint end = range.kind == opaqueBody || isLining ? range.endSurfel * piecesPerSurfel : 0u;
  float area = 0.0;
  for (uint k = range.firstSurfel * piecesPerSurfel; k < end; ++k) {
    SurfelPiece piece = pieceAt(k);
    uint object = isLining ? objectOf[piece.a] : range.object;
    OpaqueData material = opaques[mediumAt(objects[object], vec3(0.0)).tables.y];
    SeenMaterial found = materialAt(material, placeOfPiece(piece, material));
    if (isLining) {
      sum.share.rgb += piece.areaMm2 * (found.diffuse.rgb + found.metal.w * found.metal.rgb);
      area += piece.areaMm2;
      continue;
    }
    vec3 byDielectric = mirroredBy(found.dielectric.rgb, found.dielectric.w);
    vec3 mirrored = mix(byDielectric, mirroredBy(found.metal.rgb, 1.0), found.metal.w);
    float left = 1.0 - largestOf(byDielectric);
    sum.share.rgb += piece.areaMm2 * (mirrored + left * found.diffuse.rgb);
    sum.through.rgb += piece.areaMm2 * left * found.through.rgb;
    sum.emission.rgb += piece.areaMm2 * pi * found.emission.rgb;
    area += piece.areaMm2;
  }
  float over = 1.0 / max(area, 1e-30);
  shares[i] = OpaqueShare(over * sum.share, over * sum.through, over * sum.emission);
}
