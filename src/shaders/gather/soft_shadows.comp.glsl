// How much of an area light is visible from each piece of a surfel. Pieces that follow each other lie close together.
// Where their first rays agree, these are enough. Elsewhere some more are, if what they find changes evenly over the
// pieces; many more are sent where it does not.
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

const uint neighbours = 16u;

// Rays of a point.
const uint someRays = 3u;
const uint manyRays = 6u;

// Whether some place of the neighbours sees the light, and whether some does not.
const uint someSee = 1u;
const uint someDoNot = 2u;
shared uint found[gl_WorkGroupSize.x / neighbours];

// The middle of a piece, mm, and the part of the light that some rays have found there; below 0 where no light would
// come.
shared vec4 parts[gl_WorkGroupSize.x];
const vec4 noPart = vec4(0.0, 0.0, 0.0, -1.0);

uint firstPieceOf(uint object) {
  return objects[object].table.y * piecesPerSurfel;
}

Receiver receiverAt(PiecePlace place, ObjectData body, uint point) {
  vec3 position = positionAt(place, pointOf(place.corners, point));
  vec3 outside = place.side * unitOr(facetOf(place), vec3(0.0));
  // On a sheet, the side that the light is on.
  if (hasBack(body) && dot(outside, frame.lights[light].place.xyz - position) < 0.0) outside = -outside;
  return Receiver(position, outside, outside, mediumAt(body, position).boundary.x);
}

uint askFirst(Receiver receiver, uint piece) {
  AreaView view = areaViewFrom(receiver.position, light);
  if (!view.shines) return 0u;
  Share share = Share(0.0, 0.0);
  sendRay(view, receiver, firstPlace(view, piece % 16u, piece / 16u % 4u), nodeCount, share);
  if (share.all <= 0.0) return 0u;
  return share.visible > 0.0 ? someSee : someDoNot;
}

// Places on the light form a lattice that the points of a piece share, shifted for each piece; scattering then
// takes the mean over neighbours. Tests a point's places from `begin` to `end`.
void sendRays(Receiver receiver, uint piece, uint point, uint begin, uint end, inout Share share) {
  vec2 shift = fract(float(piece % 8192u) * vec2(0.8191725134, 0.6710436067));
  AreaView view = areaViewFrom(receiver.position, light);
  for (uint i = begin; view.shines && i < end; ++i)
    sendRay(view, receiver, fract(shift + latticePlace(pointsPerPiece * i + point)), nodeCount, share);
}

// The visible part around neighbours, taken to change evenly from one to another.
struct Slope {
  vec3 middle;  // mm
  float part;   // there
  vec3 gradient;
  float variance;  // of what pieces have found
};

// By least squares. Neighbours may lie in a plane, or close to a line; the slope is none across that.
Slope slopeOf(uint first) {
  const float leastSpread = 0.01;
  Slope slope = Slope(vec3(0.0), 0.0, vec3(0.0), 0.0);
  float count = 0.0;
  for (uint k = first; k < first + neighbours; ++k) {
    if (parts[k].w < 0.0) continue;
    count += 1.0;
    slope.middle += parts[k].xyz;
    slope.part += parts[k].w;
  }
  if (count == 0.0) return slope;
  slope.middle /= count;
  slope.part /= count;
  mat3 squares = mat3(0.0);
  vec3 changes = vec3(0.0);
  for (uint k = first; k < first + neighbours; ++k) {
    if (parts[k].w < 0.0) continue;
    vec3 offset = parts[k].xyz - slope.middle;
    squares += outerProduct(offset, offset);
    changes += (parts[k].w - slope.part) * offset;
  }
  float spread = squares[0][0] + squares[1][1] + squares[2][2];
  if (spread > 0.0) slope.gradient = inverse(squares / spread + mat3(leastSpread)) * (changes / spread);
  for (uint k = first; k < first + neighbours; ++k) {
    if (parts[k].w < 0.0) continue;
    float apart = parts[k].w - slope.part - dot(slope.gradient, parts[k].xyz - slope.middle);
    slope.variance += apart * apart;
  }
  slope.variance /= max(count - 3.0, 1.0);
  return slope;
}

float partAt(Slope slope, vec3 place) {
  return clamp(slope.part + dot(slope.gradient, place - slope.middle), 0.0, 1.0);
}

// Whether pieces differ from the slope by no more than so few rays do. n rays of the lattice have a
// variance of p (1 - p) / 3n behind a straight edge, and find no part smaller than 1/n.
bool isEven(Slope slope) {
  const float rays = float(pointsPerPiece * someRays);
  float expected = slope.part * (1.0 - slope.part) / (3.0 * rays) + 0.025 / (rays * rays);
  return slope.variance <= 2.5 * expected;
}

void main() {
  uint piece = linearIndex();
  bool there = piece < pieceCount;
  uint i = gl_LocalInvocationIndex;
  uint own = i / neighbours;
  if (i % neighbours == 0u) found[own] = 0u;
  parts[i] = noPart;
  barrier();
  PiecePlace place = placeOf(pieceAt(there ? piece : 0u));
  ObjectData body = objects[pieceAt(there ? piece : 0u).object];
  if (there) atomicOr(found[own], askFirst(receiverAt(place, body, 0u), piece));
  barrier();
  bool differ = there && found[own] == (someSee | someDoNot);
  Share shares[pointsPerPiece];
  Share all = Share(0.0, 0.0);
  for (uint p = 0u; p < pointsPerPiece; ++p) {
    shares[p] = Share(0.0, 0.0);
    if (!differ) continue;
    sendRays(receiverAt(place, body, p), piece, p, 0u, someRays, shares[p]);
    all = Share(all.all + shares[p].all, all.visible + shares[p].visible);
  }
  if (all.all > 0.0) parts[i] = vec4(positionAt(place, middleOf(place.corners)), all.visible / all.all);
  barrier();
  uint word = found[own] == someSee ? wholeVisibility : 0u;
  if (differ) {
    word = 0u;
    Slope slope = slopeOf(own * neighbours);
    bool even = isEven(slope);
    for (uint p = 0u; p < pointsPerPiece; ++p) {
      float part = partAt(slope, positionAt(place, pointOf(place.corners, p)));
      if (!even) {
        sendRays(receiverAt(place, body, p), piece, p, someRays, manyRays, shares[p]);
        part = shares[p].all > 0.0 ? shares[p].visible / shares[p].all : 0.0;
      }
      word |= packVisibility(part, p);
    }
  }
  if (there) visibilities[visibilityIndex(light, piece, pieceCount)] = word;
}
