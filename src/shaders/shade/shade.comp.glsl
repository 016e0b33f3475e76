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
#include "lib/frame.glsl"
#include "lib/fresnel.glsl"
#include "lib/material.glsl"
#include "lib/reflection.glsl"
#include "lib/seen_list.glsl"
#include "lib/sky.glsl"
#include "lib/specular_albedo.glsl"
#include "shared/opaque.h"

// What has scattered; in w how much of what is mirrored is sky. After it, radiance by coverage.
layout(std430, set = 0, binding = 3) buffer Light { vec4 light[]; };

// Of what leaves painted bodies, what goes towards the camera, over that without paint.
layout(constant_id = 0) const uint withPaint = 0u;
layout(std430, set = 0, binding = 15) readonly buffer Paint { vec4 paint[]; };

layout(std430, set = 0, binding = 16) readonly buffer Materials { SeenMaterial materials[]; };

layout(push_constant) uniform Push {
  uint atFragments;  // what has scattered stands in `light`, else at the vertices
  float alpha;       // of the GGX reflection
  uint specular;
  uint skyIsMirrored;  // some of it, as `light` has it; else all or none
  uint bodiesAreMirrored;  // `materials` has what is mirrored of them, where that is known
};

// The sky is seen through the lobe already.
const float leastMirrored = 0.5;

vec3 mirroredSky(NormalsNearby normals, uint samples, vec3 toCamera) {
  if (normals.turned < leastMirrored * alpha) return skyReflectedFrom(reflect(-toCamera, normals.middle));
  vec3 sum = vec3(0.0);
  uint seeing = seeingOf(samples);
  for (uint rest = seeing; rest != 0u; rest &= rest - 1u)
    sum += skyReflectedFrom(reflect(-toCamera, normalAt(normals, samples, findLSB(rest))));
  return sum / float(bitCount(seeing));
}

// `bodies` is radiance of the scene where it is mirrored; where that is not known, of the surface here.
vec3 reflection(MediumData medium, vec3 position, NormalsNearby normals, uint samples, vec3 toCamera,
                float sky, vec3 bodies) {
  float eta = medium.boundary.x;
  vec3 sum = vec3(0.0);
  for (uint i = 0u; i < lightsAt(position); ++i) {
    IncidentLight light = incidentLight(i, position);
    if (dot(normals.middle, light.direction) <= 0.0) continue;
    vec3 middle = halfway(normals.middle, light.direction, toCamera);
    float cosine = clamp(dot(light.direction, middle), 0.0, 1.0);
    float value = lobeOfSamples(widenedBy(i, alpha, cosine), normals, samples, light.direction, toCamera) *
                  fresnelReflectance(eta, cosine);
    if (value > 1e-6) sum += light.irradiance * (value * visibilityOf(light, position, normals.middle));
  }
  vec3 around = mix(bodies, mirroredSky(normals, samples, toCamera), sky);
  return sum + around * reflectedAlbedo(medium, max(dot(normals.middle, toCamera), 1e-3));
}

vec3 radianceOf(Seen seen, MeshPlace place) {
  MediumData medium = mediumAt(objects[place.object], place.position);
  vec3 toCamera = normalize(toCameraFrom(place.position));
  float cosine = clamp(dot(place.normal, toCamera), 1e-3, 1.0);
  float transmitted = 1.0 - fresnelReflectance(medium.boundary.x, cosine);
  vec4 found = light[seen.entry];
  vec3 left = atFragments != 0u ? found.rgb : meshExitanceAt(place).rgb;
  vec3 scattered = left * (transmitted * medium.boundary.y);
  if (withPaint != 0u) scattered *= paint[seen.entry].rgb;
  if (specular == 0u) return scattered;
  float sky = skyIsMirrored != 0u ? found.w : 1.0;
  vec3 bodies = left / pi;
  if (bodiesAreMirrored != 0u && materials[seen.entry].around.w > 0.0) bodies = materials[seen.entry].around.rgb;
  return scattered + reflection(medium, place.position, normalsNearby(seen.pixel, seen.word, place),
                                samplesOf(seen.word), toCamera, sky, bodies);
}

void main() {
  Seen seen = seenOfInvocation(0u);
  if (!seen.there) return;
  MeshPlace place = seenPlace(seen.pixel, seen.word);
  if (isOpaque(objects[place.object])) return;
  light[seen.entry] = coverageOf(samplesOf(seen.word)) * vec4(radianceOf(seen, place), 1.0);
}
