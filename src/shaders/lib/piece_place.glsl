// Pieces of surfels where they lie in this frame. Needs, before it, buffers of the mesh's vertices,
// `positions` and `normals`.
#ifndef OPALINE_LIB_PIECE_PLACE
#define OPALINE_LIB_PIECE_PLACE
#include "lib/piece.glsl"
#include "lib/unit.glsl"

struct PiecePlace {
  vec3 origin;  // mm, of the triangle
  vec3 along;
  vec3 across;
  mat3 itsNormals;  // at the triangle's corners
  float side;       // -1 where the body is mirrored
  mat3x2 corners;   // see lib/piece.glsl
  float area;       // mm²
};

PiecePlace placeOf(SurfelPiece piece) {
  PiecePlace place;
  place.origin = positionOf(piece.a);
  place.along = positionOf(piece.b) - place.origin;
  place.across = positionOf(piece.c) - place.origin;
  place.itsNormals = mat3(normalOf(piece.a).xyz, normalOf(piece.b).xyz, normalOf(piece.c).xyz);
  place.side = normalOf(piece.a).w;
  place.corners = cornersOf(piece);
  place.area = 0.5 * length(cross(place.along, place.across)) * max(piece.fraction, 0.0);
  return place;
}

vec3 positionAt(PiecePlace place, vec2 at) {
  return place.origin + at.x * place.along + at.y * place.across;
}

vec3 normalAt(PiecePlace place, vec2 at) {
  return unitOr(place.itsNormals * vec3(1.0 - at.x - at.y, at), vec3(0.0, 1.0, 0.0));
}

vec3 facetOf(PiecePlace place) {
  return cross(place.along, place.across);
}

#endif
