// Points of light in the body under a cluster (shared/boundary.h). A beam has the points of one light under
// one cluster; beams are stored light after light. Needs, before it, BINDING_POINTS, BINDING_STRENGTHS and
// what lib/boundary.glsl needs.
#ifndef OPALINE_LIB_BEAM
#define OPALINE_LIB_BEAM
#include "lib/boundary.glsl"
#include "lib/point_counts.glsl"
#include "lib/texels.glsl"
#include "lib/unit.glsl"

TEXELS(BINDING_POINTS, points);  // BeamPoint
// For each beam, the power that entered through its cluster; w: numbers of its points, by packPointCounts.
TEXELS(BINDING_STRENGTHS, strengths);

BeamPoint readPoint(uint beam, uint p) {
  uint index = beam * maxPoints + p;
  return BeamPoint(texelOf(points, 3 * int(index)), texelOf(points, 3 * int(index) + 1),
                   texelOf(points, 3 * int(index) + 2));
}

vec4 strengthOf(uint beam) {
  return texelOf(strengths, int(beam));
}

vec3 shareOf(BeamPoint point) {
  return vec3(point.red.w, point.green.w, point.blue.w);
}

// Squared distances from a place to the three channels' points.
vec3 squaredDistances(BeamPoint point, vec3 place) {
  vec3 red = point.red.xyz - place;
  vec3 green = point.green.xyz - place;
  vec3 blue = point.blue.xyz - place;
  return vec3(dot(red, red), dot(green, green), dot(blue, blue));
}

// The direction in which light arrives at the p-th of a beam's points of first collisions, which lie
// in groups along a ray.
vec3 arrivalAt(uint beam, uint p) {
  bool onFirst = p < pointsOfFirstSegment;
  uint count = onFirst ? pointsOfFirstSegment : pointsOfReflection;
  uint first = onFirst ? 0u : p - (p - pointsOfFirstSegment) % pointsOfReflection;
  BeamPoint from = readPoint(beam, first);
  BeamPoint to = readPoint(beam, first + count - 1u);
  return unitOr(to.red.xyz + to.green.xyz + to.blue.xyz - (from.red.xyz + from.green.xyz + from.blue.xyz), vec3(0.0));
}

// Of the light that entered through a cluster, the share that becomes sources of fluence at its second collisions.
vec3 shareOfSecond(Cluster cluster, BoundaryMedium medium) {
  return cluster.second.rgb * medium.scatters.rgb;
}

#endif
