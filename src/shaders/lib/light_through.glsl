// What arrives of lights at places of opaque surfaces, where bodies in the way let some of their light through
// (lib/through_bodies.glsl). Needs, before it, what lib/rays.glsl needs, BINDING_CLUSTER_PAINTS, THROUGH_BINDING, push
// constants nodeCount, of all surfels' trees, and piecesPerSurfel. THROUGH_BINDING is the first of two bindings, or of
// three where there is no BINDING_CLUSTERS.
#ifndef OPALINE_LIB_LIGHT_THROUGH
#define OPALINE_LIB_LIGHT_THROUGH
#include "lib/axes.glsl"
#include "lib/boundary.glsl"
#include "lib/fresnel.glsl"
#include "lib/places_in_pixel.glsl"
#include "lib/rays.glsl"
#include "lib/texels.glsl"

layout(std430, set = 0, binding = THROUGH_BINDING) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = THROUGH_BINDING + 1) readonly buffer ClusterOfSurfel { uint clusterOfSurfel[]; };
#ifndef BINDING_CLUSTERS
TEXELS(THROUGH_BINDING + 2, clusters);  // Cluster
#endif

layout(constant_id = 0) const uint withThinParts = 0u;
layout(constant_id = 1) const uint withPaint = 0u;

uint firstPieceOf(uint object) {
  return objects[object].table.y * piecesPerSurfel;
}

#define CLUSTERS_ARE_TEXELS
#include "lib/through_bodies.glsl"

bool looksThrough(float visible) {
  return withThinParts != 0u && visible < 1.0 - leastHidden;
}

const float leastWeight = 0.02;

// What gets through bodies from a light `furthest` away in that unit direction. w: its weight in a mean, 0 where nothing
// is met. Sides that are not parallel send the light elsewhere, so a mean has little of it.
vec4 throughFrom(vec3 position, vec3 outside, vec3 direction, float furthest) {
  RayTarget scene = RayTarget(0u, nodeCount, everyObject);
  float start = startAbove(position);
  vec3 origin = position + start * outside;
  RayHit hit = nearestHit(origin, direction, start, furthest, scene);
  if (hit.piece == noPiece) return vec4(0.0);
  vec4 through = throughBodies(origin, direction, hit, start, furthest, scene);
  return vec4(through.rgb, max(through.w, leastWeight));
}

// The mean of rays that meet something, from four places around.
vec3 throughAround(vec3 position, vec3 outside, vec3 direction, float furthest, float reach) {
  mat2x3 across = axesAcross(outside);
  vec4 sum = vec4(0.0);
  for (uint k = 0u; k < 4u; ++k) {
    vec3 aside = (k < 2u ? reach : -reach) * across[k & 1u];
    vec4 through = throughFrom(position + aside, outside, direction, furthest);
    sum += through.w * vec4(through.rgb, 1.0);
  }
  return sum.rgb / max(sum.w, leastWeight);
}

// The width and the height on the surface of what asks for light, mm: those of a pixel, or 0.
mat2x3 extent = mat2x3(0.0);

// They lie this part of the extent above the facet's plane, since the surface may rise beside it.
const float aboveExtent = 0.1;

// Where two places differ by more than this, two more are asked.
const float leastDifference = 0.02;

// The part of a small light that arrives, given how much of it is visible in a shadow map that is filtered over
// `reach` mm.
vec3 arrivingPart(float visible, vec3 position, vec3 outside, vec3 direction, float furthest, float reach) {
  if (!looksThrough(visible)) return vec3(visible);
  vec3 above = aboveExtent * max(length(extent[0]), length(extent[1])) * outside;
  vec3 sum = vec3(0.0);
  vec3 first = vec3(0.0);
  uint places = extent == mat2x3(0.0) ? 1u : 2u;
  for (uint k = 0u; k < places; ++k) {
    vec3 place = position + extent * placesInPixel[k] + above;
    vec4 through = throughFrom(place, outside, direction, furthest);
    if (through.w == 0.0) through.rgb = throughAround(place, outside, direction, furthest, reach);
    sum += through.rgb;
    if (k == 0u) first = through.rgb;
    if (k == 1u && largestOf(abs(through.rgb - first)) > leastDifference) places = 4u;
  }
  return visible + (1.0 - visible) / float(places) * sum;
}

#endif
