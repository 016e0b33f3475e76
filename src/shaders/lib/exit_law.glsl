// How much of the light that leaves a translucent body goes towards the camera. Needs, before it, lib/fresnel.glsl. Also
// compiled as C++ with glm by the tests.
#ifndef OPALINE_LIB_EXIT_LAW
#define OPALINE_LIB_EXIT_LAW
#include "origin.glsl"
#include "../shared/medium.h"

// In mean free paths.
const float thinnest = 0.25f;
const float thickest = 60.0f;

// Sources along a ray from the surface, z mean free paths below it, down to the other surface: e^{-sz} for light
// that has entered here, 1 + qz for light that comes through the body.
struct SourcesBelow {
  vec3 thickness;  // T
  vec3 decay;      // s
  vec3 slope;      // q, by the Robin condition
  vec3 last;       // e^{-sT}
};

// Radiance below the surface, up to a factor.
struct RadianceBelow {
  vec3 entered;
  vec3 through;
};

SourcesBelow sourcesBelow(BoundaryMedium medium, float overThickness) {
  SourcesBelow sources;
  vec3 extinction = vec3(medium.extinction);
  sources.thickness = clamp(extinction / max(overThickness, 1e-18f), thinnest, thickest);
  sources.decay = vec3(medium.sigma) / extinction;
  sources.slope = 1.0f / (2.0f * medium.diffusion.w * vec3(medium.diffusion) * extinction);
  sources.last = exp(-sources.thickness * sources.decay);
  return sources;
}

// What a ray of that cosine gathers. The other surface mirrors a part of it.
RadianceBelow gathered(SourcesBelow sources, float cosine, float mirrored) {
  vec3 left = exp(-sources.thickness / cosine);
  vec3 rounds = 1.0f / (1.0f - mirrored * left);
  RadianceBelow below;
  below.entered = rounds * (1.0f - left * sources.last) / (1.0f + sources.decay * cosine);
  below.through =
      rounds * (1.0f - left + sources.slope * (cosine * (1.0f - left) - sources.thickness * left));
  return below;
}

// What leaves towards `cosine`, that of the view, over what leaves evenly. Its mean over all directions, each
// weighted by how much leaves there evenly, is 1.
vec3 exitLaw(MediumData medium, float cosine, vec4 origin) {
  if (!isKnown(origin)) return vec3(1.0f);
  float eta = medium.boundary.x;
  SourcesBelow sources = sourcesBelow(medium.inside, origin.w);
  float within = sqrt(1.0f - (1.0f - cosine * cosine) / (eta * eta));
  RadianceBelow seen = gathered(sources, within, fresnelReflectance(eta, cosine));
  RadianceBelow first = gathered(sources, medium.exits.x, medium.exits.z);
  RadianceBelow second = gathered(sources, medium.exits.y, medium.exits.w);
  // Their mean is that of all directions.
  float weight = (medium.exits.y - medium.inside.sigma.w) / (medium.exits.y - medium.exits.x);
  vec3 ofEntered = mix(second.entered, first.entered, weight);
  vec3 ofThrough = mix(second.through, first.through, weight);
  return mix(seen.through / ofThrough, seen.entered / ofEntered, clamp(vec3(origin), 0.0f, 1.0f));
}

#endif
