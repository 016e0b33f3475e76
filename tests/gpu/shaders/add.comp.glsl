#version 460
// Turns the array around and adds one: each invocation reads what another one wrote before.
layout(local_size_x = 64) in;
layout(push_constant) uniform Push { uint count; };
layout(binding = 0) readonly buffer Input { uint values[]; };
layout(binding = 3) writeonly buffer Output { uint results[]; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i < count) results[i] = values[count - 1 - i] + 1;
}
