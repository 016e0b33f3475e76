// The texels that carry surface, object after object, as a list.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/linear.glsl"

layout(std430, set = 0, binding = 0) readonly buffer Texels { uint texels[]; };  // x, y << 16
layout(std430, set = 0, binding = 1) writeonly buffer Sources { vec4 sources[]; };
layout(set = 0, binding = 2) uniform sampler2D positionArea;
layout(set = 0, binding = 3) uniform sampler2D irradianceObject;

layout(push_constant) uniform Push { uint sourceCount; };

void main() {
  uint i = linearIndex();
  if (i >= sourceCount) return;
  ivec2 texel = ivec2(texels[i] & 0xffffu, texels[i] >> 16);
  vec4 place = texelFetch(positionArea, texel, 0);
  sources[2u * i] = vec4(place.xyz, 0.0);
  sources[2u * i + 1u] = vec4(texelFetch(irradianceObject, texel, 0).rgb * place.w, 0.0);
}
