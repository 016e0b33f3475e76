// Where a piece of a surfel reads its textures. Needs what lib/opaque_material.glsl needs.
#ifndef OPALINE_LIB_PIECE_MATERIAL
#define OPALINE_LIB_PIECE_MATERIAL
#include "lib/opaque_material.glsl"
#include "shared/surfels.h"

// It is read over its own size, so that the texture gives its mean.
MaterialPlace placeOfPiece(SurfelPiece piece, OpaqueData material) {
  if (material.rest.z == 0.0) return plainPlace();
  vec3 corner0 = vec3(1.0 - piece.v0 - piece.w0, piece.v0, piece.w0);
  vec3 corner1 = vec3(1.0 - piece.v1 - piece.w1, piece.v1, piece.w1);
  vec3 corner2 = vec3(1.0 - piece.v2 - piece.w2, piece.v2, piece.w2);
  return materialPlaceOn(uvec3(piece.a, piece.b, piece.c), (corner0 + corner1 + corner2) / 3.0,
                         0.5 * (corner1 - corner0), 0.5 * (corner2 - corner0));
}

#endif
