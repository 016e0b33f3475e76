// Rays from every cluster that depend on nothing but the shape: inwards, how thick the body is, and
// outwards, what of the scene it sees.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_PIECE_CORNERS 2
#define BINDING_RAYS 3
#define BINDING_SKY_RADIANCE 8
#define BINDING_CLUSTER_PAINTS 11
#define BINDING_CLUSTER_NODES 13
#include "lib/boundary.glsl"
#include "lib/cluster_node.glsl"
#include "lib/cluster_weight.glsl"
#include "lib/escape.glsl"
#include "lib/fresnel.glsl"
#include "lib/linear.glsl"
#include "lib/lanes.glsl"
#include "lib/meeting_behind.glsl"
#include "lib/over_or_0.glsl"
#include "lib/rays.glsl"
#include "lib/sky.glsl"
#include "lib/unit.glsl"

layout(std430, set = 0, binding = 4) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 5) buffer Clusters { Cluster clusters[]; };
layout(std430, set = 0, binding = 6) readonly buffer ClusterOfSurfel { uint clusterOfSurfel[]; };
layout(std430, set = 0, binding = 7) buffer Meetings { Meeting meetings[]; };

layout(std430, set = 0, binding = 9) writeonly buffer SkyShares { vec4 skyShares[]; };

layout(std430, set = 0, binding = 10) readonly buffer Bright { BrightSky brightSky; };
layout(std430, set = 0, binding = 12) buffer SkySums { SkySum skySums[]; };  // over earlier rays

layout(std430, set = 0, binding = 14) buffer MeetingsBehind { MeetingBehind behind[]; };
layout(std430, set = 0, binding = 15) writeonly buffer Withheld { float withheld[]; };

layout(constant_id = 0) const uint withThinParts = 0u;
layout(constant_id = 1) const uint withPaint = 0u;

layout(push_constant) uniform Push {
  uint clusterCount;
  uint piecesPerSurfel;
  uint raysOutwards;  // of each cluster
  uint nodeCount;     // of all surfels' trees
  uint firstRay;      // of those that are sent now
  uint endRay;
};

// Part of the light that is followed to its second collision. Where little of it scatters again, diffusion from the
// first collision is too rough.
vec3 shareOfSecond(BoundaryMedium medium, float edge) {
  return (1.0 - whitenessOf(medium)) * (1.0 - coarsenessOf(medium, edge));
}

float transmittedInto(float eta, float cosine) {
  return 1.0 - fresnelReflectance(eta, cosine);
}

// The k-th of many directions about a normal, as dense as their cosine; `along` turns them. One part of
// `shift`, in [0, 1), turns them as well; the other goes through the heights of each.
vec3 cosineDirection(uint k, uint count, vec2 shift, vec3 normal, vec3 along) {
  const float golden = 2.39996322972865;
  float squared = (float(k) + shift.x) / float(count);
  float angle = golden * float(k) + 2.0 * pi * shift.y;
  vec3 across = cross(normal, along);
  return sqrt(squared) * (cos(angle) * along + sin(angle) * across) + sqrt(1.0 - squared) * normal;
}

// A different shift for each cluster, so that what its few rays miss its neighbours' have (the
// points are R₂, Roberts 2018).
vec2 shiftOf(uint cluster) {
  return fract(float(cluster % 4096u) * vec2(0.7548776662, 0.5698402910));
}

uint firstPieceOf(uint object) {
  return objects[object].table.y * piecesPerSurfel;
}

#include "lib/through_bodies.glsl"

// Where what the k-th ray of a cluster meets behind thin parts is noted.
uint firstBehind(uint cluster, uint k) {
  return (cluster * raysOutwards + k) * meetingsBehind;
}

struct PieceFrame {
  vec3 middle;
  vec3 normal;
  vec3 along;
};

PieceFrame frameOf(uint piece, float side) {
  vec3 a = texelOf(pieceCorners, 3 * int(piece)).xyz;
  vec3 b = texelOf(pieceCorners, 3 * int(piece) + 1).xyz;
  vec3 c = texelOf(pieceCorners, 3 * int(piece) + 2).xyz;
  return PieceFrame((a + b + c) / 3.0, side * unitOr(cross(b - a, c - a), vec3(0.0)),
                    unitOr(b - a, vec3(0.0)));
}

const float clustersTogether = 8.0;

const float cosineOfSlant = 0.4;

// Half of the rays go to bright parts of the sky, where it has some; the others are as dense as the cosine. Each
// counts by the balance heuristic (Veach and Guibas 1995).
uint raysToBright() {
  return brightSky.light.y > 0.0 ? raysOutwards / 2u : 0u;
}

// Always the same for a cluster, so that nothing jumps while it moves. Rays below its horizon are not sent.
vec3 brightDirection(uint k, uint count, float shift) {
  return brightSky.towards[min(uint((float(k) + shift) / float(count) * float(brightDirections)), brightDirections - 1u)].xyz;
}

// The density of all rays of a cluster, per solid angle.
float densityOfRays(vec3 direction, float cosine) {
  uint bright = raysToBright();
  float density = float(raysOutwards - bright) / pi * max(cosine, 0.05);
  if (bright == 0u) return density;
  vec3 radiance = skyRadianceFrom(direction, 0.0);
  float above = max(radiance.r + radiance.g + radiance.b - brightSky.light.x, 0.0);
  return density + float(bright) * above / brightSky.light.y;
}

// A ray outwards, and the light from its direction that enters.
struct RayOutwards {
  vec3 origin;
  vec3 normal;  // of the surface there
  vec3 direction;
  float eta;
  float cosine;    // outside
  float entering;  // of even light
  vec3 radiance;   // of the sky, times that
};

// The k-th ray. Each kind of ray comes from all over the cluster. Directions go in other steps than places over it.
RayOutwards rayOutwards(uint i, uint k, Cluster cluster, ClusterRange range, ObjectData own) {
  uint first = range.firstSurfel * piecesPerSurfel;
  uint count = range.endSurfel * piecesPerSurfel - first;
  uint toBright = raysToBright();
  uint aboutNormal = raysOutwards - toBright;
  bool isAboutNormal = k < aboutNormal;
  uint kind = isAboutNormal ? aboutNormal : toBright;  // how many rays of it there are
  uint which = isAboutNormal ? k : k - aboutNormal;
  PieceFrame place = frameOf(first + (2u * which + 1u) * count / (2u * kind), cluster.along.w);
  if (place.normal == vec3(0.0)) place = PieceFrame(cluster.start.xyz, cluster.facet.xyz, cluster.along.xyz);
  vec3 direction = isAboutNormal ? cosineDirection((which * 7u) % kind, kind, shiftOf(i), place.normal, place.along)
                                 : brightDirection((which * 7u) % kind, kind, shiftOf(i).x);
  float eta = mediumAt(own, place.middle).boundary.x;
  float outside = dot(direction, place.normal);
  if (outside <= 0.0) return RayOutwards(place.middle, place.normal, direction, eta, outside, 0.0, vec3(0.0));
  float density = densityOfRays(direction, outside);
  float entering = transmittedInto(eta, outside) * outside / density;
  // Surfels use the rays of several clusters around them, so each stands for less than it would alone.
  vec3 radiance = entering * skyRadianceFrom(direction, 1.0 / (clustersTogether * density));
  return RayOutwards(place.middle, place.normal, direction, eta, outside, entering, radiance);
}

// Light of a small body far away is met by few rays, and then by one ray too many or none. A cluster's neighbours make up
// for that, but not where clusters are as large as the horizon's. So a ray stands for at most this many times the body.
const float bodiesOfRay = 16.0;

// How much of all even light that arrives at a place comes from a body at most: that of a ball around it which touches
// the horizon, or lies above it.
float largestShareOf(ObjectData body, vec3 place, vec3 normal) {
  vec3 towards = centroidLinkOf(body.clusters.x).xyz - place;
  float away = max(length(towards), 1e-15);
  float ratio = spreadOf(body.clusters.x).x / away;
  return ratio * ratio * min(max(dot(towards, normal) / away, ratio), 1.0);
}

// How far interpolation between clusters reaches, rounded up.
const float closeInEdges = 3.0;

const SkySum noSky = SkySum(vec4(0.0), vec4(0.0), 0.0, 0.0, 0.0, 0.0);

void addFree(vec3 part, RayOutwards ray, inout SkySum sum) {
  sum.free += vec4(ray.radiance * part, ray.entering * (part.r + part.g + part.b) / 3.0);
  sum.slant += dot(ray.radiance, part) * cosineInside(ray.eta, ray.cosine);
}

// The cluster that a ray meets, the part of its light that enters by this ray, and what is transmitted there.
Meeting meetingAt(RayHit hit, RayOutwards ray) {
  ObjectData met = objects[objectOfPiece(hit.piece)];
  uint cluster = clusterOfSurfel[hit.piece / piecesPerSurfel];
  float cosine = -windingOf(cluster) * dot(facetNormal(hit.piece), ray.direction);
  if (cosine < 0.0 && hasBack(met)) {
    cluster = backOf(cluster, met);
    cosine = -cosine;
  }
  if (cosine <= 0.0) return Meeting(noCluster, 0.0, 0.0);
  MediumData other = mediumAt(met, ray.origin + hit.distance * ray.direction);
  float entering = min(ray.entering, bodiesOfRay * pi * largestShareOf(met, ray.origin, ray.normal));
  return Meeting(cluster, entering / (other.inside.extinction.w * pi), transmittedInto(other.boundary.x, cosine));
}

// Adds what comes from behind a thin part of a body along a ray, and notes what is met there, from `first` on.
void lookBehind(RayOutwards ray, RayHit hit, float least, RayTarget scene, uint first, inout SkySum sum) {
  Crossing its = crossingFrom(hit, 3e38);
  uint count = 0u;
  while (its.hit.piece != noPiece && passesSurface(ray.origin, ray.direction, least, 3e38, scene, its)) {
    if (!isOutside(its) || its.hit.piece == noPiece || count == meetingsBehind) continue;
    Meeting meeting = meetingAt(its.hit, ray);
    if (meeting.cluster == noCluster) continue;
    behind[first + count++] = meetingBehind(meeting.cluster, vec4(meeting.share * its.through, meeting.transmitted));
  }
  if (isThrough(its)) addFree(its.through, ray, sum);
}

// Does so for some of the lane's rays: those in `thin`, a bit for each.
void lookThrough(uvec2 thin, uint i, uint lane, Cluster cluster, ClusterRange range, inout SkySum sum) {
  ObjectData own = objects[range.object];
  float least = rayStartOf(cluster);
  RayTarget scene = RayTarget(0u, nodeCount, everyObject);
  while (any(notEqual(thin, uvec2(0u)))) {
    uint word = thin.x != 0u ? 0u : 1u;
    uint bit = findLSB(thin[word]);
    thin[word] &= thin[word] - 1u;
    uint k = firstRay + lane + (32u * word + bit) * lanes;
    RayOutwards ray = rayOutwards(i, k, cluster, range, own);
    RayHit hit = nearestHit(ray.origin, ray.direction, least, 3e38, scene);
    lookBehind(ray, hit, least, scene, firstBehind(i, k), sum);
  }
}

// Sums every `lanes`-th ray of the cluster that is sent now, from `lane` on.
SkySum lookAround(uint i, uint lane, Cluster cluster, ClusterRange range) {
  ObjectData own = objects[range.object];
  float least = rayStartOf(cluster);
  RayTarget scene = RayTarget(0u, nodeCount, everyObject);
  SkySum sum = noSky;
  uvec2 thin = uvec2(0u);  // rays that meet what light may get through
  for (uint k = firstRay + lane; k < endRay; k += lanes) {
    meetings[i * raysOutwards + k] = Meeting(noCluster, 0.0, 0.0);
    if (withThinParts != 0u)
      for (uint n = 0u; n < meetingsBehind; ++n) behind[firstBehind(i, k) + n].cluster = noCluster;
    if (range.kind == lining) continue;  // within a body
    RayOutwards ray = rayOutwards(i, k, cluster, range, own);
    if (ray.cosine <= 0.0) continue;
    RayHit hit = nearestHit(ray.origin, ray.direction, least, 3e38, scene);
    sum.all += vec4(ray.radiance, ray.entering);
    if (hit.piece == noPiece) {
      addFree(vec3(1.0), ray, sum);
    } else {
      uint turn = (k - firstRay) / lanes;
      if (withThinParts != 0u && isThinAt(hit)) thin[turn / 32u] |= 1u << turn % 32u;
      sum.nearness += 1.0 / max(hit.distance, least);
      sum.meets += 1.0;
      if (hit.distance < closeInEdges * edgeOf(cluster)) sum.closeEven += ray.entering;
      meetings[i * raysOutwards + k] = meetingAt(hit, ray);
    }
  }
  if (withThinParts != 0u) lookThrough(thin, i, lane, cluster, range, sum);
  return sum;
}

SkySum sumOfLanes(SkySum part) {
  vec4 others = sumOfLanes(vec4(part.slant, part.nearness, part.meets, part.closeEven));
  return SkySum(sumOfLanes(part.free), sumOfLanes(part.all), others.x, others.y, others.z, others.w);
}

SkySum together(SkySum a, SkySum b) {
  return SkySum(a.free + b.free, a.all + b.all, a.slant + b.slant, a.nearness + b.nearness, a.meets + b.meets,
                a.closeEven + b.closeEven);
}

RayHit otherSide(vec3 place, vec3 direction, Cluster cluster, ObjectData body) {
  return nearestExit(place, direction, cluster.along.w, rayStartOf(cluster), 3e38,
                     RayTarget(body.tree.x, body.tree.w, body.body.x));
}

float thicknessOf(RayHit through) {
  return through.piece == noPiece ? 1e18 : through.distance;
}

// From the concave side of a bent wall the way at a slant is shorter. The wall guides light as far as a flat one does.
const float stillParallel = 1.15;

// How nearly parallel to a place the other side is, if it mirrors; a lining does not.
float parallelTo(PieceFrame place, vec3 aside, RayHit through, Cluster cluster, ObjectData body) {
  if (through.piece == noPiece || ranges[clusterOfSurfel[through.piece / piecesPerSurfel]].kind == lining) return 0.0;
  vec3 slanting = sqrt(1.0 - cosineOfSlant * cosineOfSlant) * aside - cosineOfSlant * place.normal;
  float way = thicknessOf(otherSide(place.middle, slanting, cluster, body));
  return min(stillParallel * cosineOfSlant * way / max(through.distance, 1e-30), 1.0);
}

// How much of the even light that enters and comes to the other side is mirrored there altogether because that side is
// concave, as around a hollow. Light that has entered at a slant meets such a side at a wider angle than it has entered.
float withheldBy(RayHit through) {
  if (through.piece == noPiece) return 0.0;
  float curvature = clusters[clusterOfSurfel[through.piece / piecesPerSurfel]].escape.w;
  float sine = 1.0 / (1.0 + through.distance * max(-curvature, 0.0));
  return 1.0 - sine * sine;
}

// Means over places all over the cluster, of what thickness does to light that leaves; w: of what is withheld. The last
// lanes take them, because they have the fewest rays outwards.
vec4 lookWithin(uint lane, Cluster cluster, ClusterRange range, ObjectData body) {
  if (range.kind != bodyWithInside) return vec4(0.0);
  uint first = range.firstSurfel * piecesPerSurfel;
  uint count = range.endSurfel * piecesPerSurfel - first;
  vec4 sum = vec4(0.0);
  for (uint k = lanes - 1u - lane; k < placesInwards; k += lanes) {
    PieceFrame place = frameOf(first + (2u * k + 1u) * count / (2u * placesInwards), cluster.along.w);
    if (place.normal == vec3(0.0)) place = PieceFrame(cluster.start.xyz, cluster.facet.xyz, cluster.along.xyz);
    RayHit through = otherSide(place.middle, -place.normal, cluster, body);
    vec3 aside = k % 2u == 0u ? place.along : cross(place.normal, place.along);
    float parallel = parallelTo(place, k % 4u < 2u ? aside : -aside, through, cluster, body);
    sum += vec4(escapeByThickness(insideOf(body), thicknessOf(through), parallel), parallel * withheldBy(through));
  }
  return sum / float(placesInwards);
}

// A covered cluster, as between a poster and its wall, is not seen, and says nothing of the layer above it
// that faces the same way. It counts only where there is no other.
const float leastOpenness = 1e-3;

// Almost 0 for a cluster that sees next to nothing of the sky because something lies very close.
float opennessOf(SkySum sum) {
  float close = sum.closeEven / max(sum.all.w, 1e-30);
  float free = sum.free.w / max(sum.all.w, 1e-30);
  return mix(1.0, leastOpenness, smoothstep(0.6, 0.9, close) * (1.0 - smoothstep(0.02, 0.1, free)));
}

// Writes what is then known of a cluster. Without rays it sees all of the sky, and from within a body nothing.
void put(uint i, Cluster cluster, ClusterRange range, float thickness, vec4 within, SkySum sum) {
  ObjectData body = objects[range.object];
  float mean = insideOf(body).sigma.w;
  bool looks = raysOutwards > 0u && range.kind != lining;
  float light = sum.free.r + sum.free.g + sum.free.b;
  float evenShare = sum.all.w > 0.0 ? sum.free.w / sum.all.w : 0.0;
  // Any share is right in a channel that is dark.
  vec3 share = mix(vec3(evenShare), overOr0(sum.free.rgb, sum.all.rgb), greaterThan(sum.all.rgb, vec3(1e-30)));
  if (!looks) share = vec3(raysOutwards > 0u ? 0.0 : 1.0);
  float openness = opennessOf(sum);
  skyShares[i] = vec4(share, openness * (sum.all.r + sum.all.g + sum.all.b));
  // For an opaque body, the harmonic mean distance to what is around.
  float room = looks ? (sum.meets > 0.0 ? sum.meets / sum.nearness : 3e38) : 0.0;
  clusters[i].start.w = range.kind == opaqueBody ? room : thickness;
  clusters[i].facet.w = light > 1e-30 ? sum.slant / light : mean;
  float edge = sqrt(cluster.centroidArea.w);
  float counts = range.kind == openBody ? 0.0 : range.kind == opaqueBody ? openness : 1.0;
  clusters[i].second = vec4(shareOfSecond(insideOf(body), edge), counts);
  if (range.kind == bodyWithInside) clusters[i].escape.rgb = escapeOf(insideOf(body), cluster.escape.w, within.rgb);
  withheld[i] = within.w;
}

void main() {
  uint i = linearIndex() / lanes;
  uint lane = linearIndex() % lanes;
  bool isThere = i < clusterCount;
  Cluster cluster = clusters[min(i, clusterCount - 1u)];
  ClusterRange range = ranges[min(i, clusterCount - 1u)];
  ObjectData body = objects[range.object];
  SkySum sum = noSky;
  if (isThere) sum = lookAround(i, lane, cluster, range);
  sum = sumOfLanes(sum);
  if (isThere && firstRay > 0u) sum = together(skySums[i], sum);
  // The last lane has the fewest rays outwards.
  bool puts = isThere && lane == lanes - 1u;
  if (endRay < raysOutwards) {
    if (puts) skySums[i] = sum;
    return;
  }
  vec4 within = sumOfLanes(isThere ? lookWithin(lane, cluster, range, body) : vec4(0.0));
  float thickness = puts ? thicknessOf(otherSide(cluster.start.xyz, -cluster.facet.xyz, cluster, body)) : 0.0;
  // With this, all that can enter of even light does, from wherever it comes.
  float whole = pi * insideOf(body).extinction.w / max(sum.all.w, 1e-30);
  if (isThere && raysToBright() > 0u)
    for (uint k = lane; k < raysOutwards; k += lanes) {
      meetings[i * raysOutwards + k].share *= whole;
      if (withThinParts != 0u)
        for (uint n = 0u; n < meetingsBehind; ++n) {
          uint at = firstBehind(i, k) + n;
          behind[at] = meetingBehind(behind[at].cluster, vec4(vec3(whole), 1.0) * shareTransmittedOf(behind[at]));
        }
    }
  if (puts) put(i, cluster, range, thickness, within, sum);
}
