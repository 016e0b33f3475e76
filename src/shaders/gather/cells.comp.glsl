// Means of the diffusion source map over square cells, in a layout of neighbourhoods whose aprons
// reach as far as the far samples. A few texels of each cell suffice.
#version 460

layout(local_size_x = 8, local_size_y = 8) in;

layout(std430, set = 0, binding = 0) readonly buffer Origins { uint origins[]; };
layout(set = 0, binding = 1) uniform sampler2D positionArea;
layout(set = 0, binding = 2) uniform sampler2D irradianceObject;
layout(set = 0, binding = 3, rgba32f) writeonly uniform image2D farPosition;
layout(set = 0, binding = 4, rgba32f) writeonly uniform image2D farFlux;

layout(push_constant) uniform Push {
  int cellEdge;  // texels
  int stride;    // between those that are read
};

void main() {
  ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
  ivec2 cells = imageSize(farPosition);
  if (any(greaterThanEqual(cell, cells))) return;
  vec3 weighted = vec3(0.0);
  vec3 plain = vec3(0.0);
  vec4 flux = vec4(0.0);
  float count = 0.0;
  for (int y = stride / 2; y < cellEdge; y += stride) {
    for (int x = stride / 2; x < cellEdge; x += stride) {
      ivec2 texel = cell * cellEdge + ivec2(x, y);
      // See gather/neighbours.comp.glsl.
      uint origin = origins[texel.y * cells.x * cellEdge + texel.x];
      ivec2 from = ivec2(bitfieldExtract(origin, 0, 15), bitfieldExtract(origin, 15, 15));
      vec4 place = texelFetch(positionArea, from, 0);
      float area = (origin >> 31) != 0u ? place.w : 0.0;
      flux += vec4(texelFetch(irradianceObject, from, 0).rgb, 1.0) * area;
      weighted += place.xyz * area;
      plain += place.xyz;
      count += 1.0;
    }
  }
  imageStore(farPosition, cell, vec4(flux.a > 0.0 ? weighted / flux.a : plain / count, 0.0));
  imageStore(farFlux, cell, flux / count);
}
