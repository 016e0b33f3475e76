// Light that comes from one cluster and enters another, by what the rays outwards met: what left there,
// and what was mirrored there as other light entered. It enters like light from everywhere.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_CLUSTER_PAINTS 10
#define BINDING_PEAKS 12
#define PEAKS_WRITTEN
#define BINDING_SUMS 13
#include "lib/diffuse_power.glsl"
#include "lib/linear.glsl"
#include "lib/meeting_behind.glsl"
#include "lib/mirrored_sums.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 3) readonly buffer Clusters { Cluster clusters[]; };
layout(std430, set = 0, binding = 4) readonly buffer Meetings { Meeting meetings[]; };
layout(std430, set = 0, binding = 5) readonly buffer Latest { vec4 latest[]; };
layout(std430, set = 0, binding = 6) readonly buffer EnteredBefore { vec4 enteredBefore[]; };
layout(std430, set = 0, binding = 7) readonly buffer Arrived { vec4 arrived[]; };
layout(std430, set = 0, binding = 8) buffer Strengths { vec4 strengths[]; };
layout(std430, set = 0, binding = 9) writeonly buffer Entered { vec4 entered[]; };
layout(std430, set = 0, binding = 11) writeonly buffer FromAfar { vec4 fromAfar[]; };
layout(std430, set = 0, binding = 14) readonly buffer EnteredInAll { vec4 enteredInAll[]; };
layout(std430, set = 0, binding = 15) readonly buffer MeetingsBehind { MeetingBehind behind[]; };

layout(constant_id = 1) const uint withOthers = 0u;  // 1: entered_around.comp.glsl adds light from afar

layout(push_constant) uniform Push {
  uint clusterCount;
  uint raysOutwards;
  uint meetingsBehindRay;  // 0 where no body lets light through
  uint isFirst;            // 1: adds light that was mirrored on arrival
  uint firstLight;         // of those that were found together last
  uint lights;             // that were; 0: none
};

// Where light comes from afar, in radii of the cluster that it enters.
const float nearInRadii = 4.0;
const float farInRadii = 8.0;

float shareFromAfar(Cluster cluster, vec3 place) {
  return withOthers == 0u ? 0.0
                          : smoothstep(nearInRadii, farInRadii,
                                       distance(place, cluster.centroidArea.xyz) / max(cluster.normal.w, 1e-15));
}

// Adds the light of a cluster that was met, of which that share enters: what leaves there, and what is mirrored there of
// what entered before.
void add(uint met, vec3 share, float transmitted, Cluster cluster, inout vec3 sum, inout vec3 far) {
  if (met == noCluster) return;
  vec3 light = share * mix(enteredBefore[met].rgb, latest[met].rgb, transmitted);
  sum += light;
  if (withOthers != 0u) far += shareFromAfar(cluster, clusters[met].centroidArea.xyz) * light;
}

void main() {
  uint i = linearIndex();
  if (i >= clusterCount) return;
  Cluster cluster = clusters[i];
  vec3 sum = vec3(0.0);
  vec3 far = vec3(0.0);
  for (uint k = 0u; k < raysOutwards; ++k) {
    Meeting meeting = meetings[i * raysOutwards + k];
    add(meeting.cluster, vec3(meeting.share), meeting.transmitted, cluster, sum, far);
  }
  uint end = (i + 1u) * raysOutwards * meetingsBehindRay;
  for (uint k = i * raysOutwards * meetingsBehindRay; k < end; ++k) {
    MeetingBehind meeting = behind[k];
    vec4 share = shareTransmittedOf(meeting);
    add(meeting.cluster, share.rgb, share.w, cluster, sum, far);
  }
  float area = cluster.centroidArea.w;
  if (isFirst != 0u && lights > 0u) {
    vec3 power = takeMirrored(i, firstLight, lights, clusterCount);
    if (firstLight > 0u) power += arrived[i].rgb;
    if (area > 0.0) sum += power / area;
  }
  noteEntered(peakOfAll, ranges[i].kind == opaqueBody ? sum : sum + enteredInAll[i].rgb);
  entered[i] = vec4(sum - far, 0.0);
  if (withOthers != 0u) fromAfar[i] = vec4(far, 0.0);
  strengths[i].rgb = diffusePower(i, cluster, insideOf(objects[ranges[i].object]), sum);
}
