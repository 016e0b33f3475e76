// The diffusion source map in the layout of neighbourhoods: each chart has the surface beyond its
// seams around it, so that every sample of the pattern falls on what lies there.
#version 460

layout(local_size_x = 8, local_size_y = 8) in;

layout(std430, set = 0, binding = 0) readonly buffer Origins { uint origins[]; };
layout(set = 0, binding = 1) uniform sampler2D positionArea;
layout(set = 0, binding = 2) uniform sampler2D irradianceObject;
layout(set = 0, binding = 3, rgba32f) writeonly uniform image2D nearPosition;
layout(set = 0, binding = 4, rgba32f) writeonly uniform image2D nearFlux;
layout(set = 0, binding = 5) uniform sampler2D texelSurface;

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 size = imageSize(nearPosition);
  if (any(greaterThanEqual(texel, size))) return;
  // x in the low 15 bits, y in the next 15; the highest bit is set where surface lies.
  uint origin = origins[texel.y * size.x + texel.x];
  ivec2 from = ivec2(bitfieldExtract(origin, 0, 15), bitfieldExtract(origin, 15, 15));
  vec4 place = texelFetch(positionArea, from, 0);
  float present = float(origin >> 31);
  imageStore(nearPosition, texel, vec4(place.xyz, present));
  // The area of a whole texel: what its border cuts off lies in the tile as well, shown by other texels.
  float area = place.w / max(texelFetch(texelSurface, from, 0).z, 1e-6);
  imageStore(nearFlux, texel,
             vec4(texelFetch(irradianceObject, from, 0).rgb, 1.0) * (present * area));
}
