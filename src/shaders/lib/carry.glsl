// Carries light from clusters to places of the surface: as boundary transport has it, with detail
// of a half-space between them. Needs, before it, BINDING_CLUSTERS, BINDING_CLUSTER_NODES,
// BINDING_EXITANCES and BINDING_MEANS; BINDING_NEARBY for where light comes from.
#ifndef OPALINE_LIB_CARRY
#define OPALINE_LIB_CARRY
#include "lib/cluster_node.glsl"
#include "lib/cluster_weight.glsl"
#include "lib/origin.glsl"
#include "lib/texels.glsl"
#include "lib/tree_node.glsl"
#include "shared/boundary.h"
#include "shared/medium.h"
#include "shared/paint.h"

// As texels: Mesa's software device reads storage word by word.
TEXELS(BINDING_CLUSTERS, clusters);  // Cluster
TEXELS(BINDING_EXITANCES, exitances);
TEXELS(BINDING_MEANS, means);

#ifdef BINDING_NEARBY
TEXELS(BINDING_NEARBY, nearby);
#endif

// Clusters this many mean free paths or diffusion lengths wide resolve nothing of what a half-space
// has between them. The smaller they are, the less of its detail is wanted.
const float coarseInFreePaths = 4.0;
const float coarseInDiffusionLengths = 1.0;

#ifdef BINDING_BARE_LIGHTS
layout(constant_id = 0) const uint withPaint = 0u;
layout(std430, set = 0, binding = BINDING_BARE_LIGHTS) readonly buffer BareLights { BareLight bareLights[]; };

// For a painted body, what has entered the diffusion at the surface; the walk below finds it too.
vec3 enteredAround = vec3(0.0);

vec3 exitanceOfCluster(uint i, bool painted, float weight) {
  if (withPaint == 0u || !painted) return texelOf(exitances, int(i)).rgb;
  enteredAround += weight * bareLights[i].entered.rgb;
  return bareLights[i].exitance.rgb;
}
#else
vec3 exitanceOfCluster(uint i, bool painted, float weight) {
  return texelOf(exitances, int(i)).rgb;
}
#endif

// Sums over clusters around a place.
struct Around {
  vec4 origin;  // what leaves of light that entered there; 1 over the thickness
  vec3 normals;
  float squares;  // of distances, mm²
};

// 1 over the thickness of a plate through which light leaves as it does here, 1/mm. Ways through a ball are longest
// straight on, those through a plate at a slant: a ball is like a plate that is twice as thick.
float overThicknessOf(Around around, float weight) {
  float over = around.origin.w / weight;
  float curved = sqrt(2.0 * max(1.0 - length(around.normals) / weight, 0.0) * weight / max(around.squares, 1e-18));
  return over / (1.0 + min(0.5 * curved / max(over, 1e-18), 1.0));
}

struct Carried {
  vec3 exitance;
  vec4 origin;
};

// The exitance at a place, given that of the half-space, from the clusters around. Their weights fall to
// 0 where a cluster's reach ends, so nothing jumps. Detail is scaled down, never up. Clusters of opaque
// bodies hold only light that is not known at the place, which is added to what is; those of painted
// bodies hold the light below the paint. The invocations of a subgroup go in step; those with nothing to
// do have noNode as root.
Carried corrected(vec3 halfSpace, vec3 place, vec3 normal, BoundaryMedium medium,
                  bool opaque, bool painted, uint root, uint end) {
  vec3 exitance = vec3(0.0);
  vec3 mean = vec3(0.0);
  float edges = 0.0;
  float all = 0.0;
  float inside = 0.0;
  Around around = Around(vec4(0.0), vec3(0.0), 0.0);
  uint next = root;
  while (true) {
    uint at = subgroupMin(next);
    if (at == noNode) break;
    if (next == at) {
      vec4 centroidLink = centroidLinkOf(at);
      uint link = floatBitsToUint(centroidLink.w);
      float reach = spreadOf(at).z;
      vec3 offset = centroidLink.xyz - place;
      float squared = dot(offset, offset);
      bool opened = squared < reach * reach;
      if (opened && isLeaf(link)) {
        uint i = firstSurfelOf(link);
        vec4 normalRadius = texelOf(clusters, texelOfCluster(i, 1u));
        float edge = edgeOfDisc(normalRadius.w);
        float weight = weightOfCluster(squared, reach, edge, dot(normal, normalRadius.xyz));
        all += weight;
        weight *= texelOf(clusters, texelOfCluster(i, 6u)).w;  // 0 in an open body
        exitance += weight * exitanceOfCluster(i, painted, weight);
        mean += weight * texelOf(means, int(i)).rgb;
        edges += weight * edge;
        inside += weight;
#ifdef BINDING_NEARBY
        around.origin += weight * texelOf(nearby, int(i));
        around.normals += weight * normalRadius.xyz;
        around.squares += weight * squared;
#endif
      }
      next = opened ? at + 1u : afterNode(at, link);
      if (next >= end) next = noNode;
    }
  }
  if (inside <= 0.0) return Carried(halfSpace, unknownOrigin);
  exitance /= inside;
#ifdef BINDING_BARE_LIGHTS
  enteredAround /= all;
#endif
  if (opaque) return Carried(halfSpace + exitance, unknownOrigin);
  mean /= inside;
  vec3 wanted = max(medium.extinction.rgb / coarseInFreePaths,
                    medium.sigma.rgb / coarseInDiffusionLengths);
  vec3 detail = clamp(edges / inside * wanted, 0.0, 1.0);
  detail *= min(exitance / max(mean, vec3(1e-30)), vec3(1.0));
  vec3 better = max(exitance + detail * (halfSpace - mean), vec3(0.0));
  vec3 found = mix(halfSpace, better, inside / all);
  return Carried(found, vec4(min(around.origin.rgb / max(inside * found, vec3(1e-30)), vec3(1.0)), overThicknessOf(around, inside)));
}

#endif
