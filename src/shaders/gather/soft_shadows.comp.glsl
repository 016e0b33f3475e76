// What is visible of an area light from each piece of a surfel. Where the first few rays of a piece agree,
// they are enough.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define BINDING_PIECE_CORNERS 6
#define BINDING_RAYS 7
#include "lib/frame.glsl"
#include "lib/area_shadow.glsl"
#include "lib/linear.glsl"
#include "lib/material.glsl"

layout(std430, set = 0, binding = 1) readonly buffer Positions { vec4 positions[]; };
layout(std430, set = 0, binding = 2) readonly buffer Normals { vec4 normals[]; };
layout(std430, set = 0, binding = 3) readonly buffer Pieces { SurfelPiece pieces[]; };
layout(std430, set = 0, binding = 8) writeonly buffer Visibilities { uint visibilities[]; };

#include "lib/piece_place.glsl"

layout(push_constant) uniform Push {
  uint pieceCount;
  uint piecesPerSurfel;
  uint nodeCount;  // of all surfels' trees
  uint light;
};

const uint fewRays = 4u;
const uint mostRays = 16u;

uint firstPieceOf(uint object) {
  return objects[object].table.y * piecesPerSurfel;
}

// Places on the light form a lattice that the points of a piece share, shifted for each piece: scattering then
// takes the mean over neighbours.
void sendRays(uint first, uint end, Receiver receiver, uint piece, uint point, inout Share share) {
  vec2 shift = fract(float(piece % 8192u) * vec2(0.8191725134, 0.6710436067));
  AreaView view = areaViewFrom(receiver.position, light);
  if (!view.shines) return;
  for (uint i = first; i < end; ++i)
    sendRay(view, receiver, fract(shift + latticePlace(pointsPerPiece * i + point)), nodeCount, share);
}

void main() {
  uint piece = linearIndex();
  if (piece >= pieceCount) return;
  PiecePlace place = placeOf(pieces[piece]);
  vec3 outside = place.side * unitOr(facetOf(place), vec3(0.0));
  ObjectData body = objects[pieces[piece].object];
  Receiver receivers[pointsPerPiece];
  Share shares[pointsPerPiece];
  float all = 0.0;
  float visible = 0.0;
  for (uint i = 0u; i < pointsPerPiece; ++i) {
    vec3 position = positionAt(place, pointOf(place.corners, i));
    receivers[i] = Receiver(position, outside, outside, mediumAt(body, position).boundary.x);
    shares[i] = Share(0.0, 0.0);
    sendRays(0u, fewRays, receivers[i], piece, i, shares[i]);
    all += shares[i].all;
    visible += shares[i].visible;
  }
  bool agreed = visible == all || visible == 0.0;
  uint word = 0u;
  for (uint i = 0u; i < pointsPerPiece; ++i) {
    if (!agreed) sendRays(fewRays, mostRays, receivers[i], piece, i, shares[i]);
    if (shares[i].all > 0.0) word |= packVisibility(shares[i].visible / shares[i].all, i);
  }
  visibilities[visibilityIndex(light, piece, pieceCount)] = word;
}
