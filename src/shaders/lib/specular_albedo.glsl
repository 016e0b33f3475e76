// How much of even light the surface mirrors, by the cosine of the view.
#ifndef OPALINE_LIB_SPECULAR_ALBEDO
#define OPALINE_LIB_SPECULAR_ALBEDO
#include "shared/medium.h"
#include "shared/opaque.h"

layout(std430, set = 0, binding = 8) readonly buffer SpecularAlbedo { float specularAlbedo[]; };

const uint albedoEntries = 64u;

float albedoFrom(uint row, float cosine) {
  float place = cosine * float(albedoEntries) - 0.5;
  float lower = clamp(floor(place), 0.0, float(albedoEntries - 2u));
  uint first = row + uint(lower);
  return mix(specularAlbedo[first], specularAlbedo[first + 1u], clamp(place - lower, 0.0, 1.0));
}

float reflectedAlbedo(MediumData medium, float cosine) {
  return albedoFrom(medium.tables.w, cosine);
}

// For a surface with its own roughness² = alpha. Beyond the last row, half a step before 1, the table goes on straight.
float reflectedAlbedo(MediumData medium, float alpha, float cosine) {
  float place = max(sqrt(alpha) * float(albedoRows) - 0.5, 0.0);
  uint lower = min(uint(place), albedoRows - 2u);
  uint row = medium.surface.y + lower * albedoEntries;
  return mix(albedoFrom(row, cosine), albedoFrom(row + albedoEntries, cosine), place - float(lower));
}

#endif
