// What surfaces mirror of lights with shadow maps. Needs, before it, what lib/seen.glsl and
// lib/shadow.glsl need.
#ifndef OPALINE_LIB_REFLECTION
#define OPALINE_LIB_REFLECTION
#include "lib/ggx.glsl"
#include "lib/seen.glsl"
#include "lib/shadow.glsl"

// How the normal changes over a pixel.
struct NormalsNearby {
  vec3 middle;  // at the place
  vec3 right;   // per pixel
  vec3 down;
  float turned;  // rad, from one pixel to the next
};

NormalsNearby normalsNearby(ivec2 pixel, uint word, MeshPlace place) {
  const float step = 0.5;  // pixels
  vec2 middle = middleOf(samplesOf(word));
  vec3 right = normalOn(place.vertices, weightsNear(place.vertices, seenClip(pixel, middle + vec2(step, 0.0))));
  vec3 down = normalOn(place.vertices, weightsNear(place.vertices, seenClip(pixel, middle + vec2(0.0, step))));
  right = (place.side * right - place.normal) / step;
  down = (place.side * down - place.normal) / step;
  return NormalsNearby(place.normal, right, down, max(length(right), length(down)));
}

// The normal at one of the surface's `samples`.
vec3 normalAt(NormalsNearby normals, uint samples, int which) {
  vec2 offset = frame.samples[which].xy - middleOf(samples);
  return normalize(normals.middle + offset.x * normals.right + offset.y * normals.down);
}

// The samples that see the surface.
uint seeingOf(uint samples) {
  return samples & (1u << frame.counts.z) - 1u;
}

// The direction halfway between light and camera; the normal where they are opposite.
vec3 halfway(vec3 normal, vec3 toLight, vec3 toCamera) {
  return normalize(toLight + toCamera + 1e-18 * normal);
}

// The factor by which a light's irradiance is reflected, without Fresnel's reflectance.
float lobe(float alpha, vec3 normal, vec3 toLight, vec3 toCamera, out float cosineHalf) {
  float cosineIn = dot(normal, toLight);
  cosineHalf = clamp(dot(normal, halfway(normal, toLight, toCamera)), 0.0, 1.0);
  if (cosineIn <= 0.0) return 0.0;
  return ggxDistribution(alpha, cosineHalf) *
         ggxVisibility(alpha, max(dot(normal, toCamera), 1e-3), cosineIn) * cosineIn;
}

// Widens α² to α² + θ²/4μ, for a disc of angular radius θ. In the highlight's middle a lobe mirrors (θ²/4μ) / (α² +
// θ²/4μ) of such a disc, which is what one of that width mirrors of as much parallel light. `cosine` is μ, that of
// the mirrored light.
float widenedBy(uint light, float alpha, float cosine) {
  float more = frame.lights[light].place.w;
  return more > 0.0 ? min(sqrt(alpha * alpha + more / max(cosine, 1e-3)), 1.0) : alpha;
}

// In parts of the lobe's width. Normals that turn by less than the first within a pixel are one;
// further than the second from the mirrored direction the lobe is smooth.
const float leastTurn = 0.1;
const float widthOfLobe = 4.0;

// The lobe, as a mean over samples where the highlight is sharp, since it may be narrower than a pixel.
float lobeOfSamples(float alpha, NormalsNearby normals, uint samples, vec3 toLight, vec3 toCamera) {
  float cosineHalf;
  float value = lobe(alpha, normals.middle, toLight, toCamera, cosineHalf);
  float near = widthOfLobe * alpha + normals.turned;
  if (normals.turned < leastTurn * alpha || 1.0 - cosineHalf * cosineHalf > near * near) return value;
  float sum = 0.0;
  uint seeing = seeingOf(samples);
  for (uint rest = seeing; rest != 0u; rest &= rest - 1u)
    sum += lobe(alpha, normalAt(normals, samples, findLSB(rest)), toLight, toCamera, cosineHalf);
  return sum / float(bitCount(seeing));
}

#endif
