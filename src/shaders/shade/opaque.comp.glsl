// Radiance towards the camera of the opaque surfaces that pixels see.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SEEN 1
#define BINDING_MESH_EXITANCES 2
#define BINDING_SEEN_LIST 9
#define BINDING_OBJECTS 4
#define SHADOW_BINDING 6
#define BINDING_GLOSS 8
#define MESH_BINDING 11
#include "lib/bodies.glsl"
#include "lib/frame.glsl"
#include "lib/gloss.glsl"
#include "lib/glossy_sky.glsl"
#include "lib/lesser.glsl"
#include "lib/pi.glsl"
#include "lib/reflection.glsl"
#include "lib/seen_list.glsl"
#include "lib/diffuse_exitance.glsl"

// First irradiance, then radiance by coverage.
layout(std430, set = 0, binding = 3) buffer Light { vec4 light[]; };
layout(std430, set = 0, binding = 5) readonly buffer Materials { SeenMaterial materials[]; };
layout(set = 0, binding = 7) uniform samplerCubeArray glossySky;

layout(push_constant) uniform Push {
  uint atFragments;  // 1: the irradiance stands in `light`; 0: at the vertices
  uint specular;
  uint vertexCount;
};

// The sky is already seen through the lobe.
const float leastMirrored = 0.5;

vec3 mirroredSky(NormalsNearby normals, uint samples, vec3 toCamera, float alpha) {
  if (normals.turned < leastMirrored * alpha) return glossySkyFrom(glossySky, reflect(-toCamera, normals.middle), alpha);
  vec3 sum = vec3(0.0);
  uint seeing = seeingOf(samples);
  for (uint rest = seeing; rest != 0u; rest &= rest - 1u)
    sum += glossySkyFrom(glossySky, reflect(-toCamera, normalAt(normals, samples, findLSB(rest))), alpha);
  return sum / float(bitCount(seeing));
}

vec3 mirroredLights(SeenMaterial material, vec2 parts, vec3 position, vec3 outside, NormalsNearby normals, uint samples,
                    vec3 toCamera) {
  vec3 sum = vec3(0.0);
  for (uint i = 0u; i < lightsAt(position); ++i) {
    IncidentLight incident = incidentLight(i, position);
    if (dot(normals.middle, incident.direction) <= 0.0 || dot(outside, incident.direction) <= 0.0) continue;
    float cosine = dot(incident.direction, halfway(normals.middle, incident.direction, toCamera));
    float alpha = widenedBy(i, material.diffuse.w, cosine);
    float value = lobeOfSamples(alpha, normals, samples, incident.direction, toCamera);
    if (value <= 1e-6) continue;
    sum += facetReflectance(material, parts, cosine) * incident.irradiance *
           (value * visibilityOf(incident, position, outside));
  }
  return sum;
}

vec3 radianceOf(Seen seen, MeshPlace place, SeenMaterial material) {
  vec3 emitted = material.emission.rgb;
  if (material.emission.w != 0.0) return emitted;
  vec3 diffuse = (atFragments != 0u ? ofBothSides(material, light[seen.entry].rgb, material.behind.rgb)
                                    : diffuseExitanceOfVertices(place, material, vertexCount)) / pi;
  if (specular == 0u) return emitted + diffuse;
  vec3 toCamera = normalize(toCameraFrom(place.position));
  uint samples = samplesOf(seen.word);
  NormalsNearby normals = normalsNearby(seen.pixel, seen.word, place);
  normals.middle = material.normal.xyz;
  float cosine = clamp(dot(normals.middle, toCamera), 1e-3, 1.0);
  vec2 parts = glossOf(material, cosine);
  vec3 mirrored = mirroredOf(material, parts);
  float taken = largestOf(mirroredByDielectric(material, parts));
  vec3 lights = mirroredLights(material, parts, liftedPlace(place), place.normal, normals, samples, toCamera);
  vec3 around = material.around.rgb +
                material.around.w * mirroredSky(normals, samples, toCamera, material.diffuse.w);
  return emitted + diffuse * (1.0 - clamp(taken, 0.0, 1.0)) + lights +
         material.normal.w * mirrored * around;
}

void main() {
  Seen seen = seenOfInvocation(0u);
  if (!seen.there) return;
  MeshPlace place = seenPlace(seen.pixel, seen.word);
  if (!isOpaque(objects[place.object])) return;
  vec3 radiance = radianceOf(seen, place, materials[seen.entry]);
  light[seen.entry] = coverageOf(samplesOf(seen.word)) * vec4(radiance, 1.0);
}
