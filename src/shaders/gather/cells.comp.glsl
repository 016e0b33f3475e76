// Means of the neighbourhoods' map over square cells, for the far samples.
#version 460

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0) uniform sampler2D nearPosition;
layout(set = 0, binding = 1) uniform sampler2D nearFlux;
layout(set = 0, binding = 2, rgba32f) writeonly uniform image2D farPosition;
layout(set = 0, binding = 3, rgba32f) writeonly uniform image2D farFlux;

layout(push_constant) uniform Push { int cellEdge; };  // texels

void main() {
  ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(cell, imageSize(farPosition)))) return;
  vec3 weighted = vec3(0.0);
  vec3 plain = vec3(0.0);
  vec4 flux = vec4(0.0);
  for (int y = 0; y < cellEdge; ++y) {
    for (int x = 0; x < cellEdge; ++x) {
      ivec2 texel = cell * cellEdge + ivec2(x, y);
      vec4 here = texelFetch(nearFlux, texel, 0);
      vec3 place = texelFetch(nearPosition, texel, 0).xyz;
      flux += here;
      weighted += place * here.a;
      plain += place;
    }
  }
  float texels = float(cellEdge * cellEdge);
  imageStore(farPosition, cell, vec4(flux.a > 0.0 ? weighted / flux.a : plain / texels, 0.0));
  imageStore(farFlux, cell, flux / texels);
}
