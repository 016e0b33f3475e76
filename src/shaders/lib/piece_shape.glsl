// A piece of a surfel as it lies in this frame. Needs buffers `positions` and `normals` of vertices.
#ifndef OPALINE_LIB_PIECE_SHAPE
#define OPALINE_LIB_PIECE_SHAPE
#include "lib/piece.glsl"

struct PieceShape {
  vec3 corners[3];
  vec3 vectorArea;  // outwards
  float area;
  mat3 itsNormals;  // at the triangle's corners
  mat3x2 places;    // of the piece's corners, see lib/piece.glsl
  vec3 along;       // edges of the triangle
  vec3 across;
};

// ClusterRange::side of the cluster.
float facing = 1.0;

PieceShape shapeOf(SurfelPiece piece) {
  PieceShape shape;
  vec3 origin = positionOf(piece.a);
  vec3 along = positionOf(piece.b) - origin;
  vec3 across = positionOf(piece.c) - origin;
  shape.places = cornersOf(piece);
  for (int i = 0; i < 3; ++i)
    shape.corners[i] = origin + shape.places[i].x * along + shape.places[i].y * across;
  vec4 a = normalOf(piece.a);
  shape.vectorArea = facing * a.w * 0.5 * max(piece.fraction, 0.0) * cross(along, across);
  shape.area = length(shape.vectorArea);
  shape.along = along;
  shape.across = across;
  shape.itsNormals = facing * mat3(a.xyz, normalOf(piece.b).xyz, normalOf(piece.c).xyz);
  return shape;
}

vec3 middleOf(PieceShape shape) {
  return (shape.corners[0] + shape.corners[1] + shape.corners[2]) / 3.0;
}

#endif
