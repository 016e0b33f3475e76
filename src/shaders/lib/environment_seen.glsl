// The environment as lines of sight see it, with its suns. Needs, before it, `environment`, a latitude-longitude map, and
// `ambient`, radiance on top of it.
#ifndef OPALINE_LIB_ENVIRONMENT_SEEN
#define OPALINE_LIB_ENVIRONMENT_SEEN
#include "lib/lat_long.glsl"

// The level whose texels are as large as that angle, rad.
float levelOfEnvironment(float angle) {
  float texel = pi / float(textureSize(environment, 0).y);
  return max(log2(angle / texel), 0.0);
}

vec3 environmentFrom(vec3 direction, float level) {
  return textureLod(environment, latLongCoordinates(direction), level).rgb + ambient.rgb;
}

#endif
