// Reflectances of a list of indices of refraction and cosines, as the passes compute them.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/linear.glsl"
#include "lib/fresnel.glsl"

layout(std430, set = 0, binding = 0) readonly buffer Places { vec2 etaCosine[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Values { float values[]; };

layout(push_constant) uniform Push { uint count; };

void main() {
  uint i = linearIndex();
  if (i >= count) return;
  values[i] = fresnelReflectance(etaCosine[i].x, etaCosine[i].y);
}
