// Area lights: what a place sees of them and how much light comes from there if nothing is in
// between. Needs lib/frame.glsl.
#ifndef OPALINE_LIB_AREA_LIGHT
#define OPALINE_LIB_AREA_LIGHT
#include "lib/axes.glsl"
#include "lib/fresnel.glsl"
#include "lib/light.glsl"
#include "lib/pi.glsl"
#include "lib/unit.glsl"
#include "shared/medium.h"

// What a place sees of a light, relative to it: a parallelogram, a disc, or a tube's near side.
struct AreaView {
  uint shape;
  vec3 middle;   // mm
  vec3 u;        // for a parallelogram or a disc, from the middle to the edge; for a tube, half its axis
  vec3 v;        // the same; for a tube, unit, from the axis to the place
  vec3 across;   // for a tube, unit, at right angles to both
  float radius;  // of a tube
  vec2 edge;     // for a tube, the cosine and sine of half the angle about its axis that is seen
  bool shines;   // to the place
};

// Distance of the corners of a twelve-sided polygon that stands for a disc of equal area.
const float cornerOfDisc = 1.0232670;  // √(2π / 12 sin 30°)

AreaView discOfSphere(AreaView view, float radius) {
  float squared = dot(view.middle, view.middle);
  view.shines = squared > radius * radius * 1.000001;
  float part = view.shines ? radius * radius / squared : 0.0;
  vec3 towards = unitOr(view.middle, vec3(0.0, 0.0, 1.0));
  mat2x3 across = axesAcross(towards);
  float seen = radius * sqrt(1.0 - part);
  view.shape = discShape;
  view.middle *= 1.0 - part;
  view.u = seen * across[0];
  view.v = seen * across[1];
  return view;
}

AreaView sideOfTube(AreaView view, float radius) {
  vec3 axis = unitOr(view.u, vec3(0.0, 1.0, 0.0));
  vec3 away = dot(view.middle, axis) * axis - view.middle;
  float distance = length(away);
  view.shines = distance > radius * 1.000001;
  view.v = unitOr(away, vec3(0.0));
  view.across = cross(axis, view.v);
  view.radius = radius;
  float cosine = min(radius / max(distance, 1e-30), 1.0);
  view.edge = vec2(cosine, sqrt(1.0 - cosine * cosine));
  return view;
}

AreaView areaViewFrom(vec3 position, uint index) {
  LightData light = frame.lights[index];
  AreaView view = AreaView(light.kind.w, light.place.xyz - position, light.axis.xyz, light.cone.xyz,
                           vec3(0.0), 0.0, vec2(0.0), true);
  if (view.shape == sphereShape) return discOfSphere(view, light.cone.w);
  if (view.shape == tubeShape) return sideOfTube(view, light.cone.w);
  float side = -dot(cross(view.u, view.v), view.middle);
  view.shines = side > 0.0 || (light.power.w != 0.0 && side < 0.0);
  return view;
}

// The point at the angle about its axis that has that cosine and sine.
vec3 onTube(AreaView view, float along, vec2 angle) {
  return view.middle + along * view.u + view.radius * (angle.x * view.v + angle.y * view.across);
}

// The polygon that is seen. Its corners follow each other at middle + at.x x + at.y y, and at a tube's two ends
// plus or minus `along`. A tube's has six corners on the near half of either rim.
struct Outline {
  vec3 middle;
  vec3 x;
  vec3 y;
  vec3 along;
  vec2 at;
  vec2 turn;  // from one corner to the next, as a complex number
};

const uint cornersOfRim = 6u;

vec2 turnedBy(vec2 a, vec2 b) {
  return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

uint cornersOf(AreaView view) {
  return view.shape == rectangleShape ? 4u : 12u;
}

Outline outlineOf(AreaView view) {
  if (view.shape == tubeShape) {
    float turn = 2.0 * acos(view.edge.x) / float(cornersOfRim - 1u);
    return Outline(view.middle, view.radius * view.v, view.radius * view.across, view.u, vec2(view.edge.x, -view.edge.y),
                   vec2(cos(turn), sin(turn)));
  }
  bool isDisc = view.shape == discShape;
  return Outline(view.middle, view.u, view.v, vec3(0.0), isDisc ? vec2(cornerOfDisc, 0.0) : vec2(1.0),
                 isDisc ? vec2(0.866025404, 0.5) : vec2(0.0, 1.0));
}

Outline transformed(Outline outline, mat3 transform) {
  return Outline(transform * outline.middle, transform * outline.x, transform * outline.y, transform * outline.along,
                 outline.at, outline.turn);
}

vec3 cornerOf(Outline outline) {
  return outline.middle + outline.at.x * outline.x + outline.at.y * outline.y + outline.along;
}

// Goes to the corner after the i-th. The end of one rim leads to the other, which goes the other way.
void goOn(inout Outline outline, AreaView view, uint i) {
  if (view.shape == tubeShape && i % cornersOfRim == cornersOfRim - 1u) {
    outline.along = -outline.along;
    outline.turn.y = -outline.turn.y;
  } else {
    outline.at = turnedBy(outline.at, outline.turn);
  }
}

// γ / 2 sin γ of the angle γ between two vectors, times their cross product over their lengths: the
// part of an edge in Lambert's formula. Three halvings of its tangent find the angle.
vec3 edgeOf(vec3 a, vec3 b) {
  float product = sqrt(dot(a, a) * dot(b, b));
  float whole = max(product + dot(a, b), 1e-6 * product);
  vec3 normal = cross(a, b - a);
  float half1 = length(normal) / max(whole, 1e-30);
  float root1 = 1.0 + sqrt(1.0 + half1 * half1);
  float half2 = half1 / root1;
  float root2 = 1.0 + sqrt(1.0 + half2 * half2);
  float x = half2 / root2;
  x *= x;
  float series = 1.0 - x * (1.0 / 3.0 - x * (1.0 / 5.0 - x * (1.0 / 7.0 - x * (1.0 / 9.0 - x / 11.0))));
  return normal * (4.0 * series / (max(whole, 1e-30) * root1 * root2));
}

// The vector irradiance of unit radiance at a surface from what lies above it: Lambert's formula for the polygon, cut
// off at the horizon after directions have been transformed. Each edge along the horizon gives half its angle along
// the normal. The sum of these angles is that of a product of complex numbers.
vec3 vectorIrradianceOf(AreaView view, mat3 transform, vec3 normal) {
  mat2x3 horizon = axesAcross(normal);
  vec2 turned = vec2(1.0, 0.0);  // along the horizon, from where the polygon goes below it to where it comes up
  vec3 sum = vec3(0.0);
  Outline outline = transformed(outlineOf(view), transform);
  vec3 before = cornerOf(outline);
  uint count = cornersOf(view);
  for (uint i = 0u; i < count; ++i) {
    goOn(outline, view, i);
    vec3 after = cornerOf(outline);
    float from = dot(before, normal);
    float to = dot(after, normal);
    vec3 crossing = before + (after - before) * (from / (from - to));
    if (from > 0.0 || to > 0.0) sum += edgeOf(from > 0.0 ? before : crossing, to > 0.0 ? after : crossing);
    if ((from > 0.0) != (to > 0.0)) {
      vec2 at = crossing * horizon;
      at *= inversesqrt(max(dot(at, at), 1e-30));
      turned = turnedBy(turned, from > 0.0 ? vec2(at.x, -at.y) : at);
    }
    before = after;
  }
  if (turned.y != 0.0) sum += 0.5 * atan(turned.y, turned.x) * normal;
  return dot(sum, normal) < 0.0 ? -sum : sum;
}

// A light so far away that rounding would show in the sum over its edges is taken for a point: the
// area that is seen over the distance squared.
const float leastOfDistance = 1e-3;

float sizeOf(AreaView view) {
  return max(max(length(view.u), view.shape == tubeShape ? 0.0 : length(view.v)), view.radius);
}

float areaOver(AreaView view, vec3 direction, float squared) {
  if (view.shape == tubeShape)
    return 4.0 * view.radius * length(cross(view.u, direction)) / squared;
  float area = abs(dot(cross(view.u, view.v), direction)) / squared;
  return (view.shape == rectangleShape ? 4.0 : pi) * area;
}

// Makes directions across the normal this many times as long.
mat3 acrossBy(vec3 normal, float factor) {
  return mat3(factor) + (1.0 - factor) * outerProduct(normal, normal);
}

// The light of unit radiance that enters, as a vector: a surface that faces `normal`, or nearly so, is entered by its
// component that way. The Fresnel term is taken as two lobes (lights/fresnel_lobes.h).
vec3 enteringVectorOf(AreaView view, vec3 normal, MediumData medium) {
  float squared = dot(view.middle, view.middle);
  float size = sizeOf(view);
  if (size * size < leastOfDistance * leastOfDistance * squared) {
    vec3 direction = view.middle * inversesqrt(squared);
    float cosine = dot(direction, normal);
    if (cosine <= 0.0) return vec3(0.0);
    return areaOver(view, direction, squared) * (1.0 - fresnelReflectance(medium.boundary.x, min(cosine, 1.0))) * direction;
  }
  float plain = medium.boundary.z;
  float wide = medium.inside.extinction.w - plain;
  return plain * vectorIrradianceOf(view, mat3(1.0), normal) +
         wide * vectorIrradianceOf(view, acrossBy(normal, medium.boundary.w), normal);
}

float enteringOfView(AreaView view, vec3 normal, MediumData medium) {
  return max(dot(enteringVectorOf(view, normal, medium), normal), 0.0);
}

// The light of an area light that enters a surface, if all of it is visible.
vec3 areaEntering(uint index, vec3 position, vec3 normal, MediumData medium) {
  AreaView view = areaViewFrom(position, index);
  return view.shines ? frame.lights[index].power.rgb * enteringOfView(view, normal, medium)
                     : vec3(0.0);
}

// The mean direction from which an area light shines.
vec3 directionOfArea(uint index, vec3 position, vec3 normal) {
  AreaView view = areaViewFrom(position, index);
  return unitOr(vectorIrradianceOf(view, mat3(1.0), normal), unitOr(view.middle, normal));
}

// A place of the light that is seen, for two numbers in [0, 1), and what its neighbourhood gives a
// surface that faces it, up to a factor.
struct AreaSample {
  vec3 offset;  // mm, from the place
  float weight;
};

AreaSample sampleOf(AreaView view, vec2 at) {
  vec3 offset;
  float facing;
  if (view.shape == tubeShape) {
    float sine = (2.0 * at.y - 1.0) * view.edge.y;
    vec2 angle = vec2(sqrt(1.0 - sine * sine), sine);
    offset = onTube(view, 2.0 * at.x - 1.0, angle);
    vec3 normal = angle.x * view.v + angle.y * view.across;
    facing = max(-dot(normal, offset), 0.0) / max(angle.x, 1e-3);
  } else {
    vec2 place = 2.0 * at - 1.0;
    if (view.shape == discShape)
      place = sqrt(at.x) * vec2(cos(2.0 * pi * at.y), sin(2.0 * pi * at.y));
    offset = view.middle + place.x * view.u + place.y * view.v;
    facing = abs(dot(cross(view.u, view.v), offset));
  }
  float squared = max(dot(offset, offset), 1e-30);
  return AreaSample(offset, facing * inversesqrt(squared) / squared);
}

#endif
