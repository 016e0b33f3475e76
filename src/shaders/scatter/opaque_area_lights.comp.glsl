// Irradiance of area lights on opaque surfaces that pixels see, or on their other side, with soft shadows. Each of 8×8
// pixels tests other places of a light, and each pixel takes what those around it have found: 256 places in any window
// of that size, or fewer where the shadow's edge is sharp. Most first places are on the light's edge; where those of
// all pixels around agree, they are enough.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SEEN 1
#define BINDING_SEEN_LIST 2
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define BINDING_PIECE_CORNERS 6
#define BINDING_RAYS 7
#define MESH_BINDING 11
#define BINDING_CLUSTER_PAINTS 16
#define THROUGH_BINDING 17
#include "lib/frame.glsl"
#include "lib/area_shadow.glsl"
#include "lib/material.glsl"
#include "lib/mesh.glsl"
#include "lib/seen_list.glsl"
#include "lib/window_cell.glsl"
#include "shared/opaque.h"

layout(std430, set = 0, binding = 8) buffer Materials { SeenMaterial materials[]; };
layout(std430, set = 0, binding = 9) buffer Irradiances { vec4 irradiances[]; };
// Eight bits for each light, for the first surface of each pixel of a band: how much of it is visible, of
// `whole`, and whether that changes slowly. One buffer is of the round before, the other of this one.
layout(std430, set = 0, binding = 10) readonly buffer SharesBefore { uvec4 sharesBefore[]; };
layout(std430, set = 0, binding = 15) writeonly buffer LightShares { uvec4 lightShares[]; };

layout(push_constant) uniform Push {
  uint first;
  uint site;
  uint nodeCount;  // of all surfels' trees
  uint piecesPerSurfel;
  uint firstRow;  // of the band
  uint rows;
  uint round;
  uint behind;  // 1: on the other side of surfaces that let light through
};

#include "lib/area_light_through.glsl"
#include "lib/neighbours.glsl"

// The rounds of OpaqueLightsPass.
const uint askingFirst = 0u;
const uint comparing = 1u;
const uint askingAgain = 2u;
const uint averaging = 3u;
const uint summing = 4u;

const uint whole = 124u;  // a multiple of the rays, so that nothing is rounded where they weigh the same
const uint unasked = 127u;  // no light comes from there
const uint slowly = 128u;

const int width = 4;  // of a window
const uint raysAgain = 4u;

uint bitsOf(uvec4 shares, uint light) {
  return bitfieldExtract(shares[light >> 2u], int(8u * (light & 3u)), 8);
}

uint shareOf(uvec4 shares, uint light) {
  return bitsOf(shares, light) & ~slowly;
}

bool changesSlowly(uvec4 shares, uint light) {
  return (bitsOf(shares, light) & slowly) != 0u;
}

uvec4 withShare(uvec4 shares, uint light, uint bits) {
  shares[light >> 2u] |= bits << 8u * (light & 3u);
  return shares;
}

// See lightsAt() of lib/light.glsl.
uint areaLightsAt(vec3 position) {
  return allLightsAt(position) - firstAreaLight();
}

bool hasShares(ObjectData body) {
  return isOpaque(body) && (behind == 0u || letsThrough(body)) && isSummedAtFragments(body, site);
}

// The place on a surface that a pixel sees, on the side that is asked about.
MeshPlace placeAsked(ivec2 pixel, uint word) {
  MeshPlace place = seenPlace(pixel, word);
  if (behind != 0u) return otherSideOf(place);
  return place;
}

// Whether the first surface of a pixel has shares.
bool isAsked(ivec2 pixel) {
  if (!isInBand(pixel)) return false;
  uint word = seenWord(pixel, 0u);
  return samplesOf(word) != 0u && hasShares(objects[objectOfTriangle(triangleOf(word))]);
}

Receiver receiverOf(MeshPlace place, uint entry) {
  vec3 normal = materials[entry].normal.xyz;
  return Receiver(liftedPlace(place), behind != 0u ? -normal : normal, place.facet, 1.0);
}

uint packed(Share share) {
  return share.all > 0.0 ? uint(share.visible / share.all * float(whole) + 0.5) : unasked;
}

// Which of the quarters of 8×8 pixels it is in.
uint quarterOf(ivec2 pixel) {
  return cellOf(pixel / width, 2);
}

uint firstShareOf(AreaView view, Receiver receiver, ivec2 pixel) {
  Share share = Share(0.0, 0.0);
  sendRay(view, receiver, firstPlace(view, cellOf(pixel, width), quarterOf(pixel)), nodeCount, share);
  return packed(share);
}

uint shareAgainOf(AreaView view, Receiver receiver, ivec2 pixel) {
  Share share = Share(0.0, 0.0);
  uint firstPlace = raysAgain * (16u * quarterOf(pixel) + cellOf(pixel, width));
  for (uint i = 0u; i < raysAgain; ++i)
    sendRay(view, receiver, netPlace(firstPlace + i), nodeCount, share);
  return packed(share);
}

// For each light, whether some of what has been found sees it, and whether some does not.
struct Around {
  uint visible;
  uint hidden;
};

void look(ivec2 pixel, vec3 position, inout Around around) {
  if (!isAsked(pixel)) return;
  uvec4 shares = sharesBefore[indexOf(pixel)];
  for (uint light = 0u; light < areaLightsAt(position); ++light) {
    uint share = shareOf(shares, light);
    if (share == unasked) continue;
    if (share != 0u) around.visible |= 1u << light;
    if (share != whole) around.hidden |= 1u << light;
  }
}

// What a window agrees on; half where it does not.
uvec4 comparedShares(ivec2 pixel, vec3 position) {
  Around around = Around(0u, 0u);
  ivec2 window = windowAround(pixel, width);
  for (uint i = 0u; i < uint(width * width); ++i) look(pixelOfWindow(window, i, width), position, around);
  uvec4 shares = uvec4(0u);
  for (uint light = 0u; light < areaLightsAt(position); ++light) {
    bool visible = bitfieldExtract(around.visible, int(light), 1) != 0u;
    bool hidden = bitfieldExtract(around.hidden, int(light), 1) != 0u;
    shares = withShare(shares, light, visible ? (hidden ? whole / 2u : whole) : hidden ? 0u : unasked);
  }
  return shares;
}

// The i-th of `count`² pixels around whose windows together form one of `count` times the width, inside the band.
ivec2 middleOfWindow(ivec2 pixel, int i, int count) {
  int reach = count * width / 2;
  ivec2 middle = max(min(pixel, endOfBand() - reach), ivec2(0, firstRow) + reach);
  return middle + width * ivec2(i % count, i / count) + width / 2 - reach;
}

uvec4 askedShares(Seen seen, MeshPlace place) {
  uvec4 shares = uvec4(0u);
  Receiver receiver = receiverOf(place, seen.entry);
  Around around = Around(0u, 0u);
  if (round == askingAgain) {
    look(seen.pixel, place.position, around);
    for (int i = 0; i < 16; ++i) look(middleOfWindow(seen.pixel, i, 4), place.position, around);
  }
  for (uint i = firstAreaLight(); i < allLightsAt(place.position); ++i) {
    uint light = i - firstAreaLight();
    AreaView view = areaViewFrom(receiver.position, i);
    bool visible = bitfieldExtract(around.visible, int(light), 1) != 0u;
    bool hidden = bitfieldExtract(around.hidden, int(light), 1) != 0u;
    uint share = unasked;
    if (round == askingFirst && view.shines)
      share = firstShareOf(view, receiver, seen.pixel);
    else if (visible && hidden && view.shines)
      share = shareAgainOf(view, receiver, seen.pixel);
    else if (visible != hidden)
      share = visible ? whole : 0u;
    shares = withShare(shares, light, share);
  }
  return shares;
}

bool goesOnAt(MeshPlace place, ivec2 pixel) {
  return isAsked(pixel) && isOneSurface(place, placeAsked(pixel, seenWord(pixel, 0u)));
}

// A bit for each pixel of a window whose first surface is this one. Where all have found the same, one is enough.
uint alikeAround(Seen seen, MeshPlace place) {
  ivec2 window = windowAround(seen.pixel, width);
  ivec2 away = seen.pixel - window;
  bool same = isFirstSurface(seen);
  uint alike = same ? 1u << uint(away.y * width + away.x) : 0u;
  uvec4 found = sharesBefore[indexOf(seen.pixel)];
  uint asked = 0u;
  for (uint i = 0u; i < uint(width * width); ++i) {
    ivec2 other = pixelOfWindow(window, i, width);
    if (!isAsked(other)) continue;
    asked |= 1u << i;
    same = same && sharesBefore[indexOf(other)] == found;
  }
  if (same) return alike;
  for (uint rest = asked & ~alike; rest != 0u; rest &= rest - 1u)
    if (goesOnAt(place, pixelOfWindow(window, uint(findLSB(rest)), width))) alike |= rest & -rest;
  return alike;
}

// The mean of a window, the mean of pixels next to this one, and their squared distance from the mean.
struct Shares {
  float count;
  float mean;
  float near;
  float spread;
};

Shares sharesAround(uint light, ivec2 pixel, uint alike) {
  ivec2 window = windowAround(pixel, width);
  Shares found = Shares(0.0, 0.0, 0.0, 0.0);
  float nearCount = 0.0;
  for (uint rest = alike; rest != 0u; rest &= rest - 1u) {
    ivec2 other = pixelOfWindow(window, uint(findLSB(rest)), width);
    uint bits = shareOf(sharesBefore[indexOf(other)], light);
    if (bits == unasked) continue;
    float share = float(bits) / float(whole);
    ++found.count;
    found.mean += share;
    found.spread += share * share;
    if (any(greaterThan(other, pixel)) || any(lessThan(other, pixel - 1))) continue;
    ++nearCount;
    found.near += share;
  }
  found.near /= max(nearCount, 1.0);
  found.mean /= max(found.count, 1.0);
  found.spread = found.spread / max(found.count, 1.0) - found.mean * found.mean;
  return found;
}

// The shadow's edge is sharp where pixels see all of a light or none, although together they see a part of it. The
// places that a pixel tests are spread over the light, so each sees about as much where the edge is soft. One pixel
// among many that see nothing proves nothing.
const float doubt = 0.05;

uint averaged(Shares found) {
  if (found.count == 0.0) return unasked;
  float sharp = found.spread / (found.mean * (1.0 - found.mean) + doubt);
  float share = mix(found.mean, found.near, smoothstep(0.5, 0.75, sharp));
  return uint(share * float(whole) + 0.5) | (sharp < 0.5 ? slowly : 0u);
}

uvec4 averagedShares(Seen seen, MeshPlace place) {
  uint alike = alikeAround(seen, place);
  if (bitCount(alike) == 1) return sharesBefore[indexOf(seen.pixel)] | 0x80808080u;  // all change slowly
  uvec4 shares = uvec4(0u);
  for (uint light = 0u; light < areaLightsAt(place.position); ++light)
    shares = withShare(shares, light, averaged(sharesAround(light, seen.pixel, alike)));
  return shares;
}

// The mean of four windows that together form one of twice the width, unless one has a sharp edge.
float shareOfFour(uint light, Seen seen, MeshPlace place) {
  uint own = bitsOf(sharesBefore[indexOf(seen.pixel)], light);
  uint sum = 0u;
  uint count = 0u;
  for (int i = 0; i < 4; ++i) {
    ivec2 other = middleOfWindow(seen.pixel, i, 2);
    if (!isAsked(other)) continue;
    uint found = bitsOf(sharesBefore[indexOf(other)], light);
    if (found != own && ((found & ~slowly) == unasked || !goesOnAt(place, other))) continue;
    if ((found & slowly) == 0u) return float(own & ~slowly) / float(whole);
    sum += found & ~slowly;
    ++count;
  }
  return (count > 0u ? float(sum) / float(count) : float(own & ~slowly)) / float(whole);
}

float visiblePart(uint light, AreaView view, Receiver receiver, Seen seen, MeshPlace place, uint alike) {
  if (isFirstSurface(seen)) {
    uvec4 own = sharesBefore[indexOf(seen.pixel)];
    if (shareOf(own, light) == unasked) return 0.0;
    return changesSlowly(own, light) ? shareOfFour(light, seen, place) : float(shareOf(own, light)) / float(whole);
  }
  Shares around = sharesAround(light, seen.pixel, alike);
  if (around.count > 0.0) return around.mean;
  uint share = shareAgainOf(view, receiver, seen.pixel);
  return share == unasked ? 0.0 : float(share) / float(whole);
}

vec3 irradianceAt(Seen seen, MeshPlace place) {
  MediumData medium = mediumAt(objects[place.object], place.position);
  Receiver receiver = receiverOf(place, seen.entry);
  uint alike = isFirstSurface(seen) ? 0u : alikeAround(seen, place);
  vec3 sum = vec3(0.0);
  for (uint i = firstAreaLight(); i < allLightsAt(place.position); ++i) {
    AreaView view = areaViewFrom(receiver.position, i);
    if (!view.shines) continue;
    vec3 all = frame.lights[i].power.rgb * enteringOfView(view, receiver.normal, medium);
    if (all == vec3(0.0)) continue;
    float visible = visiblePart(i - firstAreaLight(), view, receiver, seen, place, alike);
    sum += arrivingPartOfArea(visible, view, receiver) * all;
  }
  return sum;
}

void main() {
  Seen seen = seenOfInvocation(first);
  if (!seen.there) return;
  MeshPlace place = placeAsked(seen.pixel, seen.word);
  if (!hasShares(objects[place.object])) return;
  if (round == summing) {
    vec3 found = irradianceAt(seen, place);
    if (behind != 0u)
      materials[seen.entry].behind.rgb += found;
    else
      irradiances[seen.entry].rgb += found;
  } else if (isFirstSurface(seen)) {
    lightShares[indexOf(seen.pixel)] = round == comparing   ? comparedShares(seen.pixel, place.position)
                                       : round == averaging ? averagedShares(seen, place)
                                                            : askedShares(seen, place);
  }
}
