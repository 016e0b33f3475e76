// Radiance towards the camera of the translucent surfaces that pixels see: what has scattered (Eq. 5) and the
// reflection on top.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SEEN 1
#define BINDING_MESH_EXITANCES 2
#define BINDING_SEEN_LIST 9
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define SHADOW_BINDING 6
#define BINDING_SKY_REFLECTION 7
#define MESH_BINDING 11
#define BINDING_MESH_ORIGINS 18
#include "lib/frame.glsl"
#include "lib/fresnel.glsl"
#include "lib/exit_law.glsl"
#include "lib/material.glsl"
#include "lib/glossy_sky.glsl"
#include "lib/reflection.glsl"
#include "lib/seen_list.glsl"
#include "lib/sky.glsl"
#include "lib/specular_albedo.glsl"
#include "shared/opaque.h"

// First what has scattered, then radiance by coverage.
layout(std430, set = 0, binding = 3) buffer Light { vec4 light[]; };

// For painted bodies, what goes towards the camera, over what does without paint.
layout(constant_id = 0) const uint withPaint = 0u;
layout(std430, set = 0, binding = 15) readonly buffer Paint { vec4 paint[]; };

// Some translucent surfaces have a roughness or normals of their own.
layout(constant_id = 1) const uint withOwnSurfaces = 0u;
layout(std430, set = 0, binding = 16) readonly buffer Materials { SeenMaterial materials[]; };
layout(set = 0, binding = 17) uniform samplerCubeArray glossySky;

layout(std430, set = 0, binding = 19) readonly buffer Origins { vec4 origins[]; };
layout(std430, set = 0, binding = 20) readonly buffer SkyShares { float skyShares[]; };  // of what is mirrored

layout(push_constant) uniform Push {
  uint atFragments;  // 1: what has scattered stands in `light`; 0: at the vertices
  float alpha;       // of the GGX reflection
  uint specular;
  uint skyIsMirrored;  // 1: some of it, as `skyShares` says; 0: all or none
  uint bodiesAreMirrored;  // 1: `materials` holds what is mirrored of them, where that is known
  uint leavesSmooth;  // 1: light leaves as through a smooth surface, whatever is mirrored (Eq. 5)
  uint byOrigin;  // 1: by exitLaw(); 0: evenly
  uint seesThrough;  // 1: `materials` holds what is seen through thin parts
};

// The sky is already seen through the lobe.
const float leastMirrored = 0.5;

// How a surface mirrors: as the picture says or, with `own`, as it says itself.
struct Mirror {
  bool own;
  float alpha;
};

vec3 skyFrom(vec3 direction, Mirror mirror) {
  return withOwnSurfaces != 0u && mirror.own ? glossySkyFrom(glossySky, direction, mirror.alpha)
                                             : skyReflectedFrom(direction);
}

vec3 mirroredSky(NormalsNearby normals, uint samples, vec3 toCamera, Mirror mirror) {
  if (normals.turned < leastMirrored * mirror.alpha) return skyFrom(reflect(-toCamera, normals.middle), mirror);
  vec3 sum = vec3(0.0);
  uint seeing = seeingOf(samples);
  for (uint rest = seeing; rest != 0u; rest &= rest - 1u)
    sum += skyFrom(reflect(-toCamera, normalAt(normals, samples, findLSB(rest))), mirror);
  return sum / float(bitCount(seeing));
}

// The share of even light, by the cosine of the view.
float mirroredShare(MediumData medium, Mirror mirror, float cosine) {
  if (withOwnSurfaces != 0u && mirror.own) return reflectedAlbedo(medium, mirror.alpha, cosine);
  return reflectedAlbedo(medium, cosine);
}

// `bodies` is radiance of what is mirrored of the scene, or of the surface here where that is not known.
vec3 reflection(MediumData medium, vec3 position, vec3 outside, NormalsNearby normals, uint samples,
                vec3 toCamera, float sky, vec3 bodies, Mirror mirror, float share) {
  float eta = medium.boundary.x;
  vec3 sum = vec3(0.0);
  for (uint i = 0u; i < lightsAt(position); ++i) {
    IncidentLight light = incidentLight(i, position);
    if (dot(normals.middle, light.direction) <= 0.0) continue;
    if (withOwnSurfaces != 0u && dot(outside, light.direction) <= 0.0) continue;
    vec3 middle = halfway(normals.middle, light.direction, toCamera);
    float cosine = clamp(dot(light.direction, middle), 0.0, 1.0);
    float value = lobeOfSamples(widenedBy(i, mirror.alpha, cosine), normals, samples, light.direction, toCamera) *
                  fresnelReflectance(eta, cosine);
    if (value > 1e-6) sum += light.irradiance * (value * visibilityOf(light, position, outside));
  }
  return sum + share * mix(bodies, mirroredSky(normals, samples, toCamera, mirror), sky);
}

vec3 radianceOf(Seen seen, MeshPlace place) {
  MediumData medium = mediumAt(objects[place.object], place.position);
  vec3 toCamera = normalize(toCameraFrom(place.position));
  vec3 normal = place.normal;
  Mirror mirror = Mirror(false, alpha);
  vec3 lifted = place.position;
  if (withOwnSurfaces != 0u && hasOwnSurface(medium)) {
    normal = materials[seen.entry].normal.xyz;
    mirror = Mirror(true, materials[seen.entry].diffuse.w);
    lifted = liftedPlace(place);
  }
  float cosine = clamp(dot(normal, toCamera), 1e-3, 1.0);
  // By reciprocity a surface lets out towards the camera what it does not mirror from there. A rough surface lets out
  // more than a smooth one where it is grazed.
  float mirrored = mirroredShare(medium, mirror, cosine);
  bool smoothly = specular == 0u || leavesSmooth != 0u;
  float kept = smoothly ? fresnelReflectance(medium.boundary.x, cosine) : mirrored;
  vec3 left = atFragments != 0u ? light[seen.entry].rgb : meshExitanceAt(place).rgb;
  vec3 scattered = left * ((1.0 - kept) * medium.boundary.y);
  if (byOrigin != 0u)
    scattered *= exitLaw(medium, cosine, atFragments != 0u ? origins[seen.entry] : meshOriginAt(place));
  if (withPaint != 0u) scattered *= paint[seen.entry].rgb;
  if (seesThrough != 0u) scattered += (1.0 - kept) * materials[seen.entry].behind.rgb;
  if (specular == 0u) return scattered;
  float sky = skyIsMirrored != 0u ? skyShares[seen.entry] : 1.0;
  vec3 bodies = left / pi;
  if (bodiesAreMirrored != 0u && materials[seen.entry].around.w > 0.0) bodies = materials[seen.entry].around.rgb;
  NormalsNearby normals = normalsNearby(seen.pixel, seen.word, place);
  normals.middle = normal;
  return scattered + reflection(medium, lifted, place.normal, normals, samplesOf(seen.word), toCamera, sky,
                                bodies, mirror, mirrored);
}

void main() {
  Seen seen = seenOfInvocation(0u);
  if (!seen.there) return;
  MeshPlace place = seenPlace(seen.pixel, seen.word);
  if (isOpaque(objects[place.object])) return;
  light[seen.entry] = coverageOf(samplesOf(seen.word)) * vec4(radianceOf(seen, place), 1.0);
}
