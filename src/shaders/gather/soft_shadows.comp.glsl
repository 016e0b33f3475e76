// What is visible of an area light from each piece of a surfel. Where the first rays of pieces that follow each other,
// which lie close together, agree, they are enough.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define BINDING_PIECE_CORNERS 6
#define BINDING_RAYS 7
#define BINDING_PIECES 3
#define BINDING_VERTICES 1
#include "lib/frame.glsl"
#include "lib/area_shadow.glsl"
#include "lib/lattice.glsl"
#include "lib/linear.glsl"
#include "lib/material.glsl"
#include "lib/piece_at.glsl"
#include "lib/vertex_at.glsl"

layout(std430, set = 0, binding = 8) writeonly buffer Visibilities { uint visibilities[]; };

#include "lib/piece_place.glsl"

layout(push_constant) uniform Push {
  uint pieceCount;
  uint piecesPerSurfel;
  uint nodeCount;  // of all surfels' trees
  uint light;
};

const uint raysOfPoint = 16u;
const uint neighbours = 16u;

// Of neighbours, whether some place sees the light, and whether some does not.
const uint someSee = 1u;
const uint someDoNot = 2u;
shared uint found[gl_WorkGroupSize.x / neighbours];

uint firstPieceOf(uint object) {
  return objects[object].table.y * piecesPerSurfel;
}

Receiver receiverAt(PiecePlace place, ObjectData body, uint point) {
  vec3 position = positionAt(place, pointOf(place.corners, point));
  vec3 outside = place.side * unitOr(facetOf(place), vec3(0.0));
  // Of a sheet the side that the light is on.
  if (hasBack(body) && dot(outside, frame.lights[light].place.xyz - position) < 0.0) outside = -outside;
  return Receiver(position, outside, outside, mediumAt(body, position).boundary.x);
}

uint askFirst(Receiver receiver, uint piece, uint point) {
  AreaView view = areaViewFrom(receiver.position, light);
  if (!view.shines) return 0u;
  uint i = pointsPerPiece * piece + point;
  Share share = Share(0.0, 0.0);
  sendRay(view, receiver, firstPlace(view, i % 16u, i / 16u % 4u), nodeCount, share);
  if (share.all <= 0.0) return 0u;
  return share.visible > 0.0 ? someSee : someDoNot;
}

// Places on the light form a lattice that the points of a piece share, shifted for each piece: scattering then
// takes the mean over neighbours.
float visiblePart(Receiver receiver, uint piece, uint point) {
  vec2 shift = fract(float(piece % 8192u) * vec2(0.8191725134, 0.6710436067));
  AreaView view = areaViewFrom(receiver.position, light);
  if (!view.shines) return 0.0;
  Share share = Share(0.0, 0.0);
  for (uint i = 0u; i < raysOfPoint; ++i)
    sendRay(view, receiver, fract(shift + latticePlace(pointsPerPiece * i + point)), nodeCount, share);
  return share.all > 0.0 ? share.visible / share.all : 0.0;
}

void main() {
  uint piece = linearIndex();
  bool there = piece < pieceCount;
  uint own = gl_LocalInvocationIndex / neighbours;
  if (gl_LocalInvocationIndex % neighbours == 0u) found[own] = 0u;
  barrier();
  PiecePlace place = placeOf(pieceAt(there ? piece : 0u));
  ObjectData body = objects[pieceAt(there ? piece : 0u).object];
  uint first = 0u;
  for (uint i = 0u; there && i < pointsPerPiece; ++i) first |= askFirst(receiverAt(place, body, i), piece, i);
  atomicOr(found[own], first);
  barrier();
  uint word = 0u;
  for (uint i = 0u; there && i < pointsPerPiece; ++i) {
    float part = found[own] == someSee ? 1.0 : 0.0;
    if (found[own] == (someSee | someDoNot)) part = visiblePart(receiverAt(place, body, i), piece, i);
    word |= packVisibility(part, i);
  }
  if (there) visibilities[visibilityIndex(light, piece, pieceCount)] = word;
}
