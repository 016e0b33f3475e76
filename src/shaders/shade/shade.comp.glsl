// Radiance towards the camera: what has scattered (Eq. 5) and the reflection on top. One
// antialiasing sample is added to those before it.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define SHADOW_BINDING 6
#define BINDING_SKY_REFLECTION 7
#include "lib/frame.glsl"
#include "lib/fresnel.glsl"
#include "lib/ggx.glsl"
#include "lib/material.glsl"
#include "lib/shadow.glsl"
#include "lib/sky.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 1) uniform sampler2D surfacePosition;
layout(set = 0, binding = 2) uniform sampler2D surfaceNormal;
layout(set = 0, binding = 3) uniform sampler2D surfaceExitance;
layout(std430, set = 0, binding = 8) readonly buffer SpecularAlbedo { float specularAlbedo[]; };
layout(set = 0, binding = 9, rgba32f) uniform image2D radiance;
layout(set = 0, binding = 10) uniform sampler2D skyShare;  // of what is mirrored

layout(push_constant) uniform Push {
  uint samplesBefore;
  float sampleWeight;
  float alpha;  // of the GGX reflection
  uint specular;
  uint skyIsMirrored;  // some of it, as skyShare has it; else all or none
};

const uint albedoEntries = 64u;

float reflectedAlbedo(MediumData medium, float cosine) {
  float place = cosine * float(albedoEntries) - 0.5;
  float lower = clamp(floor(place), 0.0, float(albedoEntries - 2u));
  uint first = medium.tables.w + uint(lower);
  return mix(specularAlbedo[first], specularAlbedo[first + 1u], clamp(place - lower, 0.0, 1.0));
}

// `own` is radiance of the surface here, for which that of the scene is taken where it is mirrored.
vec3 reflection(MediumData medium, vec3 position, vec3 normal, vec3 toCamera, float sky, vec3 own) {
  float eta = medium.boundary.x;
  float cosineOut = max(dot(normal, toCamera), 1e-3);
  vec3 sum = vec3(0.0);
  for (uint i = 0u; i < frame.counts.x; ++i) {
    IncidentLight light = incidentLight(i, position);
    vec3 toLight = light.direction;
    float cosineIn = dot(normal, toLight);
    if (cosineIn <= 0.0) continue;
    // Where they are opposite, the middle is the normal.
    vec3 middle = normalize(toLight + toCamera + 1e-18 * normal);
    float value = ggxDistribution(alpha, clamp(dot(normal, middle), 0.0, 1.0)) *
                  ggxVisibility(alpha, cosineOut, cosineIn) *
                  fresnelReflectance(eta, clamp(dot(toLight, middle), 0.0, 1.0)) * cosineIn;
    if (value > 1e-6) sum += light.irradiance * (value * visibilityOf(light, position, normal));
  }
  vec3 around = mix(own, skyReflectedFrom(reflect(-toCamera, normal)), sky);
  return sum + around * reflectedAlbedo(medium, cosineOut);
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(radiance)))) return;
  vec4 surface = texelFetch(surfacePosition, pixel, 0);
  vec4 value = vec4(0.0);
  if (surface.w > 0.0) {
    MediumData medium = mediumAt(objects[uint(surface.w) - 1u], surface.xyz);
    vec3 normal = texelFetch(surfaceNormal, pixel, 0).xyz;
    vec3 toCamera = normalize(frame.cameraPosition.xyz - surface.xyz);
    float cosine = clamp(dot(normal, toCamera), 1e-3, 1.0);
    float transmitted = 1.0 - fresnelReflectance(medium.boundary.x, cosine);
    vec3 exitance = texelFetch(surfaceExitance, pixel, 0).rgb;
    value = vec4(exitance * (transmitted * medium.boundary.y), 1.0);
    if (specular != 0u)
      value.rgb += reflection(medium, surface.xyz, normal, toCamera,
                              skyIsMirrored != 0u ? texelFetch(skyShare, pixel, 0).r : 1.0, exitance / pi);
  }
  value *= sampleWeight;
  if (samplesBefore != 0u) value += imageLoad(radiance, pixel);
  imageStore(radiance, pixel, value);
}
