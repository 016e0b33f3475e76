// The GGX microfacet reflection (Walter et al. 2007; visibility by Heitz 2014). α = roughness².
#ifndef OPALINE_LIB_GGX
#define OPALINE_LIB_GGX

#include "lib/pi.glsl"

float ggxDistribution(float alpha, float cosineHalf) {
  float a2 = alpha * alpha;
  float t = cosineHalf * cosineHalf * (a2 - 1.0) + 1.0;
  return a2 / (pi * t * t);
}

// Height-correlated Smith term over 4 cosineOut cosineIn.
float ggxVisibility(float alpha, float cosineOut, float cosineIn) {
  float a2 = alpha * alpha;
  float outgoing = cosineIn * sqrt(cosineOut * cosineOut * (1.0 - a2) + a2);
  float incoming = cosineOut * sqrt(cosineIn * cosineIn * (1.0 - a2) + a2);
  return 0.5 / max(outgoing + incoming, 1e-7);
}

#endif
