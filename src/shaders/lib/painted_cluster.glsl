// The boundary's equation where some bodies are painted, or have linings. Needs, before it,
// BINDING_CLUSTER_PAINTS and what lib/boundary.glsl needs; where LININGS is defined BINDING_OPAQUE_SHARES
// too, and after it rangeOf().
#ifndef OPALINE_LIB_PAINTED_CLUSTER
#define OPALINE_LIB_PAINTED_CLUSTER
#include "lib/boundary.glsl"
#include "lib/paint.glsl"

layout(constant_id = 0) const uint withPaint = 0u;

bool isPaintedCluster(uint cluster) {
  return withPaint != 0u && clusterPaints[cluster].entering.w != 0.0;
}

#ifdef LININGS
layout(constant_id = 1) const uint withLinings = 0u;

layout(std430, set = 0, binding = BINDING_OPAQUE_SHARES) readonly buffer OpaqueShares { OpaqueShare opaqueShares[]; };

ClusterRange rangeOf(uint cluster);

// At a lining A' is (1 + ρ) / (1 - ρ), for the share ρ of light that it gives back evenly, plus what
// diffusion lacks on a plane: Milne's extrapolation is 0.7104 mean free paths, not 2/3.
vec3 layerOfLining(uint cluster, uint object) {
  const float ofMilne = 0.0656;
  vec3 share = min(opaqueShares[cluster].share.rgb, vec3(1.0));
  return insideOf(objects[object]).diffusion.w * (1.0 - share) / (1.0 + share + ofMilne * (1.0 - share));
}

// A/A', by which the cluster's fluence is a stronger single layer.
vec3 layerOf(uint cluster) {
  if (withLinings != 0u) {
    ClusterRange range = rangeOf(cluster);
    if (range.kind == lining) return layerOfLining(cluster, range.object);
  }
  return isPaintedCluster(cluster) ? clusterPaints[cluster].layer.rgb : vec3(1.0);
}
#endif

// The fluence at which as much leaves as has entered at the surface.
vec3 fluenceEntered(uint cluster, vec3 entered, float thicknessMm, BoundaryMedium medium) {
  if (!isPaintedCluster(cluster)) return fluenceAtSurface(entered, thicknessMm, medium);
  return clusterPaints[cluster].atSurface.rgb * shareAtSurface(thicknessMm, medium) * entered;
}

#endif
