// What a place of a surface sees of an area light: rays to places on it, weighted by the light that would
// come from there (Heitz, Hill and McGuire 2018). Needs what lib/area_light.glsl and lib/rays.glsl need.
#ifndef OPALINE_LIB_AREA_SHADOW
#define OPALINE_LIB_AREA_SHADOW
#include "lib/area_light.glsl"
#include "lib/rays.glsl"

struct Receiver {
  vec3 position;
  vec3 normal;   // unit
  vec3 outside;  // unit, of the surface as it is drawn
  float eta;     // index of refraction
};

// What the rays of a place have found: light that would come, and light that does.
struct Share {
  float all;
  float visible;
};

// The i-th place of a net over the light (Sobol 1967). Each run of 4, 16, … places has one in each quarter, sixteenth,
// … of the light.
vec2 netPlace(uint i) {
  uint across = 0u;
  uint direction = 1u << 31u;
  for (uint rest = i; rest != 0u; rest >>= 1u) {
    if ((rest & 1u) != 0u) across ^= direction;
    direction ^= direction >> 1u;
  }
  const float middle = 1.0 / 512.0;  // of one of 256 parts
  return vec2(bitfieldReverse(i), across) / 4294967296.0 + middle;
}

// A place on the light's edge, `along` of the way around it, in [0, 1).
vec2 edgePlace(AreaView view, float along) {
  const float almost = 0.999;
  if (view.shape == discShape) return vec2(almost, along);
  float side = fract(4.0 * along);
  vec2 at = along < 0.25 ? vec2(side, 0.0) : along < 0.5 ? vec2(1.0, side) : along < 0.75 ? vec2(1.0 - side, 1.0) : vec2(0.0, 1.0 - side);
  return mix(vec2(0.5), at, almost);
}

// The first places that neighbours test: which of 16, in a turn in [0, 4). Most lie on the light's edge, because
// whatever covers the light hides some of these first. So where all agree, all of the light is seen or none.
vec2 firstPlace(AreaView view, uint which, uint turn) {
  const uint placesOfEdge = 12u;  // so that corners are among the places; those of other turns lie between
  uint i = 5u * which % 16u;  // neighbours do not test neighbouring places
  if (i >= placesOfEdge) return netPlace(4u * turn + i - placesOfEdge);
  return edgePlace(view, (float(i) + 0.25 * float(turn)) / float(placesOfEdge));
}

// Tests one place on the light, for two numbers in [0, 1).
void sendRay(AreaView view, Receiver to, vec2 at, uint nodeCount, inout Share share) {
  AreaSample place = sampleOf(view, at);
  float squared = dot(place.offset, place.offset);
  float cosine = dot(place.offset, to.normal) * inversesqrt(max(squared, 1e-30));
  if (cosine <= 0.0) return;
  float weight = place.weight * cosine * (1.0 - fresnelReflectance(to.eta, min(cosine, 1.0)));
  share.all += weight;
  if (dot(place.offset, to.outside) <= 0.0) return;
  float start = startAbove(to.position);
  float least = start * inversesqrt(max(squared, 1e-30));
  if (!occluded(to.position + start * to.outside, place.offset, least, 1.0,
                RayTarget(0u, nodeCount, everyObject)))
    share.visible += weight;
}

#endif
