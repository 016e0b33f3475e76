// Where light that enters through a cluster collides in the body: of one light, along its refracted
// ray and that ray's reflections inside; or of what comes from everywhere, below the cluster.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 1
#define BINDING_MEDIA 2
#define BINDING_PIECE_CORNERS 3
#define BINDING_RAYS 4
#define BINDING_CLUSTER_PAINTS 15
#include "lib/boundary.glsl"
#include "lib/frame.glsl"
#include "lib/fresnel.glsl"
#include "lib/area_light.glsl"
#include "lib/light.glsl"
#include "lib/linear.glsl"
#include "lib/paint.glsl"
#include "lib/phase.glsl"
#include "lib/point_counts.glsl"
#include "lib/rays.glsl"
#include "lib/unit.glsl"

layout(std430, set = 0, binding = 5) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 6) readonly buffer Clusters { Cluster clusters[]; };
layout(std430, set = 0, binding = 7) readonly buffer Entries { Entry entries[]; };
layout(std430, set = 0, binding = 8) writeonly buffer Points { BeamPoint points[]; };
layout(std430, set = 0, binding = 9) writeonly buffer Strengths { vec4 strengths[]; };

layout(std430, set = 0, binding = 10) readonly buffer ClusterOfSurfel { uint clusterOfSurfel[]; };
layout(std430, set = 0, binding = 11) writeonly buffer MirroredLight { Mirrored mirrored[]; };
layout(std430, set = 0, binding = 12) buffer Peaks { uint peaks[]; };  // of lights
layout(std430, set = 0, binding = 13) writeonly buffer Entered { vec4 entered[]; };
layout(std430, set = 0, binding = 14) readonly buffer SkyShares { vec4 skyShares[]; };
layout(std430, set = 0, binding = 16) readonly buffer OpaqueShares { OpaqueShare opaqueShares[]; };

layout(constant_id = 0) const uint withPaint = 0u;
layout(constant_id = 1) const uint withLinings = 0u;

layout(push_constant) uniform Push {
  uint clusterCount;
  uint firstLight;  // or the number of lights for what comes from everywhere
  uint lights;      // from that on
  uint piecesPerSurfel;
  uint nodeCount;  // of all surfels' trees
  uint mirrors;    // 1: what the surface does not let in goes on
};

const float leastShare = 0.005;      // of light that is followed further
const float leastEntryCosine = 0.05;  // to the mean normal where it enters
const uint meetingsOfPath = 3u;      // reflections on the way to a second collision

// Little light gets far before it collides; but to the other side of a thick part that is all there
// is. So points lie where light would collide in a medium thinner by these factors, and shares make
// up for it: three points then sum e^{-t} e^{kt} over free paths t within 1 % for k up to 1/2, where
// quantiles of the light itself are 13 % too low.
const float thinnerForFirst = 0.5;
const float thinnerForSecond = 0.7;

struct Body {
  BoundaryMedium medium;
  float eta;
  RayTarget target;
  float side;   // -1 where it is mirrored
  float least;  // rays start that far from where they leave, mm
};

uint firstPieceOf(uint object) {
  return objects[object].table.y * piecesPerSurfel;
}

uint light;
uint beam;           // of the cluster and that light, among those that are found together
uint pointCount[2];  // of first and second collisions so far

void put(uint order, BeamPoint point) {
  points[beam * maxPoints + order * maxFirstPoints + pointCount[order]] = point;
  ++pointCount[order];
}

float reflectedInside(Body body, float cosine) {
  return fresnelReflectance(1.0 / body.eta, min(cosine, 1.0));
}

bool isLining(uint piece) {
  return withLinings != 0u && ranges[clusterOfSurfel[piece / piecesPerSurfel]].kind == lining;
}

vec3 givenBackBy(uint piece) {
  return min(opaqueShares[clusterOfSurfel[piece / piecesPerSurfel]].share.rgb, vec3(1.0));
}

RayHit nextHit(Body body, vec3 origin, vec3 direction, float furthest) {
  return nearestExit(origin, direction, body.side, body.least, furthest, body.target);
}

// Light that scatters forwards is, to diffusion, a source that much further on, mm; in front of a surface
// at that distance as far as free paths end before it.
vec3 forwards(Body body, vec3 leftMm) {
  if (body.medium.collision.w == 0.0) return vec3(0.0);
  vec3 whole = body.medium.collision.w / body.medium.extinction.rgb;
  return whole * (1.0 - exp(-leftMm / abs(whole)));
}
const float endOfForwards = 4.0;  // in free paths; less than 2 % is left

// Goes on from `origin` for a path's length, mirrored where it meets the surface; what leaves there
// is taken off the share.
vec4 collisionAfter(Body body, vec3 origin, vec3 direction, float path, float share, int channel) {
  float free = endOfForwards * body.medium.collision.w / body.medium.extinction[channel];
  for (uint k = 0u; k <= meetingsOfPath; ++k) {
    RayHit hit = nextHit(body, origin, direction, path + max(free, 0.0));
    if (hit.piece == noPiece || hit.distance > path) {
      float left = hit.piece == noPiece ? abs(free) : hit.distance - path;
      return vec4(origin + (path + forwards(body, vec3(left))[channel]) * direction, share);
    }
    vec3 normal = facetNormal(hit.piece);
    origin += hit.distance * direction;
    path -= hit.distance;
    // Evenly scattered light that is mirrored at a lining leaves it as light that goes on evenly from there.
    share *= isLining(hit.piece) ? givenBackBy(hit.piece)[channel]
                                 : reflectedInside(body, abs(dot(direction, normal)));
    direction = reflect(direction, normal);
    if (share <= 0.0) break;
  }
  return vec4(origin, 0.0);
}

// The second collisions of light that arrived at `point` along `arrival` and collided there, the `which`-th of
// its cluster: by the phase function and as far as free paths go, by a lattice of low discrepancy (Roberts
// 2018) in the axes of the cluster, so that it moves with that. Another shift for each point: what few
// directions miss, those beside have.
void scatterOn(Body body, uint i, Cluster cluster, BeamPoint point, vec3 arrival, uint which, uint count) {
  const vec2 next = vec2(0.7548776662, 0.5698402910);
  const vec3 shifts = vec3(0.8191725134, 0.6710436067, 0.5497004779);
  vec3 shift = fract(float((i * maxFirstPoints + which) % 8192u) * shifts);
  float g = body.medium.collision.w;
  vec3 axis = g == 0.0 ? cluster.facet.xyz : arrival;
  vec3 along = g == 0.0 ? cluster.along.xyz
                        : unitOr(cluster.along.xyz - dot(cluster.along.xyz, axis) * axis, cluster.facet.xyz);
  vec3 across = cross(axis, along);
  vec3 followed = cluster.second.rgb;
  for (uint d = 0u; d < count; ++d) {
    float part = (float(d) + shift.x) / float(count);
    float z = g == 0.0 ? 1.0 - 2.0 * part : cosineOfPart(part, g);
    vec2 at = fract(shift.yz + float(d) * next);
    float angle = 2.0 * pi * at.x;
    vec3 around = cos(angle) * along + sin(angle) * across;
    vec3 direction = sqrt(max(1.0 - z * z, 0.0)) * around + z * axis;
    float depth = -log(max(1.0 - at.y, 1e-6)) / thinnerForSecond;
    float share = exp((thinnerForSecond - 1.0) * depth) / (thinnerForSecond * float(count));
    vec4 ends[3] = vec4[3](point.red, point.green, point.blue);
    for (int c = 0; c < 3; ++c)
      ends[c] = followed[c] > 0.0 && ends[c].w > 0.0
                    ? collisionAfter(body, ends[c].xyz, direction,
                                     depth / body.medium.collision[c], share * ends[c].w, c)
                    : vec4(ends[c].xyz, 0.0);
    put(1u, BeamPoint(ends[0], ends[1], ends[2]));
  }
}

// The three places for a quantile of the light that collides within a length.
BeamPoint pointAt(vec3 origin, vec3 direction, vec3 lengths, vec3 shares) {
  return BeamPoint(vec4(origin + lengths.r * direction, shares.r),
                   vec4(origin + lengths.g * direction, shares.g),
                   vec4(origin + lengths.b * direction, shares.b));
}

// Gauss's points and weights.
const float threeAt[3] = float[3](0.112701665, 0.5, 0.887298335);
const float threeWeights[3] = float[3](5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0);
const float twoAt[2] = float[2](0.211324865, 0.788675135);

void firstSegment(Body body, uint i, Cluster cluster, vec3 origin, vec3 direction, float lengthMm,
                  vec3 extinction) {
  vec3 thinner = thinnerForFirst * extinction;
  vec3 within = 1.0 - exp(-thinner * lengthMm);
  vec3 lengths[pointsOfFirstSegment];
  vec3 shares[pointsOfFirstSegment];
  vec3 all = vec3(0.0);
  for (uint p = 0u; p < pointsOfFirstSegment; ++p) {
    lengths[p] = -log(1.0 - threeAt[p] * within) / thinner;
    shares[p] = threeWeights[p] * exp((thinner - extinction) * lengths[p]);
    all += shares[p];
  }
  vec3 collides = 1.0 - exp(-extinction * lengthMm);
  bool further = cluster.second.rgb != vec3(0.0);
  for (uint p = 0u; p < pointsOfFirstSegment; ++p) {
    vec3 share = shares[p] / all * collides;
    vec3 onward = shareOfFirst(cluster) * forwards(body, lengthMm - lengths[p]);
    put(0u, pointAt(origin, direction, lengths[p] + onward, share));
    if (further) scatterOn(body, i, cluster, pointAt(origin, direction, lengths[p], share), direction, p, directionsOfPoint);
  }
}

// Of a beam with that cosine inside.
vec3 throughPaint(uint cluster, Body body, float cosine) {
  return throughLayer(clusterPaints[cluster].entering.rgb, body.medium.sigma.w, cosine);
}

// A lining sends light on evenly: along its normal, by a way as much longer as its mean cosine asks for.
const float cosineOfEven = 2.0 / 3.0;

// Of light that comes evenly, 2C₁.
float reflectedOfEven(Body body) {
  float critical = body.medium.albedo.w;
  return 1.0 - body.medium.extinction.w * (1.0 - critical * critical);
}

// Of light that meets a piece of the surface, how much goes on.
vec3 reflectedBy(uint piece, Body body, bool isEven, float cosine) {
  if (isLining(piece)) return givenBackBy(piece);
  return vec3(isEven ? reflectedOfEven(body) : reflectedInside(body, cosine));
}

void reflections(Body body, uint i, Cluster cluster, vec3 origin, vec3 direction, RayHit hit, vec3 extinction) {
  bool further = cluster.second.rgb != vec3(0.0);
  bool isEven = false;
  vec3 left = vec3(1.0);
  for (uint s = 1u; s <= maxReflections; ++s) {
    if (hit.piece == noPiece) return;
    vec3 normal = facetNormal(hit.piece);
    float cosine = abs(dot(direction, normal));
    left *= exp(-extinction * hit.distance) * reflectedBy(hit.piece, body, isEven, cosine);
    if (withPaint != 0u && !isLining(hit.piece))
      left *= throughPaint(clusterOfSurfel[hit.piece / piecesPerSurfel], body, 0.5 * cosine);
    if (largestOf(left) < leastShare) return;
    origin += hit.distance * direction;
    isEven = isEven || isLining(hit.piece);
    direction = isEven ? -body.side * normal : reflect(direction, normal);
    if (isEven) extinction = body.medium.collision.rgb / cosineOfEven;
    hit = nextHit(body, origin, direction, 3e38);
    float lengthMm = min(hit.distance, 1e18);
    vec3 collides = 1.0 - exp(-extinction * lengthMm);
    for (uint p = 0u; p < pointsOfReflection; ++p) {
      vec3 lengths = -log(1.0 - twoAt[p] * collides) / extinction;
      vec3 share = 0.5 * left * collides;
      vec3 onward = shareOfFirst(cluster) * forwards(body, lengthMm - lengths);
      put(0u, pointAt(origin, direction, lengths + onward, share));
      uint which = pointsOfFirstSegment + (s - 1u) * pointsOfReflection + p;
      if (further) scatterOn(body, i, cluster, pointAt(origin, direction, lengths, share), direction, which, 1u);
    }
  }
}

// Of light from everywhere, what a lining below the cluster gives back.
void backFromLining(Body body, uint i, Cluster cluster, vec3 extinction) {
  RayHit hit = nextHit(body, cluster.start.xyz, -cluster.facet.xyz, 3e38);
  if (hit.piece != noPiece && isLining(hit.piece))
    reflections(body, i, cluster, cluster.start.xyz, -cluster.facet.xyz, hit, extinction);
}

// Of light of a large area light, the mean cosine inside: by four places that halve it each way.
float meanCosineInside(Body body, AreaView view, vec3 normal) {
  float sum = 0.0;
  float all = 0.0;
  for (uint i = 0u; i < 4u; ++i) {
    AreaSample place = sampleOf(view, 0.25 + 0.5 * vec2(i & 1u, i >> 1));
    float cosine = dot(place.offset, normal) * inversesqrt(max(dot(place.offset, place.offset), 1e-30));
    if (cosine <= 0.0) continue;
    float weight = place.weight * cosine * (1.0 - fresnelReflectance(body.eta, min(cosine, 1.0)));
    sum += weight * sqrt(1.0 - (1.0 - cosine * cosine) / (body.eta * body.eta));
    all += weight;
  }
  return all > 0.0 ? sum / all : 0.0;
}

// What the surface does not let in goes on outside and may enter elsewhere.
Mirrored mirroredOf(Body body, Entry entry, vec3 from, vec3 power) {
  vec3 normal = entry.normal.xyz;
  float reflected = fresnelReflectance(body.eta, min(dot(from, normal), 1.0));
  vec3 direction = reflect(-from, normal);
  RayHit hit = nearestHit(entry.start.xyz, direction, body.least, 3e38,
                          RayTarget(0u, nodeCount, everyObject));
  Mirrored nothing = Mirrored(vec4(0.0), noCluster, 0u, 0u, 0u);
  if (hit.piece == noPiece) return nothing;
  uint cluster = clusterOfSurfel[hit.piece / piecesPerSurfel];
  float cosine = -clusters[cluster].along.w * dot(facetNormal(hit.piece), direction);
  if (cosine <= 0.0) return nothing;
  vec3 place = entry.start.xyz + hit.distance * direction;
  float eta = mediumAt(objects[ranges[cluster].object], place).boundary.x;
  float entering = 1.0 - fresnelReflectance(eta, min(cosine, 1.0));
  return Mirrored(vec4(power * entering * reflected / max(1.0 - reflected, 1e-6), 0.0), cluster,
                  0u, 0u, 0u);
}

void main() {
  beam = linearIndex();
  if (beam >= lights * clusterCount) return;
  uint i = beam % clusterCount;
  light = firstLight + beam / clusterCount;
  Cluster cluster = clusters[i];
  ObjectData itsBody = objects[ranges[i].object];
  RayTarget target = RayTarget(itsBody.tree.x, itsBody.tree.w, itsBody.body.x);
  Entry entry = entries[light * clusterCount + i];
  float eta = mediumAt(itsBody, entry.place.xyz).boundary.x;
  Body body = Body(insideOf(itsBody), eta, target, cluster.along.w, rayStartOf(cluster));
  vec3 power = cluster.centroidArea.w * entry.irradiance.rgb;
  bool everywhere = light == frame.counts.w;
  if (everywhere) {
    if (beam == 0u)
      for (uint l = 0u; l < maxLights; ++l) peaks[l] = 0u;  // for the next frame
    vec3 share = skyShares[i].rgb;
    entered[i] = vec4(share * entry.irradiance.rgb, 0.0);
    power *= share * (1.0 - shareAtSurface(cluster.start.w, body.medium));
  }
  pointCount[0] = 0u;
  pointCount[1] = 0u;
  Mirrored goesOn = Mirrored(vec4(0.0), noCluster, 0u, 0u, 0u);
  float cosineInside = body.medium.sigma.w;
  if (everywhere) {
    vec3 extinction = body.medium.collision.rgb / cluster.facet.w;
    firstSegment(body, i, cluster, cluster.centroidArea.xyz, -cluster.normal.xyz, cluster.start.w, extinction);
    if (withLinings != 0u) backFromLining(body, i, cluster, extinction);
  } else if (power != vec3(0.0)) {
    vec3 normal = entry.normal.xyz;
    vec3 toLight = light < firstAreaLight() ? incidentLight(light, entry.place.xyz).direction
                                           : directionOfArea(light, entry.place.xyz, normal);
    float cosine = dot(toLight, normal);
    vec3 from = unitOr(toLight + max(leastEntryCosine - cosine, 0.0) * normal, normal);
    vec3 direction = unitOr(refract(-from, normal, 1.0 / body.eta), -normal);
    cosineInside = -dot(direction, normal);
    RayHit hit = nextHit(body, entry.start.xyz, direction, 3e38);
    float longer = 1.0;  // the ways of all the light to a depth, over that of its mean direction
    if (light >= firstAreaLight()) {
      float mean = meanCosineInside(body, areaViewFrom(entry.place.xyz, light), normal);
      if (mean > 0.0) longer = max(cosineInside / mean, 1.0);
    }
    firstSegment(body, i, cluster, entry.place.xyz, direction, min(hit.distance, 1e18),
                 longer * body.medium.collision.rgb);
    reflections(body, i, cluster, entry.start.xyz, direction, hit, body.medium.collision.rgb);
    if (mirrors != 0u) {
      goesOn = mirroredOf(body, entry, from, power);
      atomicMax(peaks[firstLight], floatBitsToUint(largestOf(goesOn.power.rgb)));
    }
  }
  if (mirrors != 0u) mirrored[beam] = goesOn;
  if (withPaint != 0u) power *= throughPaint(i, body, cosineInside);
  strengths[beam] = vec4(power, packPointCounts(pointCount[0], pointCount[1]));
}
