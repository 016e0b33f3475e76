// Power of diffuse light that goes into a body below a cluster. Needs BINDING_CLUSTER_PAINTS and what lib/boundary.glsl
// needs before it.
#ifndef OPALINE_LIB_DIFFUSE_POWER
#define OPALINE_LIB_DIFFUSE_POWER
#include "lib/boundary.glsl"
#include "lib/paint.glsl"

layout(constant_id = 0) const uint withPaint = 0u;

// Of the irradiance that entered there, less what enters the diffusion at the surface itself.
vec3 diffusePower(uint i, Cluster cluster, BoundaryMedium medium, vec3 entered) {
  vec3 power = cluster.centroidArea.w * entered * (1.0 - shareAtSurface(cluster.start.w, medium));
  return withPaint != 0u ? power * clusterPaints[i].entering.rgb : power;
}

#endif
