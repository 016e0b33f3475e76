// The engine's own motion: computes the vertices of this frame.
#version 460

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Rest { float rest[]; };            // x y z, mm
layout(std430, binding = 1) writeonly buffer Positions { float positions[]; };

layout(push_constant) uniform Push {
  uint vertices;
  float seconds;
};

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= vertices) return;
  vec3 p = vec3(rest[3 * i], rest[3 * i + 1], rest[3 * i + 2]);
  p.xz *= 1.0 + 0.18 * sin(0.25 * p.y + 5.0 * seconds);
  for (int axis = 0; axis < 3; ++axis) positions[3 * i + axis] = p[axis];
}
