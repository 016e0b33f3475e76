// Light that leaves after its first collision, through every cluster:
// M₁ = α* Σ power p e^{-σ_t*r} μ (1 - F_in(μ)) / r², of the part whose second collisions are followed, with the
// phase function p.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define CONSTANT_SEVERAL_MEDIA 1
#include "lib/beam_sum.glsl"
#include "lib/single_points.glsl"

void addNode(uint index) {
  takeWayFrom(index);
  BeamNode node = readLit(index);
  addNodeOf(node, powerOf(node));
}

// It depends on a cluster's normal, so has no expansion.
void expandNode(uint index, vec3 middle) {
  addNode(index);
}

// The mean of the phase function over all directions of that cosine to the normal, for light that arrives at
// the other cosine: four angles around, each of which stands for its mirror image too.
float phaseAround(float cosine, float cosineOfArrival) {
  float across = sqrt(max((1.0 - cosine * cosine) * (1.0 - cosineOfArrival * cosineOfArrival), 0.0));
  float along = cosine * cosineOfArrival;
  return 0.25 * (phaseOverEven(along + 0.92387953 * across, medium.collision.w) +
                 phaseOverEven(along + 0.38268343 * across, medium.collision.w) +
                 phaseOverEven(along - 0.38268343 * across, medium.collision.w) +
                 phaseOverEven(along - 0.92387953 * across, medium.collision.w));
}

// How much of a ring around a place lies on a disc whose middle is aside of it, about: exact where it touches the edge
// from within or from outside.
float shareOnDisc(float ring, float aside, float radius) {
  float crossing = radius * radius - ring * ring - aside * aside;
  return clamp(0.5 + 0.5 * crossing / max(2.0 * ring * aside, max(1e-6 * radius * radius, 1e-30)), 0.0, 1.0);
}

// The cluster's own light as from a disc at its depth, which light at a slant has carried aside: ½ ∫ p e^{-σ_t* z/μ}
// (1 - F_in) dμ over all directions that meet the disc, here times 4π; Gauss, four points.
float fromDisc(Cluster its, vec3 place, vec3 arrival, float extinction) {
  const float at[4] = float[4](0.0694318442, 0.3300094782, 0.6699905218, 0.9305681558);
  const float weight[4] = float[4](0.1739274226, 0.3260725774, 0.3260725774, 0.1739274226);
  float radius = its.normal.w;
  vec3 offset = its.centroidArea.xyz - place;
  float below = dot(offset, its.normal.xyz);
  float depth = max(below, 0.0);
  float aside = length(offset - below * its.normal.xyz);
  float reach = radius + aside;
  float from = max(depth * inversesqrt(depth * depth + reach * reach + 1e-30), medium.albedo.w);
  float sum = 0.0;
  for (int k = 0; k < 4; ++k) {
    float cosine = from + at[k] * (1.0 - from);
    float light = weight[k] * exp(-extinction * depth / cosine) * leaving(cosine);
    light *= shareOnDisc(depth * sqrt(max(1.0 - cosine * cosine, 0.0)) / cosine, aside, radius);
    sum += scattersEvenly != 0u ? light : light * phaseAround(cosine, dot(arrival, its.normal.xyz));
  }
  return 2.0 * pi / max(its.centroidArea.w, 1e-30) * (1.0 - from) * sum;
}

vec3 ownDiscs(uint receiver) {
  Cluster its = clusters[receiver];
  uint beam = beamOf(receiver);
  vec4 strength = strengthOf(beam);
  uint count = min(unpackPointCounts(strength.w).x, pointsOfFirstSegment);
  vec3 extinction = medium.collision.rgb;
  vec3 arrival = scattersEvenly != 0u ? vec3(0.0) : arrivalAt(beam, 0u);
  vec3 sum = vec3(0.0);
  for (uint p = 0u; p < count; ++p) {
    BeamPoint point = readPoint(beam, p);
    sum += shareOf(point) * vec3(fromDisc(its, point.red.xyz, arrival, extinction.r),
                                 fromDisc(its, point.green.xyz, arrival, extinction.g),
                                 fromDisc(its, point.blue.xyz, arrival, extinction.b));
  }
  return strength.rgb * its.second.rgb * sum;
}

void sumList(Around around) {
  if (!isLit()) return;
  uint list = startOfTilesList();
  uint count = lists[list];
  for (uint begin = sumKept(around.middle); begin < count; begin += sizeOfPart) {
    sortPart(list, begin, min(begin + sizeOfPart, count), around, 0.0);
    uint i = gl_LocalInvocationIndex;
    for (uint k = i; k < ends[1]; k += invocationsOfTile) addNode(sorted[k]);
    for (uint k = ends[1] + i; k < ends[3]; k += invocationsOfTile) {
      takeWayFrom(sorted[k]);
      uint cluster = clusterOf(readListed(sorted[k]));
      addPoints(cluster, strengthOf(beamOf(cluster)).rgb);
    }
    barrier();
  }
}

void main() {
  if (!enterTile(tileCount)) return;
  takeSurface();
  [[unroll]] for (uint t = 0u; t < maxClustersOfTile; ++t) tileLight[t] = vec3(0.0);
  Around around = aroundTile();
  takeWayOfTile();
  for (light = 0u; light < lights; ++light) sumList(around);
  [[unroll]] for (uint t = 0u; t < maxClustersOfTile; ++t) addToTile(t, tileLight[t]);
  uint target = gl_LocalInvocationIndex;
  vec3 sum = sumOfTile(target);
  if (target >= tile.endCluster - tile.firstCluster) return;
  vec3 own = vec3(0.0);
  for (light = 0u; light < lights; ++light) own += ownDiscs(tile.firstCluster + target);
  putLight(target, sum, own, medium.scatters.rgb / (4.0 * pi));
}
