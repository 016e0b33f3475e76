#version 460
// Reads the middle of each layer at each level.
layout(local_size_x = 1) in;
layout(binding = 0) uniform sampler2DArray image;
layout(binding = 1) writeonly buffer Output { vec4 results[]; };

void main() {
  uint layer = gl_GlobalInvocationID.x;
  uint level = gl_GlobalInvocationID.y;
  results[level * gl_NumWorkGroups.x + layer] =
      textureLod(image, vec3(0.5, 0.5, layer), float(level));
}
