// What opaque clusters give back, or let through from their other side: first of light from lights and the sky, with
// what they send out by themselves; then of what other clusters send them; and at last of bounces that are not followed
// (further_bounces.comp). For surfaces it keeps the irradiance that these do not find for themselves
// (scatter/opaque_fragments).
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 12
#define BINDING_CLUSTER_NODES 13
#include "lib/bodies.glsl"
#include "lib/cluster_node.glsl"
#include "lib/cluster_weight.glsl"
#include "lib/frame.glsl"
#include "lib/light.glsl"
#include "lib/linear.glsl"
#include "lib/over_or_0.glsl"
#include "shared/boundary.h"

layout(std430, set = 0, binding = 3) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 4) readonly buffer Clusters { Cluster clusters[]; };
layout(std430, set = 0, binding = 5) readonly buffer Entries { Entry entries[]; };
layout(std430, set = 0, binding = 6) readonly buffer SkyShares { vec4 skyShares[]; };
layout(std430, set = 0, binding = 7) readonly buffer Entered { vec4 entered[]; };
layout(std430, set = 0, binding = 8) buffer Latest { vec4 latest[]; };
layout(std430, set = 0, binding = 9) writeonly buffer EnteredBefore { vec4 enteredBefore[]; };
layout(std430, set = 0, binding = 10) buffer Irradiances { vec4 irradiances[]; };
layout(std430, set = 0, binding = 1) readonly buffer Shares { OpaqueShare shares[]; };

layout(std430, set = 0, binding = 2) buffer OpaqueExitances { vec4 opaqueExitances[]; };

layout(std430, set = 0, binding = 11) readonly buffer StillToCome { vec4 stillToCome; };

// The light it takes, OpaquePass::From.
const uint ofLights = 0u;
const uint ofClusters = 1u;
const uint ofFurtherBounces = 2u;

layout(push_constant) uniform Push {
  uint clusterCount;
  uint from;
  uint bounces;  // that are followed
};

// All further terms of a geometric series over its last one, given that this is the n-th after the first and
// that part of all up to it. Light that is soon gone here must not go on as long as in the whole scene.
float furtherOfSeries(float part, float n) {
  float low = 0.0;
  float high = 1.0;
  for (int k = 0; k < 16; ++k) {
    float ratio = 0.5 * (low + high);
    float partThen = pow(ratio, n) * (1.0 - ratio) / (1.0 - pow(ratio, n + 1.0));
    bool isMore = partThen < part;
    low = isMore ? ratio : low;
    high = isMore ? high : ratio;
  }
  return low / (1.0 - low);
}

// What a cluster finds by rays: light of the sky, or what other clusters send.
vec3 foundByRays(uint k) {
  if (from != ofLights) return entered[k].rgb;
  return skyShares[k].rgb * entries[frame.counts.w * clusterCount + k].irradiance.rgb;
}

// Such light changes along a surface over parts of the distance that it comes from (Ward, Rubinstein and Clear
// 1988), so its mean is taken over such parts. A few rays of one cluster do not find what is small and bright. Sky
// and other light must have the same mean, as they add up to all around.
const float evenOverRoom = 0.3;
const float evenOverEdges = 6.0;

// Clusters whose normals have a smaller cosine are not in one surface.
const float oneSurface = 0.9;

vec3 foundAround(uint i) {
  Cluster own = clusters[i];
  ObjectData body = objects[ranges[i].object];
  float furthest = min(evenOverRoom * own.start.w, evenOverEdges * edgeOf(own));
  vec3 sum = foundByRays(i) * own.normal.w * own.normal.w;
  float all = own.normal.w * own.normal.w;
  uint node = body.clusters.x;
  while (node < body.clusters.y) {
    vec4 centroidLink = centroidLinkOf(node);
    uint link = floatBitsToUint(centroidLink.w);
    vec3 offset = centroidLink.xyz - own.centroidArea.xyz;
    float away = length(offset);
    bool apart = away >= furthest + spreadOf(node).x;
    if (!apart && isLeaf(link) && firstSurfelOf(link) != i) {
      uint k = firstSurfelOf(link);
      float reach = min(furthest, evenOverRoom * clusters[k].start.w);
      float left = max(1.0 - away * away / max(reach * reach, 1e-30), 0.0);
      float facing = smoothstep(oneSurface, 1.0, dot(own.normal.xyz, clusters[k].normal.xyz));
      float weight = left * left * facing * clusters[k].normal.w * clusters[k].normal.w;
      sum += weight * foundByRays(k);
      all += weight;
    }
    node = apart ? afterNode(node, link) : node + 1u;
  }
  return sum / max(all, 1e-30);
}

// From lights that shine on a cluster.
vec3 ofLightsOn(uint i) {
  vec3 sum = vec3(0.0);
  for (uint k = 0u; k < allLightsAt(clusters[i].centroidArea.xyz); ++k)
    sum += entries[k * clusterCount + i].irradiance.rgb;
  return sum;
}

// Where light goes through the body, the light on the cluster's other side: what surfaces do not find, and what they
// do.
vec3 behind = vec3(0.0);
vec3 knownBehind = vec3(0.0);

void lookBehind(uint i) {
  ObjectData body = objects[ranges[i].object];
  if (!letsThrough(body) || !hasBack(body)) return;
  uint other = ranges[i].side < 0.0 ? frontOf(i, body) : backOf(i, body);
  behind = foundAround(other);
  if (from == ofLights) knownBehind = ofLightsOn(other);
}

void main() {
  uint i = linearIndex();
  if (i >= clusterCount || ranges[i].kind != opaqueBody) return;
  OpaqueShare gives = shares[i];
  vec3 known = from == ofLights ? ofLightsOn(i) : vec3(0.0);
  vec3 other = foundAround(i);
  lookBehind(i);
  if (from == ofFurtherBounces) {
    vec3 last = gives.share.rgb * other + gives.through.rgb * behind;
    vec3 part = overOr0(last, opaqueExitances[i].rgb - gives.emission.rgb);
    for (int c = 0; c < 3; ++c) {
      float further = min(stillToCome[c], furtherOfSeries(part[c], float(bounces)));
      other[c] *= further;
      behind[c] *= further;
    }
  }
  bool isFirst = from == ofLights;
  vec3 own = isFirst ? gives.emission.rgb : vec3(0.0);
  latest[i] = vec4(gives.share.rgb * (known + other) + gives.through.rgb * (knownBehind + behind) + own, 0.0);
  opaqueExitances[i] = (isFirst ? vec4(0.0) : opaqueExitances[i]) + latest[i];
  enteredBefore[i] = vec4(0.0);
  irradiances[i] = vec4((isFirst ? vec3(0.0) : irradiances[i].rgb) + other, 0.0);
}
