// Places on a piece of a surfel, as barycentric coordinates of its triangle's b and c.
#ifndef OPALINE_LIB_PIECE
#define OPALINE_LIB_PIECE
#include "shared/surfels.h"

// Undoes how its numbers are kept, see SurfelPiece.
SurfelPiece withoutSetBits(SurfelPiece piece) {
  piece.a &= ~setBit;
  piece.b &= ~setBit;
  piece.c &= ~setBit;
  piece.object &= ~setBit;
  return piece;
}

mat3x2 cornersOf(SurfelPiece piece) {
  return mat3x2(piece.v0, piece.w0, piece.v1, piece.w1, piece.v2, piece.w2);
}

vec2 middleOf(mat3x2 corners) {
  return (corners[0] + corners[1] + corners[2]) / 3.0;
}

// The three points whose mean is that of any quadratic over the piece (Strang and Fix 1973).
vec2 pointOf(mat3x2 corners, uint i) {
  return 0.5 * (middleOf(corners) + corners[i]);
}

// The visibility of a light at these points is kept in one word, ten bits each.
uint visibilityIndex(uint light, uint piece, uint pieceCount) {
  return light * pieceCount + piece;
}

uint packVisibility(float visible, uint point) {
  return uint(1023.0 * visible + 0.5) << 10u * point;
}

const uint wholeVisibility = 0x3fffffffu;

float unpackVisibility(uint word, uint point) {
  return float(bitfieldExtract(word, int(10u * point), 10)) / 1023.0;
}

float meanVisibility(uint word) {
  float sum = 0.0;
  for (uint i = 0u; i < pointsPerPiece; ++i) sum += unpackVisibility(word, i);
  return sum / float(pointsPerPiece);
}

#endif
