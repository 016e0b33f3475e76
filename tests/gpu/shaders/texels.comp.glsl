#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/texels.glsl"
// Turns an array of four floats each around and adds one to the first of each.
layout(local_size_x = 64) in;
layout(push_constant) uniform Push { uint count; };
TEXELS(2, values);
layout(binding = 5) writeonly buffer Output { vec4 results[]; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  vec4 value = texelOf(values, int(count - 1u - i));
  results[i] = value + vec4(1.0, 0.0, 0.0, 0.0);
}
