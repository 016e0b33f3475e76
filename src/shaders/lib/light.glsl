// What arrives from the frame's lights, wherever nothing is between. Needs lib/frame.glsl.
#ifndef OPALINE_LIB_LIGHT
#define OPALINE_LIB_LIGHT

// Irradiance on a surface that faces the light; the direction to it comes back unit.
vec3 lightIrradiance(uint index, vec3 position, out vec3 toLight) {
  LightData light = frame.lights[index];
  if (light.place.w == 0.0) {
    toLight = light.place.xyz;
    return light.power.rgb;
  }
  vec3 offset = light.place.xyz - position;
  float squared = max(dot(offset, offset), 1e-12);
  toLight = offset * inversesqrt(squared);
  return light.power.rgb / squared;
}

#endif
