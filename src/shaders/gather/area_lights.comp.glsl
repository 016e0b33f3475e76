// Adds the light of area lights to what surfels have gathered, by the visibility that soft_shadows.comp has found.
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

void add(uint source, vec3 irradiance) {
  sources[source].flux.rgb += fluxThrough(sources[source].positionArea.w, irradiance);
}

// Cosine between normals at points of a piece and that in its middle. Above it, light that enters is a vector of
// the middle.
const float leastAgreement = 0.95;

// The irradiance at each of the piece's points.
vec3[pointsPerPiece] irradianceOn(uint piece) {
  PiecePlace place = placeOf(pieceAt(piece));
  vec2 middle = middleOf(place.corners);
  vec3 position = positionAt(place, middle);
  MediumData medium = mediumAt(objects[pieceAt(piece).object], position);
  vec3 facing = normalAt(place, middle);
  if (withNormals != 0u) facing = tiltedNormal(piece, place.along, place.across, facing);
  float even = withNormals != 0u ? evenness(piece) : 1.0;
  vec3 normals[pointsPerPiece];
  vec3 sums[pointsPerPiece];
  bool agree = true;
  for (uint i = 0u; i < pointsPerPiece; ++i) {
    normals[i] = normalAt(place, pointOf(place.corners, i));
    if (withNormals != 0u) normals[i] = tiltedNormal(piece, place.along, place.across, normals[i]);
    sums[i] = vec3(0.0);
    agree = agree && dot(normals[i], facing) > leastAgreement;
  }
  for (uint light = firstAreaLight(); light < allLightsAt(position); ++light) {
    uint word = visibilities[visibilityIndex(light, piece, surfelCount * piecesPerSurfel)];
    AreaView view = areaViewFrom(position, light);
    if (word == 0u || !view.shines) continue;
    vec3 enters = enteringVectorOf(view, facing, medium);
    for (uint i = 0u; i < pointsPerPiece; ++i) {
      if (!agree) enters = enteringVectorOf(view, normals[i], medium);
      sums[i] += even * unpackVisibility(word, i) * max(dot(enters, normals[i]), 0.0) * frame.lights[light].power.rgb;
    }
  }
  return sums;
}

// The piece that surfels.comp asks.
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
  if (piecesPerSurfel == 1u) {
    vec3 found[pointsPerPiece] = irradianceOn(surfel);
    for (uint i = 0u; i < sourcesPerSurfel; ++i) add(sourcesPerSurfel * surfel + i, found[i]);
    return;
  }
  for (uint i = 0u; i < sourcesPerSurfel; ++i) {
    uint first = surfel * piecesPerSurfel + i * piecesPerSurfel / sourcesPerSurfel;
    uint end = surfel * piecesPerSurfel + (i + 1u) * piecesPerSurfel / sourcesPerSurfel;
    uint piece = largestPiece(first, end);
    if (piece == end) continue;
    vec3 found[pointsPerPiece] = irradianceOn(piece);
    vec3 sum = vec3(0.0);
    for (uint k = 0u; k < pointsPerPiece; ++k) sum += found[k];
    add(sourcesPerSurfel * surfel + i, sum / float(pointsPerPiece));
  }
}
