// Where light that enters through a cluster first collides in the body. A light's collides along its
// refracted ray and that ray's reflections inside; light from everywhere, below the cluster.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 1
#define BINDING_MEDIA 2
#define BINDING_PIECE_CORNERS 3
#define BINDING_RAYS 4
#define BINDING_CLUSTER_PAINTS 15
#define BINDING_PEAKS 12
#define PEAKS_WRITTEN
#include "lib/frame.glsl"
#include "lib/area_light.glsl"
#include "lib/light.glsl"
#include "lib/linear.glsl"
#include "lib/peaks.glsl"
#include "lib/point_counts.glsl"
#include "lib/rays.glsl"
#include "lib/texels.glsl"
#include "lib/unit.glsl"

layout(std430, set = 0, binding = 5) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 6) readonly buffer Clusters { Cluster clusters[]; };
layout(std430, set = 0, binding = 7) buffer Entries { Entry entries[]; };
layout(std430, set = 0, binding = 8) writeonly buffer Points { BeamPoint points[]; };
layout(std430, set = 0, binding = 9) writeonly buffer Strengths { vec4 strengths[]; };

layout(std430, set = 0, binding = 10) readonly buffer ClusterOfSurfel { uint clusterOfSurfel[]; };
layout(std430, set = 0, binding = 11) writeonly buffer MirroredLight { Mirrored mirrored[]; };
layout(std430, set = 0, binding = 13) writeonly buffer Entered { vec4 entered[]; };
TEXELS(14, skyShares);  // of clusters
layout(std430, set = 0, binding = 16) readonly buffer OpaqueShares { OpaqueShare opaqueShares[]; };
layout(std430, set = 0, binding = 17) writeonly buffer Collisions { FirstCollision collisions[]; };

layout(std430, set = 0, binding = 18) buffer Strongest { uint strongest[]; };
layout(std430, set = 0, binding = 19) readonly buffer Withheld { float withheld[]; };

layout(constant_id = 0) const uint withPaint = 0u;
layout(constant_id = 1) const uint withLinings = 0u;
layout(constant_id = 2) const uint withThinParts = 0u;

layout(push_constant) uniform Push {
  uint clusterCount;
  uint firstLight;  // or the number of lights for light from everywhere
  uint lights;      // from that on
  uint piecesPerSurfel;
  uint nodeCount;  // of all surfels' trees
  uint mirrors;    // 1: what the surface does not let in goes on
};

const float leastShare = 0.005;      // of light that is followed further
const float leastEntryCosine = 0.05;  // to the mean normal where it enters

// Little light gets far before it collides, but on the other side of a thick part that is all there
// is. So points lie where light would collide in a medium thinner by this factor, and shares make up
// for it. Three points then sum e^{-t} e^{kt} over free paths t within 1 % for k up to 1/2, where
// quantiles of the light itself are 13 % too low.
const float thinner = 0.5;

#include "lib/beam_body.glsl"
#include "lib/through_bodies.glsl"

uint light;
uint beam;        // of the cluster and that light, among those found together
uint pointCount;  // so far

// Puts light that collides at these lengths along a ray. What is not followed further counts as a source further on.
void put(Body body, Cluster cluster, vec3 origin, vec3 direction, float lengthMm, vec3 lengths, vec3 shares) {
  vec3 onward = shareOfFirst(cluster) * forwards(body, lengthMm - lengths);
  vec3 ends = lengths + onward;
  points[beam * maxPoints + pointCount] =
      BeamPoint(vec4(origin + ends.r * direction, shares.r), vec4(origin + ends.g * direction, shares.g),
                vec4(origin + ends.b * direction, shares.b));
  if (cluster.second.rgb != vec3(0.0))
    collisions[beam * maxFirstPoints + pointCount] = FirstCollision(vec4(direction, 0.0), vec4(onward, 0.0));
  ++pointCount;
}

// Points and weights of Gauss.
const float threeAt[3] = float[3](0.112701665, 0.5, 0.887298335);
const float threeWeights[3] = float[3](5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0);
const float twoAt[2] = float[2](0.211324865, 0.788675135);

// `returns` is the part of what gets to either end that is mirrored there and goes to and fro, and `withheldThere` the
// part of the rest that the far end does not let out.
void firstSegment(Body body, Cluster cluster, vec3 origin, vec3 direction, float lengthMm, vec3 extinction,
                  float returns, float withheldThere) {
  vec3 less = thinner * extinction;
  vec3 within = 1.0 - exp(-less * lengthMm);
  vec3 lengths[pointsOfFirstSegment];
  vec3 shares[pointsOfFirstSegment];
  vec3 all = vec3(0.0);
  for (uint p = 0u; p < pointsOfFirstSegment; ++p) {
    lengths[p] = -log(1.0 - threeAt[p] * within) / less;
    shares[p] = threeWeights[p] * exp((less - extinction) * lengths[p]);
    all += shares[p];
  }
  vec3 passes = exp(-extinction * lengthMm);
  float returnsThere = mix(returns, 1.0, withheldThere);
  vec3 collides = (1.0 - passes) * (1.0 + returnsThere * passes) / (1.0 - returns * returnsThere * passes * passes);
  for (uint p = 0u; p < pointsOfFirstSegment; ++p)
    put(body, cluster, origin, direction, lengthMm, lengths[p], shares[p] / all * collides);
}

// A lining sends light on evenly. This is taken as light along its normal, on a way as much longer as
// its mean cosine asks for.
const float cosineOfEven = 2.0 / 3.0;

// 2C₁, reflected of even light.
float reflectedOfEven(Body body) {
  float critical = body.medium.albedo.w;
  return 1.0 - body.medium.extinction.w * (1.0 - critical * critical);
}

// How much goes on of light that meets a piece of the surface.
vec3 reflectedBy(uint piece, Body body, bool isEven, float cosine) {
  if (isLining(piece)) return givenBackBy(piece);
  return vec3(isEven ? reflectedOfEven(body) : reflectedInside(body, cosine));
}

void reflections(Body body, Cluster cluster, vec3 origin, vec3 direction, RayHit hit, vec3 extinction) {
  bool isEven = false;
  vec3 left = vec3(1.0);
  for (uint s = 1u; s <= maxReflections; ++s) {
    if (hit.piece == noPiece) return;
    vec3 normal = facetNormal(hit.piece);
    float cosine = abs(dot(direction, normal));
    left *= exp(-extinction * hit.distance) * reflectedBy(hit.piece, body, isEven, cosine);
    if (withPaint != 0u && !isLining(hit.piece))
      left *= throughPaint(clusterOfSurfel[hit.piece / piecesPerSurfel], body.medium, 0.5 * cosine);
    if (largestOf(left) < leastShare) return;
    origin += hit.distance * direction;
    isEven = isEven || isLining(hit.piece);
    direction = isEven ? -body.side * normal : reflect(direction, normal);
    if (isEven) extinction = body.medium.collision.rgb / cosineOfEven;
    hit = nextHit(body, origin, direction, 3e38);
    float lengthMm = min(hit.distance, 1e18);
    vec3 collides = 1.0 - exp(-extinction * lengthMm);
    for (uint p = 0u; p < pointsOfReflection; ++p)
      put(body, cluster, origin, direction, lengthMm, -log(1.0 - twoAt[p] * collides) / extinction, 0.5 * left * collides);
  }
}

// Light from everywhere goes straight inwards, and meets the other side of the body, or a lining.
void throughBody(uint i, Body body, Cluster cluster) {
  vec3 extinction = body.medium.collision.rgb / cluster.facet.w;
  RayHit hit = RayHit(0.0, noPiece);
  if (withLinings != 0u) hit = nextHit(body, cluster.start.xyz, -cluster.facet.xyz, 3e38);
  bool meetsLining = hit.piece != noPiece && isLining(hit.piece);
  firstSegment(body, cluster, cluster.centroidArea.xyz, -cluster.normal.xyz, cluster.start.w, extinction,
               meetsLining ? 0.0 : body.medium.scatters.w, meetsLining ? 0.0 : withheld[i]);
  if (meetsLining) reflections(body, cluster, cluster.start.xyz, -cluster.facet.xyz, hit, extinction);
}

// The mean cosine inside of light of a large area light, by four places that halve it each way.
float meanCosineInside(Body body, AreaView view, vec3 normal) {
  float sum = 0.0;
  float all = 0.0;
  for (uint i = 0u; i < 4u; ++i) {
    AreaSample place = sampleOf(view, 0.25 + 0.5 * vec2(i & 1u, i >> 1));
    float cosine = dot(place.offset, normal) * inversesqrt(max(dot(place.offset, place.offset), 1e-30));
    if (cosine <= 0.0) continue;
    float weight = place.weight * cosine * (1.0 - fresnelReflectance(body.eta, min(cosine, 1.0)));
    sum += weight * cosineInside(body.eta, cosine);
    all += weight;
  }
  return all > 0.0 ? sum / all : 0.0;
}

// Light that the surface does not let in goes on outside and may enter elsewhere.
Mirrored mirroredOf(Body body, Entry entry, vec3 from, vec3 power) {
  vec3 normal = entry.normal.xyz;
  float reflected = fresnelReflectance(body.eta, min(dot(from, normal), 1.0));
  vec3 direction = reflect(-from, normal);
  RayHit hit = nearestHit(entry.start.xyz, direction, body.least, 3e38,
                          RayTarget(0u, nodeCount, everyObject));
  Mirrored nothing = Mirrored(vec4(0.0), noCluster, 0u, 0u, 0u);
  if (hit.piece == noPiece) return nothing;
  uint cluster = clusterOfSurfel[hit.piece / piecesPerSurfel];
  float cosine = -windingOf(cluster) * dot(facetNormal(hit.piece), direction);
  if (cosine <= 0.0) return nothing;
  vec3 place = entry.start.xyz + hit.distance * direction;
  float eta = mediumAt(objects[ranges[cluster].object], place).boundary.x;
  float entering = 1.0 - fresnelReflectance(eta, min(cosine, 1.0));
  return Mirrored(vec4(power * entering * reflected / max(1.0 - reflected, 1e-6), 0.0), cluster,
                  0u, 0u, 0u);
}

// Light that one place of a cluster takes in if nothing is in its way.
struct Unhidden {
  vec3 entering;
  vec3 direction;  // unit, to the light
  float furthest;  // distance of the light, mm
};

Unhidden unhiddenAt(vec3 place, vec3 normal, MediumData medium) {
  if (light >= firstAreaLight())
    return Unhidden(areaEntering(light, place, normal, medium), directionOfArea(light, place, normal),
                    length(areaViewFrom(place, light).middle));
  IncidentLight incident = incidentLight(light, place);
  return Unhidden(incident.irradiance * enteringPart(incident, normal, normal, medium), incident.direction,
                  distanceOf(incident, place));
}

// Of the light that bodies hide from the cluster, what enters after it has gone through them unscattered.
vec3 enteringThroughBodies(Cluster cluster, Body body, MediumData medium, vec3 visible) {
  vec3 place = cluster.start.xyz;
  Unhidden all = unhiddenAt(place, cluster.facet.xyz, medium);
  float most = largestOf(all.entering);
  float hidden = 1.0 - largestOf(visible) / max(most, 1e-30);
  if (most <= 0.0 || hidden < leastHidden) return vec3(0.0);
  RayTarget scene = RayTarget(0u, nodeCount, everyObject);
  RayHit hit = nearestHit(place, all.direction, body.least, all.furthest, scene);
  if (!isThinAt(hit)) return vec3(0.0);
  return hidden * all.entering * throughBodies(place, all.direction, hit, body.least, all.furthest, scene).rgb;
}

void main() {
  beam = linearIndex();
  if (beam >= lights * clusterCount) return;
  uint i = beam % clusterCount;
  light = firstLight + beam / clusterCount;
  Cluster cluster = clusters[i];
  ObjectData itsBody = objects[ranges[i].object];
  Entry entry = entries[light * clusterCount + i];
  Body body = bodyAt(cluster, itsBody, entry.place.xyz);
  bool everywhere = light == frame.counts.w;
  if (withThinParts != 0u && !everywhere && ranges[i].kind != lining) {
    entry.irradiance.rgb += enteringThroughBodies(cluster, body, mediumAt(itsBody, cluster.start.xyz), entry.irradiance.rgb);
    entries[light * clusterCount + i].irradiance = entry.irradiance;
  }
  vec3 power = cluster.centroidArea.w * entry.irradiance.rgb;
  vec3 share = everywhere ? texelOf(skyShares, int(i)).rgb : vec3(1.0);
  noteEntered(everywhere ? peakOfEverywhere : peakOfFirstLight + light, share * entry.irradiance.rgb);
  if (everywhere) {
    entered[i] = vec4(share * entry.irradiance.rgb, 0.0);
    power *= share * (1.0 - shareAtSurface(cluster.start.w, body.medium));
  }
  pointCount = 0u;
  Mirrored goesOn = Mirrored(vec4(0.0), noCluster, 0u, 0u, 0u);
  float cosineInside = body.medium.sigma.w;
  if (everywhere) {
    throughBody(i, body, cluster);
  } else if (power != vec3(0.0)) {
    vec3 normal = entry.normal.xyz;
    vec3 toLight = light < firstAreaLight() ? incidentLight(light, entry.place.xyz).direction
                                           : directionOfArea(light, entry.place.xyz, normal);
    float cosine = dot(toLight, normal);
    vec3 from = unitOr(toLight + max(leastEntryCosine - cosine, 0.0) * normal, normal);
    vec3 direction = unitOr(refract(-from, normal, 1.0 / body.eta), -normal);
    cosineInside = -dot(direction, normal);
    RayHit hit = nextHit(body, entry.start.xyz, direction, 3e38);
    float longer = 1.0;  // all ways of the light to a depth, over that of its mean direction
    if (light >= firstAreaLight()) {
      float mean = meanCosineInside(body, areaViewFrom(entry.place.xyz, light), normal);
      if (mean > 0.0) longer = max(cosineInside / mean, 1.0);
    }
    firstSegment(body, cluster, entry.place.xyz, direction, min(hit.distance, 1e18),
                 longer * body.medium.collision.rgb, 0.0, 0.0);
    reflections(body, cluster, entry.start.xyz, direction, hit, body.medium.collision.rgb);
    if (mirrors != 0u) {
      goesOn = mirroredOf(body, entry, from, power);
      atomicMax(peaks[firstLight], floatBitsToUint(largestOf(goesOn.power.rgb)));
    }
  }
  if (mirrors != 0u) mirrored[beam] = goesOn;
  if (withPaint != 0u) power *= throughPaint(i, body.medium, cosineInside);
  bool isFollowed = cluster.second.rgb != vec3(0.0);
  if (isFollowed) atomicMax(strongest[0], floatBitsToUint(largestOf(power)));
  strengths[beam] = vec4(power, packPointCounts(pointCount, isFollowed ? secondPointsOf(pointCount, everywhere) : 0u));
}
