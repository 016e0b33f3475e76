// What is visible of an area light from each piece of a surfel: rays to places on it, weighted by the
// light that would come from there (Heitz, Hill and McGuire 2018). Where the first few of a piece agree,
// they are enough.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define BINDING_PIECE_CORNERS 6
#define BINDING_RAYS 7
#include "lib/frame.glsl"
#include "lib/area_light.glsl"
#include "lib/linear.glsl"
#include "lib/material.glsl"
#include "lib/rays.glsl"

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

struct Facet {
  vec3 position;
  vec3 outside;  // unit
  MediumData medium;
};

// What the rays of a point have found: light that would come, and that comes.
struct Share {
  float all;
  float visible;
};

// Places on the light form a lattice of low discrepancy (Roberts 2018) that the points of a piece
// share, shifted for each piece: scattering then takes the mean over neighbours.
void sendRays(uint first, uint end, Facet facet, uint piece, uint point, inout Share share) {
  const vec2 next = vec2(0.7548776662, 0.5698402910);
  vec2 shift = fract(float(piece % 8192u) * vec2(0.8191725134, 0.6710436067));
  AreaView view = areaViewFrom(facet.position, light);
  if (!view.shines) return;
  float start = startAbove(facet.position);
  vec3 origin = facet.position + start * facet.outside;
  for (uint i = first; i < end; ++i) {
    AreaSample place = sampleOf(view, fract(shift + float(pointsPerPiece * i + point) * next));
    float squared = dot(place.offset, place.offset);
    float cosine = dot(place.offset, facet.outside) * inversesqrt(max(squared, 1e-30));
    if (cosine <= 0.0) continue;
    float weight = place.weight * cosine *
                   (1.0 - fresnelReflectance(facet.medium.boundary.x, min(cosine, 1.0)));
    share.all += weight;
    float least = start * inversesqrt(max(squared, 1e-30));
    if (!occluded(origin, place.offset, least, 1.0, RayTarget(0u, nodeCount, everyObject)))
      share.visible += weight;
  }
}

void main() {
  uint piece = linearIndex();
  if (piece >= pieceCount) return;
  PiecePlace place = placeOf(pieces[piece]);
  vec3 outside = place.side * unitOr(facetOf(place), vec3(0.0));
  ObjectData body = objects[pieces[piece].object];
  Facet facets[pointsPerPiece];
  Share shares[pointsPerPiece];
  float all = 0.0;
  float visible = 0.0;
  for (uint i = 0u; i < pointsPerPiece; ++i) {
    vec3 position = positionAt(place, pointOf(place.corners, i));
    facets[i] = Facet(position, outside, mediumAt(body, position));
    shares[i] = Share(0.0, 0.0);
    sendRays(0u, fewRays, facets[i], piece, i, shares[i]);
    all += shares[i].all;
    visible += shares[i].visible;
  }
  bool agreed = visible == all || visible == 0.0;
  uint word = 0u;
  for (uint i = 0u; i < pointsPerPiece; ++i) {
    if (!agreed) sendRays(fewRays, mostRays, facets[i], piece, i, shares[i]);
    if (shares[i].all > 0.0) word |= packVisibility(shares[i].visible / shares[i].all, i);
  }
  visibilities[visibilityIndex(light, piece, pieceCount)] = word;
}
