#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/linear.glsl"
// Counts how often each invocation has run.
layout(push_constant) uniform Push { uint count; };
layout(binding = 0) buffer Output { uint runs[]; };

void main() {
  uint i = linearIndex();
  if (i < count) ++runs[i];
}
