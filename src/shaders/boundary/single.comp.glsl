// Light that leaves after its first collision, through every cluster:
// M₁ = α* Σ power p e^{-σ_t*r} μ (1 - F_in(μ)) / r², of the part whose second collisions are followed, with the
// phase function p.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define CONSTANT_SEVERAL_MEDIA 1
#include "lib/beam_tile.glsl"
#include "lib/phase.glsl"

layout(constant_id = 0) const uint scattersEvenly = 1u;  // 0: some media do not

float eta;
vec4 targetNormals[maxClustersOfTile];  // w: ρ, mm

// 1 - F_in, both polarisations over one denominator.
float leaving(float cosine) {
  float outside = sqrt(max(1.0 - (1.0 - cosine * cosine) * eta * eta, 0.0));
  float across = cosine + eta * outside;
  float along = eta * cosine + outside;
  float both = across * along;
  return cosine <= medium.albedo.w
             ? 0.0
             : 2.0 * eta * cosine * outside * (across * across + along * along) / (both * both);
}

// Places near the surface are smoothed over the cluster, the cosine as well as the distance, and the
// way is what the depth makes of that cosine: with z² + s for z² in both, all light from a depth z
// that clusters of a plane receive is ½ ∫ e^{-σ_t'z/μ} (1 - F_in) dμ as it should be, whatever the
// smoothing s.
float fromPlace(vec3 place, vec3 arrival, float extinction, float smoothing, uint target) {
  vec3 offset = targets[target].xyz - place;
  float depth = dot(offset, targetNormals[target].xyz);
  float over = inversesqrt(dot(offset, offset) + smoothing);
  float cosine = (sqrt(depth * depth + smoothing) + min(depth, 0.0)) * over;
  if (cosine <= medium.albedo.w) return 0.0;
  float light = exp(-extinction * max(depth, 0.0) / cosine) * over * over * cosine * leaving(cosine);
  if (scattersEvenly != 0u) return light;
  vec3 direction = over * offset + (cosine - depth * over) * targetNormals[target].xyz;
  return light * phaseOverEven(dot(direction, arrival), medium.collision.w);
}

// Of light that entered through a disc of that radius, over both discs: on the other side of a thin
// part it lies just below clusters that are no nearer to each other.
vec3 fromPlaces(BeamPoint point, vec3 arrival, float radiusMm, uint target) {
  float radius = targetNormals[target].w;
  float smoothing = 0.5 * (radius * radius + radiusMm * radiusMm);
  vec3 extinction = way.extinction;
  return vec3(fromPlace(point.red.xyz, arrival, extinction.r, smoothing, target),
              fromPlace(point.green.xyz, arrival, extinction.g, smoothing, target),
              fromPlace(point.blue.xyz, arrival, extinction.b, smoothing, target));
}

void addNode(uint index) {
  takeWayFrom(index);
  BeamNode node = readListed(index);
  BeamPoint middle = BeamPoint(node.redPower, node.greenLink, node.bluePower);
  [[unroll]] for (uint t = 0u; t < maxClustersOfTile; ++t)
    tileLight[t] += powerOf(node) * fromPlaces(middle, node.across.xyz, 0.0, t);
}

// The mean of the phase function over all directions of that cosine to the normal, for light that arrives at
// another: four angles around, of which two are as two others.
float phaseAround(float cosine, float cosineOfArrival) {
  float across = sqrt(max((1.0 - cosine * cosine) * (1.0 - cosineOfArrival * cosineOfArrival), 0.0));
  float along = cosine * cosineOfArrival;
  return 0.25 * (phaseOverEven(along + 0.92387953 * across, medium.collision.w) +
                 phaseOverEven(along + 0.38268343 * across, medium.collision.w) +
                 phaseOverEven(along - 0.38268343 * across, medium.collision.w) +
                 phaseOverEven(along - 0.92387953 * across, medium.collision.w));
}

// The cluster's own light as from a disc at its depth: ½ ∫ p e^{-σ_t* z/μ} (1 - F_in) dμ, from the
// cosine to the disc's edge to 1, here times 4π; Gauss, four points.
float fromDisc(Cluster its, vec3 place, vec3 arrival, float extinction) {
  const float at[4] = float[4](0.0694318442, 0.3300094782, 0.6699905218, 0.9305681558);
  const float weight[4] = float[4](0.1739274226, 0.3260725774, 0.3260725774, 0.1739274226);
  float radius = its.normal.w;
  float depth = max(dot(its.centroidArea.xyz - place, its.normal.xyz), 0.0);
  float from = max(depth * inversesqrt(depth * depth + radius * radius + 1e-30), medium.albedo.w);
  float sum = 0.0;
  for (int k = 0; k < 4; ++k) {
    float cosine = from + at[k] * (1.0 - from);
    float light = weight[k] * exp(-extinction * depth / cosine) * leaving(cosine);
    sum += scattersEvenly != 0u ? light : light * phaseAround(cosine, dot(arrival, its.normal.xyz));
  }
  return 2.0 * pi / max(its.centroidArea.w, 1e-30) * (1.0 - from) * sum;
}

vec3 ownDiscs(uint receiver) {
  Cluster its = clusters[receiver];
  uint beam = beamOf(receiver);
  vec4 strength = strengths[beam];
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

void addPoints(uint node) {
  takeWayFrom(node);
  uint cluster = clusterOf(readListed(node));
  uint beam = beamOf(cluster);
  uint count = unpackPointCounts(strengths[beam].w).x;
  Cluster from = clusters[cluster];
  vec3 power = strengths[beam].rgb * from.second.rgb;
  for (uint p = 0u; p < count; ++p) {
    BeamPoint point = readPoint(beam, p);
    uint without = p < pointsOfFirstSegment ? cluster - tile.firstCluster : noNode;
    vec3 arrival = scattersEvenly != 0u ? vec3(0.0) : arrivalAt(beam, p);
    [[unroll]] for (uint t = 0u; t < maxClustersOfTile; ++t) {
      vec3 leaves = power * shareOf(point) * fromPlaces(point, arrival, from.normal.w, t);
      if (t != without) tileLight[t] += leaves;
    }
  }
}

void sumList(Around around) {
  uint list = startOfTilesList();
  uint count = lists[list];
  for (uint begin = 0u; begin < count; begin += sizeOfPart) {
    uvec4 ends = sortPart(list, begin, min(begin + sizeOfPart, count), around, 0.0);
    uint i = gl_LocalInvocationIndex;
    for (uint k = i; k < ends.y; k += invocationsOfTile) addNode(sorted[k]);
    for (uint k = ends.y + i; k < ends.w; k += invocationsOfTile) addPoints(sorted[k]);
    barrier();
  }
}

void main() {
  if (!enterTile(tileCount)) return;
  eta = mediumAt(body, targets[0].xyz).boundary.x;
  [[unroll]] for (uint t = 0u; t < maxClustersOfTile; ++t) {
    targetNormals[t] = texelOf(clusterTexels, 7 * int(min(tile.firstCluster + t, tile.endCluster - 1u)) + 1);
    tileLight[t] = vec3(0.0);
  }
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
