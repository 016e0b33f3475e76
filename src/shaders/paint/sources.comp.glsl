// Keeps of the light that surfels have gathered what gets through the paint.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/linear.glsl"
#include "lib/source_flux.glsl"
#include "shared/surfels.h"

layout(std430, set = 0, binding = 0) readonly buffer Through { vec4 through[]; };
layout(std430, set = 0, binding = 1) buffer Sources { Source sources[]; };

layout(push_constant) uniform Push {
  uint surfelCount;
};

void main() {
  uint i = linearIndex();
  if (i >= surfelCount) return;
  for (uint s = sourcesPerSurfel * i; s < sourcesPerSurfel * (i + 1u); ++s)
    sources[s].flux.rgb = fluxThrough(1.0, through[i].rgb * sources[s].flux.rgb);
}
