// The boundary's equation where some bodies are painted. Needs, before it, BINDING_CLUSTER_PAINTS and
// what lib/boundary.glsl needs.
#ifndef OPALINE_LIB_PAINTED_CLUSTER
#define OPALINE_LIB_PAINTED_CLUSTER
#include "lib/boundary.glsl"
#include "lib/paint.glsl"

layout(constant_id = 0) const uint withPaint = 0u;

bool isPaintedCluster(uint cluster) {
  return withPaint != 0u && clusterPaints[cluster].entering.w != 0.0;
}

// A/A', by which its fluence is a stronger single layer.
vec3 layerOf(uint cluster) {
  return isPaintedCluster(cluster) ? clusterPaints[cluster].layer.rgb : vec3(1.0);
}

// Where so much light has entered at the surface: the fluence at which as much leaves.
vec3 fluenceEntered(uint cluster, vec3 entered, float thicknessMm, BoundaryMedium medium) {
  if (!isPaintedCluster(cluster)) return fluenceAtSurface(entered, thicknessMm, medium);
  return clusterPaints[cluster].atSurface.rgb * shareAtSurface(thicknessMm, medium) * entered;
}

#endif
