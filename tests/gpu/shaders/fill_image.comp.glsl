#version 460
// Every texel says where it is.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba32f) writeonly uniform image2D result;

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(texel, imageSize(result)))) return;
  imageStore(result, texel, vec4(texel, 0, 1));
}
