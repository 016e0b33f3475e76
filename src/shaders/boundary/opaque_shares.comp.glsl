// What clusters of opaque bodies give back of light, and what they send out by themselves: means of
// their materials over their pieces.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_OPAQUES 4
#define BINDING_TEXELS 7
#include "lib/linear.glsl"
#include "lib/material.glsl"
#include "lib/opaque_material.glsl"
#include "lib/pi.glsl"
#include "shared/boundary.h"
#include "shared/surfels.h"

layout(std430, set = 0, binding = 2) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 3) readonly buffer Pieces { SurfelPiece pieces[]; };
layout(std430, set = 0, binding = 8) writeonly buffer Shares { OpaqueShare shares[]; };

layout(push_constant) uniform Push {
  uint clusterCount;
  uint piecesPerSurfel;
};

// Seen as large as it is, so that the texture is its mean.
MaterialPlace placeOfPiece(SurfelPiece piece) {
  vec3 corner0 = vec3(1.0 - piece.v0 - piece.w0, piece.v0, piece.w0);
  vec3 corner1 = vec3(1.0 - piece.v1 - piece.w1, piece.v1, piece.w1);
  vec3 corner2 = vec3(1.0 - piece.v2 - piece.w2, piece.v2, piece.w2);
  return materialPlaceOn(uvec3(piece.a, piece.b, piece.c), (corner0 + corner1 + corner2) / 3.0,
                         0.5 * (corner1 - corner0), 0.5 * (corner2 - corner0));
}

// Mean over the hemisphere of Schlick's reflectance, for light from everywhere.
vec3 mirrored(vec4 specular) {
  return specular.rgb + (vec3(specular.w) - specular.rgb) / 21.0;
}

void main() {
  uint i = linearIndex();
  if (i >= clusterCount) return;
  ClusterRange range = ranges[i];
  OpaqueShare sum = OpaqueShare(vec4(0.0), vec4(0.0));
  uint end = range.kind == opaqueBody ? range.endSurfel * piecesPerSurfel : 0u;
  OpaqueData material = opaques[mediumAt(objects[range.object], vec3(0.0)).tables.y];
  float count = 0.0;
  for (uint k = range.firstSurfel * piecesPerSurfel; k < end; ++k) {
    SurfelPiece piece = pieces[k];
    if (piece.fraction <= 0.0) continue;
    MaterialPlace place = plainPlace();
    if (material.rest.z != 0.0) place = placeOfPiece(piece);
    SeenMaterial found = materialAt(material, place);
    vec3 reflected = clamp(mirrored(found.specular), 0.0, 1.0);
    sum.share.rgb += reflected + (1.0 - reflected) * found.diffuse.rgb;
    sum.emission.rgb += pi * found.emission.rgb;
    count += 1.0;
  }
  shares[i] = OpaqueShare(sum.share / max(count, 1.0), sum.emission / max(count, 1.0));
}
