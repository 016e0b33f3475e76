// The operator of the boundary's equation on a fluence:
//   c_i φ_i + S_ii φ_i / 2A + Σ_j [S_ij / 2A + K_ij] φ_j,  S = e^{-σr} / 4πDr,
//   K_ij φ_j = -(1 + σr) e^{-σr} (x_j - x_i)·A_j φ_j / 4πr³, single clusters covering what a disc does.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_CLUSTER_NODES 4
#include "lib/boundary.glsl"
#include "lib/cluster_node.glsl"
#include "lib/linear.glsl"
#include "lib/solver.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 3) readonly buffer Clusters { Cluster clusters[]; };
layout(set = 0, binding = 5) uniform samplerBuffer densities;  // DensityNode
layout(std430, set = 0, binding = 6) readonly buffer Fluences { vec4 fluences[]; };
layout(std430, set = 0, binding = 7) writeonly buffer Products { vec4 products[]; };
layout(std430, set = 0, binding = 8) readonly buffer States { SolverState states[]; };

layout(push_constant) uniform Push {
  uint clusterCount;
  float openingAngle;
  uint first;  // of the fluences
  uint step;   // of the solver; skipped when that is done
  uint solution;
};

void main() {
  uint i = linearIndex();
  if (step > 0u && states[solution].done[doneBefore(step)] != 0u) return;
  bool inside = i < clusterCount;
  ClusterRange range = ranges[inside ? i : 0u];
  ObjectData body = objects[range.object];
  BoundaryMedium medium = insideOf(body);
  vec3 sigma = medium.sigma.rgb;
  float leastSigma = leastOf(sigma);
  vec3 weightS = 1.0 / (2.0 * medium.diffusion.w * medium.diffusion.rgb);  // 1 / 2AD
  Cluster cluster = clusters[inside ? i : 0u];
  vec3 place = cluster.centroidArea.xyz;

  vec3 sum = vec3(0.0);
  uint next = inside ? body.clusters.x : noNode;
  while (true) {
    uint at = subgroupMin(next);
    if (at == noNode) break;
    if (next == at) {
      vec4 centroidLink = centroidLinkOf(at);
      vec4 spread = spreadOf(at);
      uint link = floatBitsToUint(centroidLink.w);
      vec3 offset = centroidLink.xyz - place;
      float squared = dot(offset, offset);
      bool far = isFar(squared, spread.x, leastSigma, openingAngle);
      bool taken = isLeaf(link) || far;
      if (taken && at != range.node && squared > leastSquaredMm2) {
        vec4 red = texelFetch(densities, 3 * int(at));
        vec4 green = texelFetch(densities, 3 * int(at) + 1);
        vec4 blue = texelFetch(densities, 3 * int(at) + 2);
        float over = inversesqrt(squared);
        float fills = isLeaf(link) ? coverageOfDisc(squared, spread.w) : 1.0;
        vec3 x = sigma * (squared * over);
        vec3 e = exp(-x) * over;
        float away = sqrt(squared + smoothingOf(cluster.normal.w, isLeaf(link) ? sqrt(spread.w / pi) : 0.0));
        vec3 single = exp(-sigma * away) / away;
        // An expansion about the middle, for places outside alone.
        vec3 second = 1.0 + (far ? sigma * sigma * (spread.y / 6.0) : vec3(0.0));
        vec3 along = vec3(dot(offset, red.xyz), dot(offset, green.xyz), dot(offset, blue.xyz));
        sum += single * (weightS * second * vec3(red.w, green.w, blue.w)) -
               e * (1.0 + x) * (over * over * fills) * along;
        if (!isLeaf(link)) {
          // The moment of the double layer: both sides of a sheet, whose areas cancel.
          Moment moment = momentOf(at);
          vec3 mean = vec3(red.w, green.w, blue.w) / max(spread.w, 1e-30);
          float over2 = over * over;
          sum += mean * e * over2 *
                 ((3.0 + x * (3.0 + x)) * (over2 * alongTwice(moment, offset)) -
                  (1.0 + x) * traceOf(moment));
        }
      }
      next = taken ? afterNode(at, link) : at + 1u;
      if (next >= body.clusters.y) next = noNode;
    }
  }
  if (!inside) return;
  if (range.hasInside == 0u) {  // there is no equation
    products[i] = vec4(0.0);
    return;
  }
  vec3 own = 0.5 * absorbedLength(sigma, vec3(cluster.normal.w)) / medium.diffusion.rgb;
  vec3 fluence = fluences[first + i].rgb;
  products[i] = vec4(sum / (4.0 * pi) +
                         fluence * (cluster.vectorArea.w + own / (2.0 * medium.diffusion.w)),
                     0.0);
}
