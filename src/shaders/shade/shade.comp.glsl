// Radiance towards the camera of the surfaces that pixels see: what has scattered (Eq. 5) and the
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
#include "lib/ggx.glsl"
#include "lib/material.glsl"
#include "lib/seen_list.glsl"
#include "lib/shadow.glsl"
#include "lib/sky.glsl"
#include "lib/specular_albedo.glsl"

// What has scattered; in w how much of what is mirrored is sky. After it, radiance by coverage.
layout(std430, set = 0, binding = 3) buffer Light { vec4 light[]; };

layout(push_constant) uniform Push {
  uint atFragments;  // what has scattered stands in `light`, else at the vertices
  float alpha;       // of the GGX reflection
  uint specular;
  uint skyIsMirrored;  // some of it, as `light` has it; else all or none
};

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

// Of the surface's `samples`, that one's.
vec3 normalAt(NormalsNearby normals, uint samples, int which) {
  vec2 offset = frame.samples[which].xy - middleOf(samples);
  return normalize(normals.middle + offset.x * normals.right + offset.y * normals.down);
}

// What a light's irradiance is reflected by. Where they are opposite, the middle is the normal.
float lobe(vec3 normal, vec3 toLight, vec3 toCamera, float eta, out float cosineHalf) {
  vec3 middle = normalize(toLight + toCamera + 1e-18 * normal);
  float cosineIn = dot(normal, toLight);
  cosineHalf = clamp(dot(normal, middle), 0.0, 1.0);
  if (cosineIn <= 0.0) return 0.0;
  return ggxDistribution(alpha, cosineHalf) *
         ggxVisibility(alpha, max(dot(normal, toCamera), 1e-3), cosineIn) *
         fresnelReflectance(eta, clamp(dot(toLight, middle), 0.0, 1.0)) * cosineIn;
}

// Parts of the lobe's width. Normals that turn by less within a pixel are one, and further than that
// from the mirrored direction the lobe is smooth.
const float leastTurn = 0.1;
const float widthOfLobe = 4.0;
// The sky is seen through the lobe already.
const float leastMirrored = 0.5;

// At all samples where the highlight is sharp, since it may be narrower than a pixel.
float lobeOfSamples(NormalsNearby normals, uint samples, vec3 toLight, vec3 toCamera, float eta) {
  float cosineHalf;
  float value = lobe(normals.middle, toLight, toCamera, eta, cosineHalf);
  float near = widthOfLobe * alpha + normals.turned;
  if (normals.turned < leastTurn * alpha || 1.0 - cosineHalf * cosineHalf > near * near) return value;
  float sum = 0.0;
  uint seeing = samples & (1u << frame.counts.z) - 1u;
  for (uint rest = seeing; rest != 0u; rest &= rest - 1u)
    sum += lobe(normalAt(normals, samples, findLSB(rest)), toLight, toCamera, eta, cosineHalf);
  return sum / float(bitCount(seeing));
}

vec3 mirroredSky(NormalsNearby normals, uint samples, vec3 toCamera) {
  if (normals.turned < leastMirrored * alpha) return skyReflectedFrom(reflect(-toCamera, normals.middle));
  vec3 sum = vec3(0.0);
  uint seeing = samples & (1u << frame.counts.z) - 1u;
  for (uint rest = seeing; rest != 0u; rest &= rest - 1u)
    sum += skyReflectedFrom(reflect(-toCamera, normalAt(normals, samples, findLSB(rest))));
  return sum / float(bitCount(seeing));
}

// `own` is radiance of the surface here, for which that of the scene is taken where it is mirrored.
vec3 reflection(MediumData medium, vec3 position, NormalsNearby normals, uint samples, vec3 toCamera,
                float sky, vec3 own) {
  float eta = medium.boundary.x;
  vec3 sum = vec3(0.0);
  for (uint i = 0u; i < lightsAt(position); ++i) {
    IncidentLight light = incidentLight(i, position);
    if (dot(normals.middle, light.direction) <= 0.0) continue;
    float value = lobeOfSamples(normals, samples, light.direction, toCamera, eta);
    if (value > 1e-6) sum += light.irradiance * (value * visibilityOf(light, position, normals.middle));
  }
  vec3 around = mix(own, mirroredSky(normals, samples, toCamera), sky);
  return sum + around * reflectedAlbedo(medium, max(dot(normals.middle, toCamera), 1e-3));
}

vec3 radianceOf(Seen seen) {
  MeshPlace place = seenPlace(seen.pixel, seen.word);
  MediumData medium = mediumAt(objects[place.object], place.position);
  vec3 toCamera = normalize(frame.cameraPosition.xyz - place.position);
  float cosine = clamp(dot(place.normal, toCamera), 1e-3, 1.0);
  float transmitted = 1.0 - fresnelReflectance(medium.boundary.x, cosine);
  vec4 found = light[seen.entry];
  vec3 left = atFragments != 0u ? found.rgb : meshExitanceAt(place).rgb;
  vec3 scattered = left * (transmitted * medium.boundary.y);
  if (specular == 0u) return scattered;
  float sky = skyIsMirrored != 0u ? found.w : 1.0;
  return scattered + reflection(medium, place.position, normalsNearby(seen.pixel, seen.word, place),
                                samplesOf(seen.word), toCamera, sky, left / pi);
}

void main() {
  Seen seen = seenOfInvocation(0u);
  if (!seen.there) return;
  light[seen.entry] = coverageOf(samplesOf(seen.word)) * vec4(radianceOf(seen), 1.0);
}
