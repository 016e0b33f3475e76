// The near block of the paper's pattern. Needs, before it, BINDING_PATTERN, BINDING_POSITION,
// BINDING_FLUX and what lib/scatter.glsl needs.
#ifndef OPALINE_LIB_PATTERN_SUM
#define OPALINE_LIB_PATTERN_SUM
#include "lib/scatter.glsl"
#include "paper/shaders/shared/pattern.h"

layout(std140, set = 0, binding = BINDING_PATTERN) uniform Pattern {
  PatternHead head;
  PatternEntry entries[maxPatternEntries];
} pattern;
layout(set = 0, binding = BINDING_POSITION) uniform sampler2D nearPosition;  // mm; 1 on surface
layout(set = 0, binding = BINDING_FLUX) uniform sampler2D nearFlux;          // E·A; A

// Counts the cell in the middle too, whose mean is tabulated.
uint nearEvaluations() {
  return pattern.head.nearSamples + 1u;
}

// The near block around a place among the neighbourhoods (Gong et al. 2008, section 4.1), each sample
// weighted by the texels it stands for (section 4.2). The cell at the centre, where the profile is
// sharpest, is integrated rather than sampled. The square of a sample's distance grows by that of the
// extent of its piece of surface: a sample that comes close in space, where the surface folds, must
// not outshine the centre. The pattern is that of the medium, the same for all invocations.
vec3 nearSum(vec3 position, MediumData medium, vec2 place) {
  ivec2 centre = ivec2(place * vec2(textureSize(nearPosition, 0)));

  vec4 cell = pattern.entries[0].value;
  vec4 flux = textureLod(nearFlux, place, 0.0);
  float present = textureLod(nearPosition, place, 0.0).a;
  float stretch = flux.a / (max(present, 1e-6) * cell.a);
  vec3 atCentre = flux.rgb / max(flux.a, 1e-20) * cell.rgb *
                  pow(vec3(stretch), pattern.entries[1].value.rgb);

  vec3 sum = vec3(0.0);
  uint end = 2u + pattern.head.nearSamples;
  for (uint i = 2u; i < end; ++i) {
    vec4 entry = pattern.entries[i].value;
    int packed = floatBitsToInt(entry.a);
    ivec2 texel = centre + ivec2(bitfieldExtract(packed, 0, 16), packed >> 16);
    vec3 offset = texelFetch(nearPosition, texel, 0).xyz - position;
    sum += texelFetch(nearFlux, texel, 0).rgb *
           reflectanceProfile(medium.profile, dot(offset, offset) * entry.rgb + pattern.head.nearSquareMm2);
  }
  return atCentre + sum * pattern.entries[1].value.a;
}

#endif
