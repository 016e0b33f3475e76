#version 460
// output[i] = input[i] · factor + addend + uniform offset
layout(constant_id = 0) const uint groupSize = 1;
layout(local_size_x_id = 0) in;
layout(constant_id = 1) const uint addend = 0;
layout(push_constant) uniform Push {
  uint factor;
  uint count;
};
layout(binding = 0) readonly buffer Input { uint values[]; };
layout(binding = 1) writeonly buffer Output { uint results[]; };
layout(binding = 2) uniform Offset { uint offset; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i < count) results[i] = values[i] * factor + addend + offset;
}
