// Light that comes from one cluster and enters another, by what the rays outwards met: what left there,
// and what was mirrored there as other light entered. It enters like light from everywhere.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_CLUSTER_PAINTS 10
#include "lib/boundary.glsl"
#include "lib/linear.glsl"
#include "lib/paint.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 3) readonly buffer Clusters { Cluster clusters[]; };
layout(std430, set = 0, binding = 4) readonly buffer Meetings { Meeting meetings[]; };
layout(std430, set = 0, binding = 5) readonly buffer Latest { vec4 latest[]; };
layout(std430, set = 0, binding = 6) readonly buffer EnteredBefore { vec4 enteredBefore[]; };
layout(std430, set = 0, binding = 7) readonly buffer Arrived { vec4 arrived[]; };
layout(std430, set = 0, binding = 8) buffer Strengths { vec4 strengths[]; };
layout(std430, set = 0, binding = 9) writeonly buffer Entered { vec4 entered[]; };

layout(constant_id = 0) const uint withPaint = 0u;

layout(push_constant) uniform Push {
  uint clusterCount;
  uint raysOutwards;
  uint isFirst;  // 1: adds light that was mirrored on arrival
};

void main() {
  uint i = linearIndex();
  if (i >= clusterCount) return;
  vec3 sum = vec3(0.0);
  for (uint k = 0u; k < raysOutwards; ++k) {
    Meeting meeting = meetings[i * raysOutwards + k];
    if (meeting.cluster == noCluster) continue;
    sum += meeting.share *
           mix(enteredBefore[meeting.cluster].rgb, latest[meeting.cluster].rgb, meeting.transmitted);
  }
  Cluster cluster = clusters[i];
  BoundaryMedium medium = insideOf(objects[ranges[i].object]);
  float area = cluster.centroidArea.w;
  if (isFirst != 0u && area > 0.0) sum += arrived[i].rgb / area;
  entered[i] = vec4(sum, 0.0);
  vec3 power = area * sum * (1.0 - shareAtSurface(cluster.start.w, medium));
  if (withPaint != 0u) power *= clusterPaints[i].entering.rgb;
  strengths[i].rgb = power;
}
