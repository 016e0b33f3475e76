// The GPU's version of bssrdf/fresnel.h. Also compiled as C++ with glm by the tests.
#ifndef OPALINE_SHADERS_LIB_FRESNEL_GLSL
#define OPALINE_SHADERS_LIB_FRESNEL_GLSL

// The cosine inside of light with that cosine outside, eta ≥ 1. Snell's law.
float cosineInside(float eta, float cosTheta) {
  return sqrt(1.0f - (1.0f - cosTheta * cosTheta) / (eta * eta));
}

// Exact unpolarised reflectance of a smooth dielectric, light from outside. Fresnel 1823.
// eta ≠ 1, cosTheta in [0,1] outside.
float fresnelReflectance(float eta, float cosTheta) {
  float cosSquaredInside = 1.0f - (1.0f - cosTheta * cosTheta) / (eta * eta);
  if (cosSquaredInside <= 0.0f) return 1.0f;
  float cosInside = sqrt(cosSquaredInside);
  float perpendicular = (cosTheta - eta * cosInside) / (cosTheta + eta * cosInside);
  float parallel = (eta * cosTheta - cosInside) / (eta * cosTheta + cosInside);
  return 0.5f * (perpendicular * perpendicular + parallel * parallel);
}

#endif
