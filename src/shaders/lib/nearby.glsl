// What sums over coarse sources leave out within their reach (shared/nearby.h). Needs, before it,
// BINDING_NODES, BINDING_SURFEL_NORMALS, BINDING_SKY_SHARES, BINDING_THROUGH_PAINT,
// lib/irradiance.glsl and what lib/surfel_sum.glsl needs.
#ifndef OPALINE_LIB_NEARBY
#define OPALINE_LIB_NEARBY
#include "lib/surfel_sum.glsl"
#include "lib/pi.glsl"
#include "lib/texels.glsl"
#include "lib/tree_node.glsl"
#include "shared/nearby.h"

TEXELS(BINDING_NODES, nodes);  // TreeNode
layout(std430, set = 0, binding = BINDING_SURFEL_NORMALS) readonly buffer SurfelNormals {
  vec4 surfelNormals[];
};

// The share of the sky's irradiance that enters each surfel.
layout(std430, set = 0, binding = BINDING_SKY_SHARES) readonly buffer SkyShares { vec4 skyShares[]; };

layout(constant_id = 1) const uint withPaint = 0u;

// The share of light on each surfel that its paint lets through.
layout(std430, set = 0, binding = BINDING_THROUGH_PAINT) readonly buffer ThroughPaint { vec4 throughPaint[]; };

// A surfel whose normal has a cosine below this is taken for the other side of a thin part.
const float otherSide = -0.3;

// Part of a disc's area that must be there for it to count as whole, since surfels count by their
// middles. A smaller part lies at a border.
const float wholeDisc = 0.85;

// Sources on the other side of a part look smooth where it is thicker than this many of their spacings.
const float smoothThickness = 1.5;

// The profile of sources in another plane, on the other side of a thin part. As much comes through as from infinitely
// many.
vec3 profileThrough(Profile profile, float squared, float across, float reach) {
  float least = smoothThickness / reachInSpacings * reach;
  float further = max(least * least - across * across, 0.0);
  vec3 wanted = profileOutside(profile, vec3(across * across)) - profileOutside(profile, vec3(reach * reach));
  vec3 kept = profileOutside(profile, vec3(least * least)) -
              profileOutside(profile, vec3(reach * reach + further));
  vec3 part = further == 0.0 ? vec3(1.0) : wanted / max(kept, vec3(1e-30));
  return part * reflectanceProfile(profile, vec3(squared + further));
}

struct Neighbours {
  vec4 sum;       // of the smoothed profile; w: evaluations
  vec3 even;      // from this side, in unit irradiance, by nearbyWeight
  float present;  // part of the plane around that exists, by nearbyWeight
  vec3 sky;       // share of its irradiance that enters there, by nearbyWeight
  vec3 gathered;  // mean irradiance of this side, by nearbyWeight
  vec3 through;   // part of the light there that paint lets through, by nearbyWeight
};

// The sources of the next leaf from `node` on that has any within the reach, or none. The walk stops for a leaf,
// because a device that executes both sides of every branch would go through sources at each node.
struct Opened {
  uint first;
  uint end;
};

Opened nextWithin(inout uint node, vec3 position, ObjectData body) {
  Opened opened = Opened(0u, 0u);
  while (node < body.tree.y && opened.end == 0u) {
    vec4 green = texelOf(nodes, 5 * int(node) + 1);
    float radius = texelOf(nodes, 5 * int(node)).w;
    uint link = floatBitsToUint(green.w);
    bool apart = distance(green.xyz, position) > body.darkest.w + radius;
    if (!apart && isLeaf(link)) {
      opened.first = sourcesPerSurfel * firstSurfelOf(link);
      opened.end = opened.first + sourcesPerSurfel * surfelCountOf(link);
    }
    node = apart ? afterNode(node, link) : node + 1u;
  }
  return opened;
}

bool isOnSide(uint source, vec3 normal) {
  return dot(surfelNormals[source / sourcesPerSurfel].xyz, normal) >= otherSide;
}

// Sums sources on the other side of a thin part. Few places have any.
vec4 sumThrough(vec3 position, vec3 normal, ObjectData body, bool any) {
  Profile profile = mediumAt(body, position).profile;
  float reach = body.darkest.w;
  vec4 sum = vec4(0.0);
  uint node = any ? body.tree.x : body.tree.y;
  while (node < body.tree.y) {
    Opened opened = nextWithin(node, position, body);
    for (uint i = opened.first; i < opened.end; ++i) {
      vec3 place = positionAreaOf(i).xyz;
      float squared = squaredDistanceTo(place, position);
      if (squared >= reach * reach || isOnSide(i, normal)) continue;
      float across = dot(place - position, normal);
      sum += vec4(fluxOf(i) * profileThrough(profile, squared, across, reach), 1.0);
    }
  }
  return sum;
}

Neighbours neighboursOf(vec3 position, vec3 normal, ObjectData body) {
  Profile profile = mediumAt(body, position).profile;
  float reach = body.darkest.w;
  Neighbours found = Neighbours(vec4(0.0), vec3(0.0), 0.0, vec3(0.0), vec3(0.0), vec3(0.0));
  float area = 0.0;
  bool anyOther = false;
  uint node = body.tree.x;
  while (node < body.tree.y) {
    Opened opened = nextWithin(node, position, body);
    for (uint i = opened.first; i < opened.end; ++i) {
      vec4 place = positionAreaOf(i);
      float squared = squaredDistanceTo(place.xyz, position);
      if (squared >= reach * reach) continue;
      if (!isOnSide(i, normal)) {
        anyOther = true;
        continue;
      }
      vec3 weight = reflectanceProfile(profile, vec3(smoothedSquare(squared, reach * reach)));
      vec3 flux = fluxOf(i);
      float counted = place.w * nearbyWeight(squared, reach * reach);
      found.sum += vec4(flux * weight, 1.0);
      found.even += counted * weight;
      found.sky += counted * skyShares[i / sourcesPerSurfel].rgb;
      if (withPaint != 0u) found.through += counted * throughPaint[i / sourcesPerSurfel].rgb;
      found.gathered += counted / max(place.w, 1e-30) * flux;
      area += counted;
    }
  }
  found.sum += sumThrough(position, normal, body, anyOther);
  found.sky = area > 0.0 ? found.sky / area : vec3(1.0);
  found.through = withPaint != 0u && area > 0.0 ? found.through / area : vec3(1.0);
  if (area > 0.0) found.gathered /= area;
  found.present = min(area / (wholeDisc * pi / 3.0 * reach * reach), 1.0);
  return found;
}

const uint placesOfRing = 6u;

// Places of a ring lie so far off the tangent plane, over their distance, that no curved surface
// casts its own shadow.
const float ringLift = 0.1;

// Normals by which light falls on the disc and the rings around a place.
struct LitNormals {
  vec3 disc;
  vec3 inner;
  vec3 outer;
};

// Mean irradiance by lights on a ring around a place. Its first place is turned by `turned` of the
// angle between them; light falls on the normal `lit`.
vec3 ringIrradiance(vec3 position, vec3 normal, vec3 lit, float radius, float turned, MediumData medium) {
  vec3 along = normalize(abs(normal.x) < 0.7 ? vec3(0.0, normal.z, -normal.y)
                                             : vec3(-normal.z, 0.0, normal.x));
  vec3 across = cross(normal, along);
  vec3 sum = vec3(0.0);
  for (uint i = 0u; i < placesOfRing; ++i) {
    float angle = 2.0 * pi * (float(i) + turned) / float(placesOfRing);
    vec3 place =
        position + radius * (cos(angle) * along + sin(angle) * across + ringLift * normal);
    sum += lightsIrradiance(place, lit, normal, medium);
  }
  return sum / float(placesOfRing);
}

// The exitance by what lies within the reach; w: evaluations of the profile.
vec4 nearbyExitance(vec3 position, vec3 normal, LitNormals lit, ObjectData body) {
  MediumData medium = mediumAt(body, position);
  float reach = body.darkest.w;
  vec3 here = lightsIrradiance(position, lit.disc, normal, medium);
  vec3 inner = ringIrradiance(position, normal, lit.inner, innerRingAt * reach, 0.0, medium);
  vec3 outer = ringIrradiance(position, normal, lit.outer, outerRingAt * reach, 0.5, medium);
  Neighbours found = neighboursOf(position, normal, body);
  here *= found.through;
  inner *= found.through;
  outer *= found.through;
  vec3 ambient = found.through * found.sky * skyIrradianceAt(normal, medium);
  // What the sky gives the disc beyond what it gives the whole.
  vec3 more = vec3(0.0);
  if (lit.disc != normal)
    more = found.through * found.sky * (skyIrradianceAt(lit.disc, medium) - skyIrradianceAt(normal, medium));
  // The light of area lights is known from what neighbours have gathered.
  if (frame.counts.w > firstAreaLight())
    ambient += max(found.gathered - ambient - (here + inner + outer) / 3.0, 0.0);
  vec3 lacking = body.nearbyDisc.rgb * (ambient + more + here) +
                 found.present * (body.nearbyInner.rgb * (ambient + inner) +
                                  body.nearbyOuter.rgb * (ambient + outer));
  // Sources lie irregularly, which must not show in even light.
  vec3 uneven = found.present * body.nearbyKept.rgb - found.even;
  lacking += uneven * (ambient + (here + inner + outer) / 3.0);
  return vec4(max(found.sum.rgb + lacking, 0.0), found.sum.a);
}

#endif
