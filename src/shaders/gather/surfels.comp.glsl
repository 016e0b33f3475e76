// The surfels as they are in this frame: where their sources lie, what area each stands for and the
// flux that enters there.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define SHADOW_BINDING 6
#define BINDING_SKY_IRRADIANCE 7
#define BINDING_PIECES 3
#define BINDING_VERTICES 1
#include "lib/irradiance.glsl"
#include "lib/linear.glsl"
#include "lib/material.glsl"
#include "lib/piece_at.glsl"
#include "lib/source_flux.glsl"
#include "lib/unit.glsl"
#include "lib/vertex_at.glsl"
#include "shared/surfels.h"

layout(std430, set = 0, binding = 8) writeonly buffer Sources { Source sources[]; };
layout(std430, set = 0, binding = 9) writeonly buffer SurfelNormals { vec4 surfelNormals[]; };

layout(std430, set = 0, binding = 10) writeonly buffer SurfelPlaces { vec4 places[]; };

layout(std430, set = 0, binding = 11) buffer Visibilities { uint visibilities[]; };
layout(std430, set = 0, binding = 12) writeonly buffer SkyShares { vec4 skyShares[]; };

#include "lib/piece_place.glsl"

// Some bodies have normal textures.
layout(constant_id = 0) const uint withNormals = 0u;
#define BINDING_TILTS 13
#include "lib/tilted_normal.glsl"

layout(push_constant) uniform Push {
  uint surfelCount;
  uint piecesPerSurfel;
  uint keepsVisibility;  // 1: clusters read it
  uint takesSky;         // 1: all of it; 0: none, which is added where it is known how much is seen
};

void put(uint source, vec3 position, float area, vec3 irradiance) {
  sources[source] = Source(vec4(position, area), vec4(fluxThrough(area, irradiance), 0.0));
}

void keep(float visible, uint light, uint piece, uint point) {
  uint index = visibilityIndex(light, piece, surfelCount * piecesPerSurfel);
  uint before = point == 0u ? 0u : visibilities[index];
  visibilities[index] = before | packVisibility(visible, point);
}

// The normal, as a texture may have it.
vec3 normalOf(uint piece, PiecePlace place, vec2 at) {
  vec3 normal = normalAt(place, at);
  return withNormals == 0u ? normal : tiltedNormal(piece, place.along, place.across, normal);
}

// The unit normal of a piece, on the side that its triangle's corners go around; of a sheet, on the light's.
vec3 keptSideOf(uint piece, PiecePlace place, IncidentLight light) {
  vec3 outside = place.side * unitOr(facetOf(place), vec3(0.0));
  return hasBack(objects[pieceAt(piece).object]) && dot(outside, light.direction) < 0.0 ? -outside : outside;
}

float visibilityOn(vec3 position, vec3 outside, IncidentLight light) {
  return dot(outside, light.direction) > 0.0 ? visibilityOf(light, position, outside) : 0.0;
}

// Visibility in the middle stands for all of a piece's points, since pieces are small against a surfel of several.
void keepVisibility(uint piece) {
  PiecePlace place = placeOf(pieceAt(piece));
  vec3 position = positionAt(place, middleOf(place.corners));
  for (uint k = 0u; k < lightsAt(position); ++k) {
    IncidentLight light = incidentLight(k, position);
    float visible = visibilityOn(position, keptSideOf(piece, place, light), light);
    for (uint i = 0u; i < pointsPerPiece; ++i) keep(visible, k, piece, i);
  }
}

// The irradiance at a point of the piece. It also keeps what is visible of each light there.
vec3 irradianceAndVisibility(uint piece, PiecePlace place, uint point) {
  vec2 at = pointOf(place.corners, point);
  vec3 position = positionAt(place, at);
  vec3 normal = normalOf(piece, place, at);
  vec3 outside = outsideOf(facetOf(place), normal);
  MediumData medium = mediumAt(objects[pieceAt(piece).object], position);
  vec3 sum = vec3(0.0);
  for (uint k = 0u; k < lightsAt(position); ++k) {
    IncidentLight light = incidentLight(k, position);
    float part = enteringPart(light, normal, outside, medium);
    // One call, because a device that executes both sides of every branch would look into the shadow map twice.
    bool enters = part > 0.0 || keepsVisibility == 0u;
    float visible = visibilityOn(position, enters ? outside : keptSideOf(piece, place, light), light);
    if (keepsVisibility != 0u) keep(visible, k, piece, point);
    sum += light.irradiance * (part * visible);
  }
  if (withNormals != 0u) sum *= evenness(piece);
  if (takesSky != 0u) sum += skyIrradianceAt(normal, medium);
  return sum;
}

vec3 irradianceOn(uint piece, PiecePlace place, vec2 at) {
  vec3 position = positionAt(place, at);
  vec3 normal = normalOf(piece, place, at);
  MediumData medium = mediumAt(objects[pieceAt(piece).object], position);
  if (withNormals != 0u) {
    vec3 lights = evenness(piece) * lightsIrradiance(position, normal, outsideOf(facetOf(place), normal), medium);
    return takesSky != 0u ? lights + skyIrradianceAt(normal, medium) : lights;
  }
  return takesSky != 0u ? irradianceAt(position, normal, facetOf(place), medium)
                        : lightsIrradiance(position, normal, outsideOf(facetOf(place), normal), medium);
}

// A varied place, because means over surfels would be off if all were asked at the same place among
// their sources (the points are R₂, Roberts 2018).
vec2 somewhereOn(PiecePlace place, uint surfel) {
  vec2 at = fract(0.5 + float(surfel % 65536u) * vec2(0.7548776662, 0.5698402910));
  if (at.x + at.y > 1.0) at = 1.0 - at;
  return (1.0 - at.x - at.y) * place.corners[0] + at.x * place.corners[1] + at.y * place.corners[2];
}

void gatherPiece(uint surfel) {
  PiecePlace place = placeOf(pieceAt(surfel));
  vec2 middle = middleOf(place.corners);
  for (uint i = 0u; i < sourcesPerSurfel; ++i) {
    put(sourcesPerSurfel * surfel + i, positionAt(place, pointOf(place.corners, i)),
        place.area / float(sourcesPerSurfel), irradianceAndVisibility(surfel, place, i));
  }
  surfelNormals[surfel] = vec4(normalOf(surfel, place, middle), 0.0);
  places[surfel] = vec4(positionAt(place, somewhereOn(place, surfel)), 0.0);
}

// Each source stands for some of the pieces. The largest of these is asked what falls on it.
void gatherPieces(uint surfel) {
  vec3 direction = vec3(0.0);
  vec3 middleOfAll = vec3(0.0);
  float largestOfAll = -1.0;
  for (uint i = 0u; i < sourcesPerSurfel; ++i) {
    uint first = i * piecesPerSurfel / sourcesPerSurfel;
    uint end = (i + 1u) * piecesPerSurfel / sourcesPerSurfel;
    float area = 0.0;
    vec3 byArea = vec3(0.0);
    float largestArea = 0.0;
    uint largest = first;
    vec3 somewhere = positionOf(pieceAt(surfel * piecesPerSurfel).a);
    for (uint k = first; k < end; ++k) {
      SurfelPiece piece = pieceAt(surfel * piecesPerSurfel + k);
      PiecePlace place = placeOf(piece);
      vec2 middle = middleOf(place.corners);
      area += place.area;
      byArea += place.area * positionAt(place, middle);
      direction += place.area * normalOf(surfel * piecesPerSurfel + k, place, middle);
      if (place.area > largestOfAll) {
        largestOfAll = place.area;
        middleOfAll = positionAt(place, middle);
      }
      if (place.area > largestArea) {
        largestArea = place.area;
        largest = k;
      }
    }
    vec3 irradiance = vec3(0.0);
    if (largestArea > 0.0) {
      uint piece = surfel * piecesPerSurfel + largest;
      PiecePlace place = placeOf(pieceAt(piece));
      irradiance = irradianceOn(piece, place, middleOf(place.corners));
    }
    put(sourcesPerSurfel * surfel + i, area > 0.0 ? byArea / area : somewhere, area, irradiance);
  }
  surfelNormals[surfel] = vec4(unitOr(direction, vec3(0.0, 1.0, 0.0)), 0.0);
  places[surfel] = vec4(middleOfAll, 0.0);
  if (keepsVisibility == 0u) return;
  for (uint k = 0u; k < piecesPerSurfel; ++k) keepVisibility(surfel * piecesPerSurfel + k);
}

void main() {
  uint surfel = linearIndex();
  if (surfel >= surfelCount) return;
  skyShares[surfel] = vec4(1.0);
  if (piecesPerSurfel == 1u)
    gatherPiece(surfel);
  else
    gatherPieces(surfel);
}
