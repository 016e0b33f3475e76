// Pieces of surfels, read as texels: Mesa's software device reads storage word by word. Needs BINDING_PIECES.
#ifndef OPALINE_LIB_PIECE_AT
#define OPALINE_LIB_PIECE_AT
#include "lib/piece.glsl"
#include "lib/texels.glsl"

TEXELS(BINDING_PIECES, pieces);  // SurfelPiece

SurfelPiece pieceAt(uint index) {
  vec4 whole = texelOf(pieces, 3 * int(index));
  vec4 corners = texelOf(pieces, 3 * int(index) + 1);
  vec4 rest = texelOf(pieces, 3 * int(index) + 2);
  uvec4 numbers = floatBitsToUint(whole);
  return withoutSetBits(SurfelPiece(numbers.x, numbers.y, numbers.z, numbers.w, corners.x, corners.y, corners.z,
                                    corners.w, rest.x, rest.y, rest.z, rest.w));
}

#endif
