// Means of the diffusion source map over square cells, in a layout of neighbourhoods whose aprons
// hold a linear filter.
#version 460

layout(local_size_x = 8, local_size_y = 8) in;

layout(std430, set = 0, binding = 0) readonly buffer Origins { uint origins[]; };
layout(set = 0, binding = 1) uniform sampler2D positionArea;
layout(set = 0, binding = 2) uniform sampler2D irradianceObject;
layout(set = 0, binding = 3, rgba32f) writeonly uniform image2D farPosition;
layout(set = 0, binding = 4, rgba32f) writeonly uniform image2D farFlux;
layout(set = 0, binding = 5) uniform sampler2D texelSurface;

layout(push_constant) uniform Push { int cellEdge; };  // texels

void main() {
  ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
  ivec2 cells = imageSize(farPosition);
  if (any(greaterThanEqual(cell, cells))) return;
  vec3 weighted = vec3(0.0);
  vec3 plain = vec3(0.0);
  vec4 flux = vec4(0.0);
  for (int y = 0; y < cellEdge; ++y) {
    for (int x = 0; x < cellEdge; ++x) {
      ivec2 texel = cell * cellEdge + ivec2(x, y);
      // See neighbours.comp.glsl.
      uint origin = origins[texel.y * cells.x * cellEdge + texel.x];
      ivec2 from = ivec2(bitfieldExtract(origin, 0, 15), bitfieldExtract(origin, 15, 15));
      vec4 place = texelFetch(positionArea, from, 0);
      // The area of a whole texel, as there.
      float whole = place.w / max(texelFetch(texelSurface, from, 0).z, 1e-6);
      float area = (origin >> 31) != 0u ? whole : 0.0;
      flux += vec4(texelFetch(irradianceObject, from, 0).rgb, 1.0) * area;
      weighted += place.xyz * area;
      plain += place.xyz;
    }
  }
  float count = float(cellEdge * cellEdge);
  imageStore(farPosition, cell, vec4(flux.a > 0.0 ? weighted / flux.a : plain / count, 0.0));
  imageStore(farFlux, cell, flux / count);
}
