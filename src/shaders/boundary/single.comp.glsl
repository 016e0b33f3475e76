// Light that leaves after its first collision, through every cluster:
// M₁ = α' Σ power e^{-σ_t'r} μ (1 - F_in(μ)) / 4πr², of the part whose second collisions are followed.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#include "lib/linear.glsl"
#include "lib/beam_walk.glsl"

const float furthestFreePaths = 8.0;

float eta;

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
float fromPlace(vec3 place, float extinction, float smoothing) {
  vec3 offset = its.centroidArea.xyz - place;
  float depth = dot(offset, its.normal.xyz);
  float over = inversesqrt(dot(offset, offset) + smoothing);
  float cosine = (sqrt(depth * depth + smoothing) + min(depth, 0.0)) * over;
  if (cosine <= medium.albedo.w) return 0.0;
  return exp(-extinction * max(depth, 0.0) / cosine) * over * over * cosine * leaving(cosine);
}

// Of light that entered through a disc of that radius, over both discs: on the other side of a thin
// part it lies just below clusters that are no nearer to each other.
vec3 fromPlaces(BeamPoint point, float radiusMm) {
  float smoothing = 0.5 * (its.normal.w * its.normal.w + radiusMm * radiusMm);
  vec3 extinction = medium.extinction.rgb;
  return vec3(fromPlace(point.red.xyz, extinction.r, smoothing),
              fromPlace(point.green.xyz, extinction.g, smoothing),
              fromPlace(point.blue.xyz, extinction.b, smoothing));
}

vec3 fromNode(BeamNode node, vec3 squared) {
  return node.power.rgb * fromPlaces(BeamPoint(node.redRadius, node.greenLink, node.blueSquare), 0.0);
}

// The cluster's own light as from a disc at its depth: ½ ∫ e^{-σ_t' z/μ} (1 - F_in) dμ, from the
// cosine to the disc's edge to 1, here times 4π; Gauss, four points.
float fromDisc(vec3 place, float extinction) {
  const float at[4] = float[4](0.0694318442, 0.3300094782, 0.6699905218, 0.9305681558);
  const float weight[4] = float[4](0.1739274226, 0.3260725774, 0.3260725774, 0.1739274226);
  float radius = its.normal.w;
  float depth = max(dot(its.centroidArea.xyz - place, its.normal.xyz), 0.0);
  float from = max(depth * inversesqrt(depth * depth + radius * radius + 1e-30), medium.albedo.w);
  float sum = 0.0;
  for (int k = 0; k < 4; ++k) {
    float cosine = from + at[k] * (1.0 - from);
    sum += weight[k] * exp(-extinction * depth / cosine) * leaving(cosine);
  }
  return 2.0 * pi / max(its.centroidArea.w, 1e-30) * (1.0 - from) * sum;
}

vec3 ownDiscs() {
  vec4 strength = strengths[receiver];
  uint count = min(unpackPointCounts(strength.w).x, pointsOfFirstSegment);
  vec3 extinction = medium.extinction.rgb;
  vec3 sum = vec3(0.0);
  for (uint p = 0u; p < count; ++p) {
    BeamPoint point = readPoint(receiver * maxPoints + p);
    sum += shareOf(point) * vec3(fromDisc(point.red.xyz, extinction.r),
                                 fromDisc(point.green.xyz, extinction.g),
                                 fromDisc(point.blue.xyz, extinction.b));
  }
  return strength.rgb * its.second.rgb * sum;
}

vec3 fromPoints(uint cluster) {
  vec4 strength = strengths[cluster];
  uint count = unpackPointCounts(strength.w).x;
  Cluster from = clusters[cluster];
  vec3 sum = vec3(0.0);
  for (uint p = cluster == receiver ? pointsOfFirstSegment : 0u; p < count; ++p) {
    BeamPoint point = readPoint(cluster * maxPoints + p);
    sum += shareOf(point) * fromPlaces(point, from.normal.w);
  }
  return strength.rgb * from.second.rgb * sum;
}

void main() {
  receive();
  eta = mediumAt(body, its.centroidArea.xyz).boundary.x;
  vec3 sum = beamSum(0.0, furthestFreePaths / leastOf(medium.extinction.rgb));
  if (hasOwnLeaf()) sum += ownDiscs();
  putSum(sum * (medium.albedo.rgb / (4.0 * pi)));
}
