#version 460
// Reads each face of each cube along its axis, in Vulkan's order +x -x +y -y +z -z.
layout(local_size_x = 1) in;
layout(binding = 0) uniform samplerCubeArray cubes;
layout(binding = 1) writeonly buffer Output { float results[]; };

void main() {
  const vec3 axes[6] = vec3[](vec3(1, 0, 0), vec3(-1, 0, 0), vec3(0, 1, 0), vec3(0, -1, 0),
                              vec3(0, 0, 1), vec3(0, 0, -1));
  uint face = gl_GlobalInvocationID.x;
  uint cube = gl_GlobalInvocationID.y;
  results[cube * 6 + face] = textureLod(cubes, vec4(axes[face], cube), 0.0).x;
}
