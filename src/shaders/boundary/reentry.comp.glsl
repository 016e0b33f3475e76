// The power of light that left one cluster and enters another, by what the rays outwards met. It
// enters like what comes from everywhere.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/linear.glsl"
#include "shared/boundary.h"

layout(std430, set = 0, binding = 0) readonly buffer Clusters { Cluster clusters[]; };
layout(std430, set = 0, binding = 1) readonly buffer Meetings { Meeting meetings[]; };
layout(std430, set = 0, binding = 2) readonly buffer Latest { vec4 latest[]; };
layout(std430, set = 0, binding = 3) buffer Strengths { vec4 strengths[]; };

layout(std430, set = 0, binding = 4) readonly buffer Arrived { vec4 arrived[]; };

layout(push_constant) uniform Push {
  uint clusterCount;
  uint raysOutwards;
  uint isFirst;  // 1: light that was mirrored on arrival too
};

void main() {
  uint i = linearIndex();
  if (i >= clusterCount) return;
  vec3 sum = vec3(0.0);
  for (uint k = 0u; k < raysOutwards; ++k) {
    Meeting meeting = meetings[i * raysOutwards + k];
    if (meeting.cluster != noCluster) sum += meeting.share * latest[meeting.cluster].rgb;
  }
  strengths[i].rgb = clusters[i].centroidArea.w * sum + (isFirst != 0u ? arrived[i].rgb : vec3(0.0));
}
