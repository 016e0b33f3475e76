// Gives every empty texel of the diffusion source map the data of the nearest texel that carries
// surface, continued along the tangent plane, so that no sample of the pattern falls on nothing.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/linear.glsl"

layout(std430, set = 0, binding = 0) readonly buffer Fills { uvec2 fills[]; };  // to, from
layout(set = 0, binding = 1, rgba32f) uniform image2D positionArea;
layout(set = 0, binding = 2, rgba16f) uniform image2D unitNormal;
layout(set = 0, binding = 3, rgba32f) uniform image2D irradianceObject;
layout(set = 0, binding = 4) uniform usampler2D coverage;

layout(push_constant) uniform Push { uint fillCount; };

ivec2 unpackTexel(uint packed) { return ivec2(packed & 0xffffu, packed >> 16); }

// Change of position from one texel to the next along an axis, within the chart: the nearest
// texels of other charts are further away than one texel.
vec3 tangent(ivec2 texel, ivec2 axis, vec3 position) {
  ivec2 size = textureSize(coverage, 0);
  ivec2 next = texel + axis;
  if (all(lessThan(next, size)) && texelFetch(coverage, next, 0).r != 0u)
    return imageLoad(positionArea, next).xyz - position;
  ivec2 previous = texel - axis;
  if (all(greaterThanEqual(previous, ivec2(0))) && texelFetch(coverage, previous, 0).r != 0u)
    return position - imageLoad(positionArea, previous).xyz;
  return vec3(0.0);
}

void main() {
  uint i = linearIndex();
  if (i >= fillCount) return;
  uvec2 fill = fills[i];
  ivec2 to = unpackTexel(fill.x);
  ivec2 from = unpackTexel(fill.y);
  vec4 source = imageLoad(positionArea, from);
  vec2 offset = vec2(to - from);
  source.xyz += offset.x * tangent(from, ivec2(1, 0), source.xyz) +
                offset.y * tangent(from, ivec2(0, 1), source.xyz);
  imageStore(positionArea, to, source);
  imageStore(unitNormal, to, imageLoad(unitNormal, from));
  imageStore(irradianceObject, to, imageLoad(irradianceObject, from));
}
