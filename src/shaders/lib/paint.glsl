// Paint on translucent bodies (shared/paint.h).
#ifndef OPALINE_LIB_PAINT
#define OPALINE_LIB_PAINT
#include "shared/paint.h"

// What a layer lets through of light of one cosine, given what it lets through of diffuse light of
// that mean cosine. Both fall as e^{-a/μ}.
vec3 throughLayer(vec3 ofDiffuse, float meanCosine, float cosine) {
  return pow(ofDiffuse, vec3(meanCosine / max(cosine, 0.05)));
}

// What leaves through a layer: of the exitance that there would be without one to leave through, and the
// irradiance of light that has entered the diffusion at the surface, whose own fluence is `atSurface` times
// that over 2A.
vec3 leavesLayer(vec3 bare, vec3 entered, vec3 leaving, vec3 deep, vec3 takenOff, vec3 atSurface) {
  vec3 fromDepth = max(bare - atSurface * entered, vec3(0.0));
  return leaving * (bare + (deep - 1.0) * fromDepth) - takenOff * entered;
}

#ifdef BINDING_CLUSTER_PAINTS
layout(std430, set = 0, binding = BINDING_CLUSTER_PAINTS) readonly buffer ClusterPaints { ClusterPaint clusterPaints[]; };
#endif

#endif
