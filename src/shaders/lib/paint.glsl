// Paint on translucent bodies (shared/paint.h).
#ifndef OPALINE_LIB_PAINT
#define OPALINE_LIB_PAINT
#include "shared/paint.h"

// What a layer lets through of light of one cosine, given what it lets through of diffuse light of
// that mean cosine. Both fall as e^{-a/μ}.
vec3 throughLayer(vec3 ofDiffuse, float meanCosine, float cosine) {
  return pow(ofDiffuse, vec3(meanCosine / max(cosine, 0.05)));
}

// What leaves through a layer. `bare` is the exitance if there were no layer to leave through; `entered` is the
// irradiance of light that has entered the diffusion at the surface, whose own fluence over 2A is `atSurface` times it.
vec3 leavesLayer(vec3 bare, vec3 entered, vec3 leaving, vec3 deep, vec3 takenOff, vec3 atSurface) {
  vec3 fromDepth = max(bare - atSurface * entered, vec3(0.0));
  return leaving * (bare + (deep - 1.0) * fromDepth) - takenOff * entered;
}

#ifdef BINDING_CLUSTER_PAINTS
layout(std430, set = 0, binding = BINDING_CLUSTER_PAINTS) readonly buffer ClusterPaints { ClusterPaint clusterPaints[]; };
#endif

#endif
