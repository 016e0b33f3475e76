// Where the part of a beam that is followed further collides next, for each channel of each point. On the way
// some of it is mirrored inside, and what leaves after that is kept as well.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_PIECE_CORNERS 2
#define BINDING_RAYS 3
#include "lib/boundary.glsl"
#include "lib/linear.glsl"
#include "lib/phase.glsl"
#include "lib/point_counts.glsl"
#include "lib/rays.glsl"
#include "lib/unit.glsl"

layout(std430, set = 0, binding = 4) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 5) readonly buffer Clusters { Cluster clusters[]; };
layout(std430, set = 0, binding = 6) readonly buffer Entries { Entry entries[]; };
layout(std430, set = 0, binding = 7) buffer Points { vec4 points[]; };  // BeamPoint: a vec4 per channel
layout(std430, set = 0, binding = 8) readonly buffer Strengths { vec4 strengths[]; };
layout(std430, set = 0, binding = 9) readonly buffer ClusterOfSurfel { uint clusterOfSurfel[]; };
layout(std430, set = 0, binding = 10) readonly buffer OpaqueShares { OpaqueShare opaqueShares[]; };
layout(std430, set = 0, binding = 11) readonly buffer Collisions { FirstCollision collisions[]; };

layout(std430, set = 0, binding = 12) writeonly buffer GuidedLight { Guided guidedLight[]; };

layout(constant_id = 0) const uint withLinings = 0u;
layout(constant_id = 1) const uint sharers = 1u;  // invocations per beam

layout(push_constant) uniform Push {
  uint clusterCount;
  uint firstLight;  // or the number of lights for what comes from everywhere
  uint lights;      // from that on
  uint piecesPerSurfel;
  uint comesFromEverywhere;  // 1: this light does
};

#include "lib/beam_body.glsl"

const uint meetingsOfPath = 3u;  // reflections on the way

// Free paths are those of a medium thinner by this factor, as in beams.comp.glsl.
const float thinner = 0.7;

// In free paths; less than 2 % is left.
const float endOfForwards = 4.0;
const float endOfGuided = 4.0;

// Light on its way to a second collision, in one channel.
struct Way {
  vec3 origin;
  vec3 direction;
  float path;    // left to go, mm
  float share;   // of the light, if all of it goes this way
  float onward;  // what is on its way here, over the part of such ways that is longer
};

// How much goes on of light that meets a piece of the surface. A lining sends it on evenly, which is taken here as
// if mirrored.
float mirroredBy(Body body, RayHit hit, float cosine, int channel) {
  return isLining(hit.piece) ? givenBackBy(hit.piece)[channel] : reflectedInside(body, cosine);
}

// Goes on for a path's length, mirrored where it meets the surface; what leaves there is taken off the share.
// boundary/single.comp.glsl finds what leaves at the first meeting. What leaves later is `guided`: on each stretch all
// that gets to its end, though the path may end before. What thin parts mirror too often collides in the middle of the
// last way across.
vec4 collisionAfter(Body body, Way way, int channel, out Guided guided) {
  guided = Guided(0u, 0.0);
  float most = 0.0;
  float collision = body.medium.collision[channel];
  float free = endOfForwards * body.medium.collision.w / body.medium.extinction[channel];
  for (uint k = 0u; k <= meetingsOfPath; ++k) {
    float furthest = way.path + max(free, 0.0);
    RayHit hit = nextHit(body, way.origin, way.direction, k == 0u ? furthest : max(furthest, endOfGuided / collision));
    bool meets = hit.piece != noPiece;
    vec3 normal = meets ? facetNormal(hit.piece) : vec3(0.0);
    float mirrored = meets ? mirroredBy(body, hit, abs(dot(way.direction, normal)), channel) : 0.0;
    if (k > 0u && meets && !isLining(hit.piece)) {
      float leaves = (1.0 - mirrored) * way.onward * exp(-collision * hit.distance);
      if (leaves > most) guided.cluster = clusterOfSurfel[hit.piece / piecesPerSurfel];
      most = max(most, leaves);
      guided.share += leaves;
    }
    if (!meets || hit.distance > way.path) {
      float left = meets ? hit.distance - way.path : abs(free);
      return vec4(way.origin + (way.path + forwards(body, vec3(left))[channel]) * way.direction, way.share);
    }
    way.path -= hit.distance;
    way.share *= mirrored;
    way.onward *= mirrored * exp((thinner - 1.0) * collision * hit.distance);
    if (k == meetingsOfPath) return vec4(way.origin + 0.5 * hit.distance * way.direction, way.share);
    way.origin += hit.distance * way.direction;
    way.direction = reflect(way.direction, normal);
    if (way.share <= 0.0) break;
  }
  return vec4(way.origin, 0.0);
}

// Light that collided at `place` with that share goes on by the phase function and as far as free paths go. A lattice
// of low discrepancy (Roberts 2018) in the axes of the cluster says how, so that it moves with the cluster. A second
// such lattice shifts it for each cluster and point, points half a step apart: what few directions miss, those beside
// have.
vec4 scatterOn(Body body, uint i, Path by, vec3 arrival, vec4 place, int channel, out Guided guided) {
  const vec2 next = vec2(0.7548776662, 0.5698402910);
  const vec3 shifts = vec3(0.8191725134, 0.6710436067, 0.5497004779);
  vec3 shift = fract((float(i % 8192u) + 0.5 * float(by.point)) * shifts);
  vec3 normal = clusters[i].facet.xyz;
  vec3 along = clusters[i].along.xyz;
  float g = body.medium.collision.w;
  vec3 axis = g == 0.0 ? normal : arrival;
  if (g != 0.0) along = unitOr(along - dot(along, axis) * axis, normal);
  float count = float(by.directions);
  float part = (float(by.direction) + shift.x) / count;
  float z = g == 0.0 ? 1.0 - 2.0 * part : cosineOfPart(part, g);
  vec2 at = fract(shift.yz + float(by.direction) * next);
  float angle = 2.0 * pi * at.x;
  vec3 around = cos(angle) * along + sin(angle) * cross(axis, along);
  vec3 direction = sqrt(max(1.0 - z * z, 0.0)) * around + z * axis;
  float depth = -log(max(1.0 - at.y, 1e-6)) / thinner;
  float onward = place.w / count;
  float share = onward * exp((thinner - 1.0) * depth) / thinner;
  Way way = Way(place.xyz, direction, depth / body.medium.collision[channel], share, onward);
  return collisionAfter(body, way, channel, guided);
}

void main() {
  uint beam = linearIndex() / sharers;
  if (beam >= lights * clusterCount) return;
  uint i = beam % clusterCount;
  uint light = firstLight + beam / clusterCount;
  vec3 followed = clusters[i].second.rgb;
  uint paths = 3u * unpackPointCounts(strengths[beam].w).y;
  Body body = bodyAt(clusters[i], objects[ranges[i].object], entries[light * clusterCount + i].place.xyz);
  for (uint path = linearIndex() % sharers; path < paths; path += sharers) {
    uint second = path / 3u;
    int channel = int(path % 3u);
    Path by = pathTo(second, comesFromEverywhere != 0u);
    FirstCollision collision = collisions[beam * maxFirstPoints + by.point];
    vec4 place = points[3u * (beam * maxPoints + by.point) + uint(channel)];
    place.xyz -= collision.onward[channel] * collision.arrival.xyz;
    vec4 collides = vec4(place.xyz, 0.0);
    Guided guided = Guided(0u, 0.0);
    if (followed[channel] > 0.0 && place.w > 0.0) {
      collides = scatterOn(body, i, by, collision.arrival.xyz, place, channel, guided);
      guided.share *= followed[channel] * body.medium.scatters[channel];
    }
    points[3u * (beam * maxPoints + maxFirstPoints + second) + uint(channel)] = collides;
    guidedLight[beam * pathsOfBeam + path] = guided;
  }
}
