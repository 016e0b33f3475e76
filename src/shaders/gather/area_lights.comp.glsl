// Adds to what surfels have gathered the light of area lights, of which is visible what
// soft_shadows.comp has found.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define BINDING_PIECES 3
#define BINDING_VERTICES 1
#include "lib/frame.glsl"
#include "lib/area_light.glsl"
#include "lib/linear.glsl"
#include "lib/material.glsl"
#include "lib/piece_at.glsl"
#include "lib/source_flux.glsl"
#include "lib/vertex_at.glsl"
#include "shared/surfels.h"

layout(std430, set = 0, binding = 6) readonly buffer Visibilities { uint visibilities[]; };
layout(std430, set = 0, binding = 7) buffer Sources { Source sources[]; };

#include "lib/piece_place.glsl"

// Some bodies have normal textures.
layout(constant_id = 0) const uint withNormals = 0u;
#define BINDING_TILTS 8
#include "lib/tilted_normal.glsl"

layout(push_constant) uniform Push {
  uint surfelCount;
  uint piecesPerSurfel;
};

float visibleAt(uint light, uint piece, uint point) {
  return unpackVisibility(
      visibilities[visibilityIndex(light, piece, surfelCount * piecesPerSurfel)], point);
}

void add(uint source, vec3 irradiance) {
  sources[source].flux.rgb += fluxThrough(sources[source].positionArea.w, irradiance);
}

// At one of the piece's points, or its middle, where the mean of them is visible.
const uint middlePoint = pointsPerPiece;

vec3 irradianceOn(uint piece, uint point) {
  PiecePlace place = placeOf(pieceAt(piece));
  vec2 at = point == middlePoint ? middleOf(place.corners) : pointOf(place.corners, point);
  vec3 position = positionAt(place, at);
  vec3 normal = normalAt(place, at);
  if (withNormals != 0u) normal = tiltedNormal(piece, place.along, place.across, normal);
  MediumData medium = mediumAt(objects[pieceAt(piece).object], position);
  vec3 sum = vec3(0.0);
  for (uint light = firstAreaLight(); light < allLightsAt(position); ++light) {
    float visible = 0.0;
    for (uint i = 0u; i < pointsPerPiece; ++i)
      if (point == i || point == middlePoint) visible += visibleAt(light, piece, i);
    if (point == middlePoint) visible /= float(pointsPerPiece);
    if (visible > 0.0) sum += visible * areaEntering(light, position, normal, medium);
  }
  return withNormals != 0u ? evenness(piece) * sum : sum;
}

// The one that surfels.comp asks.
uint largestPiece(uint first, uint end) {
  uint largest = end;
  float area = 0.0;
  for (uint k = first; k < end; ++k) {
    float its = placeOf(pieceAt(k)).area;
    if (its > area) {
      area = its;
      largest = k;
    }
  }
  return largest;
}

void main() {
  uint surfel = linearIndex();
  if (surfel >= surfelCount) return;
  for (uint i = 0u; i < sourcesPerSurfel; ++i) {
    uint source = sourcesPerSurfel * surfel + i;
    if (piecesPerSurfel == 1u) {
      add(source, irradianceOn(surfel, i));
      continue;
    }
    uint first = surfel * piecesPerSurfel + i * piecesPerSurfel / sourcesPerSurfel;
    uint end = surfel * piecesPerSurfel + (i + 1u) * piecesPerSurfel / sourcesPerSurfel;
    uint piece = largestPiece(first, end);
    if (piece < end) add(source, irradianceOn(piece, middlePoint));
  }
}
