// Where the part of a beam that is followed further collides next: for each channel of each point.
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
layout(std430, set = 0, binding = 7) buffer Points { vec4 points[]; };  // BeamPoint: a vec4 a channel
layout(std430, set = 0, binding = 8) readonly buffer Strengths { vec4 strengths[]; };
layout(std430, set = 0, binding = 9) readonly buffer ClusterOfSurfel { uint clusterOfSurfel[]; };
layout(std430, set = 0, binding = 10) readonly buffer OpaqueShares { OpaqueShare opaqueShares[]; };
layout(std430, set = 0, binding = 11) readonly buffer Collisions { FirstCollision collisions[]; };

layout(constant_id = 0) const uint withLinings = 0u;
layout(constant_id = 1) const uint sharers = 1u;  // invocations of a beam

layout(push_constant) uniform Push {
  uint clusterCount;
  uint firstLight;  // or the number of lights for what comes from everywhere
  uint lights;      // from that on
  uint piecesPerSurfel;
  uint comesFromEverywhere;  // 1: the light
};

#include "lib/beam_body.glsl"

const uint meetingsOfPath = 3u;  // reflections on the way

// Free paths are those of a medium thinner by this factor, as in beams.comp.glsl.
const float thinner = 0.7;

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

// Light that collided at `place` with that share goes on by the phase function and as far as free paths go, by a lattice
// of low discrepancy (Roberts 2018) in the axes of the cluster, so that it moves with that. Another shift for each
// cluster and point, by such a lattice too, points half a step apart: what few directions miss, those beside have.
vec4 scatterOn(Body body, uint i, Path by, vec3 arrival, vec4 place, int channel) {
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
  float share = exp((thinner - 1.0) * depth) / (thinner * count);
  return collisionAfter(body, place.xyz, direction, depth / body.medium.collision[channel], share * place.w, channel);
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
    points[3u * (beam * maxPoints + maxFirstPoints + second) + uint(channel)] =
        followed[channel] > 0.0 && place.w > 0.0
            ? scatterOn(body, i, by, collision.arrival.xyz, place, channel)
            : vec4(place.xyz, 0.0);
  }
}
