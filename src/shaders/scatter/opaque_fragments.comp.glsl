// Of opaque surfaces that pixels see: what they are made of, and the irradiance there of lights with
// shadow maps, where the site is the fragments. Clusters have the rest.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SEEN 1
#define BINDING_OBJECTS 3
#define BINDING_MEDIA 4
#define SHADOW_BINDING 5
#define MESH_BINDING 6
#define BINDING_SEEN_LIST 10
#define BINDING_OPAQUES 12
#define BINDING_TEXELS 15
#include "lib/frame.glsl"
#include "lib/irradiance.glsl"
#include "lib/material.glsl"
#include "lib/seen_material.glsl"

layout(std430, set = 0, binding = 2) buffer Irradiances { vec4 irradiances[]; };
layout(std430, set = 0, binding = 16) writeonly buffer Materials { SeenMaterial materials[]; };

layout(push_constant) uniform Push {
  uint first;
  uint site;
};

SeenMaterial materialSeen(Seen seen, MeshPlace place, OpaqueData material) {
  MaterialPlace read = materialPlaceSeen(seen, place, material);
  SeenMaterial result = materialAt(material, read);
  vec3 first = meshPositions[place.vertices.x].xyz;
  vec3 toSecond = meshPositions[place.vertices.y].xyz - first;
  vec3 toThird = meshPositions[place.vertices.z].xyz - first;
  float widened;
  vec3 normal = place.side * mappedNormal(material, read, triangleOf(seen.word), place.weights, toSecond,
                                          toThird, place.side * place.normal, widened);
  // What it turns away from the eye would be black.
  vec3 toCamera = normalize(toCameraFrom(place.position));
  float facing = dot(normal, toCamera);
  if (facing < 0.01) normal = normalize(normal + (0.01 - facing) * toCamera);
  result.normal.xyz = normal;
  float alpha = result.diffuse.w;
  result.diffuse.w = min(sqrt(alpha * alpha + widened), 1.0);
  return result;
}

void main() {
  Seen seen = seenOfInvocation(first);
  if (!seen.there) return;
  MeshPlace place = seenPlace(seen.pixel, seen.word);
  ObjectData body = objects[place.object];
  if (!isOpaque(body)) return;
  MediumData medium = mediumAt(body, place.position);
  SeenMaterial material = materialSeen(seen, place, opaques[medium.tables.y]);
  materials[seen.entry] = material;
  if (!isSummedAtFragments(body, site)) return;
  vec3 found = lightsIrradiance(liftedPlace(place), material.normal.xyz, place.normal, medium);
  irradiances[seen.entry] = vec4(found, 0.0);
}
