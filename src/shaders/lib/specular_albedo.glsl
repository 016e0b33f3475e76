// How much of even light the surface mirrors, by the cosine of the view.
#ifndef OPALINE_LIB_SPECULAR_ALBEDO
#define OPALINE_LIB_SPECULAR_ALBEDO
#include "shared/medium.h"

layout(std430, set = 0, binding = 8) readonly buffer SpecularAlbedo { float specularAlbedo[]; };

const uint albedoEntries = 64u;

float reflectedAlbedo(MediumData medium, float cosine) {
  float place = cosine * float(albedoEntries) - 0.5;
  float lower = clamp(floor(place), 0.0, float(albedoEntries - 2u));
  uint first = medium.tables.w + uint(lower);
  return mix(specularAlbedo[first], specularAlbedo[first + 1u], clamp(place - lower, 0.0, 1.0));
}

#endif
