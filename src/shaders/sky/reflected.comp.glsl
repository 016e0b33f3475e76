// The sky as a GGX lobe sees it (Karis 2013, split sum), by filtered importance sampling
// (Křivánek and Colbert 2008): each sample reads the map at the level whose texels are as large as
// the sample's share of the lobe, so that a sun leaves no sparks.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/ggx.glsl"
#include "lib/lat_long.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0) uniform sampler2D latLong;
layout(set = 0, binding = 1, rgba32f) writeonly uniform image2DArray cube;

layout(push_constant) uniform Push {
  vec4 ambient;  // rgb: uniform radiance on top of the environment's
  float alpha;
  uint sampleCount;
  float leastLevel;  // of the map, whose texels are as large as the cube's
};

vec3 cubeDirection(uint face, vec2 place) {
  vec2 p = 2.0 * place - 1.0;
  switch (face) {
    case 0u: return normalize(vec3(1.0, -p.y, -p.x));
    case 1u: return normalize(vec3(-1.0, -p.y, p.x));
    case 2u: return normalize(vec3(p.x, 1.0, p.y));
    case 3u: return normalize(vec3(p.x, -1.0, -p.y));
    case 4u: return normalize(vec3(p.x, -p.y, 1.0));
    default: return normalize(vec3(-p.x, -p.y, -1.0));
  }
}

void main() {
  uvec3 texel = gl_GlobalInvocationID;
  ivec3 size = imageSize(cube);
  if (any(greaterThanEqual(ivec2(texel.xy), size.xy))) return;
  vec3 axis = cubeDirection(texel.z, (vec2(texel.xy) + 0.5) / vec2(size.xy));
  vec3 side = normalize(cross(abs(axis.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0), axis));
  vec3 top = cross(axis, side);

  vec2 mapSize = vec2(textureSize(latLong, 0));
  vec4 sum = vec4(0.0);
  for (uint i = 0u; i < sampleCount; ++i) {
    float u = (float(i) + 0.5) / float(sampleCount);
    float angle = 2.0 * pi * (float(bitfieldReverse(i)) / 4294967296.0);
    float cosine = sqrt((1.0 - u) / (1.0 + (alpha * alpha - 1.0) * u));
    float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
    vec3 middle = sine * (cos(angle) * side + sin(angle) * top) + cosine * axis;
    vec3 toLight = 2.0 * cosine * middle - axis;
    float weight = dot(axis, toLight);
    if (weight <= 0.0) continue;
    float solidAngle = 4.0 / (ggxDistribution(alpha, cosine) * float(sampleCount));
    float texelAngle = 2.0 * pi * pi * sqrt(max(1.0 - toLight.y * toLight.y, 1e-6)) / (mapSize.x * mapSize.y);
    float level = max(0.5 * log2(solidAngle / texelAngle) + 0.5, leastLevel);
    sum += weight * vec4(textureLod(latLong, latLongCoordinates(toLight), level).rgb, 1.0);
  }
  imageStore(cube, ivec3(texel), vec4(sum.rgb / max(sum.a, 1e-6) + ambient.rgb, 1.0));
}
