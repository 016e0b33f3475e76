// What leaves through the clusters of a tile after its first collision at a cluster's points of light, over α*/4π.
#ifndef OPALINE_LIB_SINGLE_POINTS
#define OPALINE_LIB_SINGLE_POINTS
#include "lib/beam_tile.glsl"
#include "lib/phase.glsl"

layout(constant_id = 0) const uint scattersEvenly = 1u;  // 0: some media do not

float eta;

void takeSurface() {
  eta = mediumAt(body, targets[0].xyz).boundary.x;
}

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

// Places near the surface are smoothed over the cluster, in the cosine as well as the distance. The way
// follows from the depth and that cosine. With z² + s for z² in both, all light from a depth z that
// clusters of a plane receive is ½ ∫ e^{-σ_t'z/μ} (1 - F_in) dμ as it should be, whatever the smoothing s.
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

vec3 fromPlaces(BeamPoint point, vec3 arrival, float smoothing, uint target) {
  vec3 extinction = way.extinction;
  return vec3(fromPlace(point.red.xyz, arrival, extinction.r, smoothing, target),
              fromPlace(point.green.xyz, arrival, extinction.g, smoothing, target),
              fromPlace(point.blue.xyz, arrival, extinction.b, smoothing, target));
}

// s for light that entered through a disc with that normal and, in w, radius, over ρ_i² + ρ_j². Light leaves only from
// within a cone. What comes through a thin part lies in all discs of the other side that the cone meets; with as little
// smoothing as on the same side it would be one or two of them, by chance. Of the same side's discs a cluster's own has
// most, exactly.
const float smoothingOfSame = 0.45;
const float smoothingOfOther = 1.5;
const float cosineOfSame = -0.5;  // between the normals, at least
const float cosineOfOther = -0.9;

float smoothingBetween(vec4 normal, uint target) {
  vec4 its = targetNormals[target];
  float other = smoothstep(-cosineOfSame, -cosineOfOther, -dot(normal.xyz, its.xyz));
  return mix(smoothingOfSame, smoothingOfOther, other) * (normal.w * normal.w + its.w * its.w);
}

void addNodeOf(BeamNode node, vec3 power) {
  BeamPoint middle = BeamPoint(node.redPower, node.greenLink, node.bluePower);
  [[unroll]] for (uint t = 0u; t < maxClustersOfTile; ++t)
    tileLight[t] += power * fromPlaces(middle, node.across.xyz, smoothingBetween(vec4(0.0), t), t);
}

// Adds points for that power.
void addPoints(uint cluster, vec3 strength) {
  uint beam = beamOf(cluster);
  uint count = unpackPointCounts(strengthOf(beam).w).x;
  Cluster from = clusters[cluster];
  vec3 power = strength * from.second.rgb;
  float smoothings[maxClustersOfTile];
  [[unroll]] for (uint t = 0u; t < maxClustersOfTile; ++t) smoothings[t] = smoothingBetween(from.normal, t);
  for (uint p = 0u; p < count; ++p) {
    BeamPoint point = readPoint(beam, p);
    uint without = p < pointsOfFirstSegment ? cluster - tile.firstCluster : noNode;
    vec3 arrival = scattersEvenly != 0u ? vec3(0.0) : arrivalAt(beam, p);
    [[unroll]] for (uint t = 0u; t < maxClustersOfTile; ++t) {
      vec3 leaves = power * shareOf(point) * fromPlaces(point, arrival, smoothings[t], t);
      if (t != without) tileLight[t] += leaves;
    }
  }
}

#endif
