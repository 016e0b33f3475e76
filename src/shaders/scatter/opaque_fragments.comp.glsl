// For opaque surfaces that pixels see: what they are made of and, where the site is the fragments, the irradiance
// from lights with shadow maps. opaque_area_lights.comp adds that of area lights; clusters have the rest.
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
#define BINDING_PIECE_CORNERS 17
#define BINDING_RAYS 18
#define BINDING_CLUSTER_PAINTS 19
#define THROUGH_BINDING 20
#include "lib/frame.glsl"
#include "lib/material.glsl"
#include "lib/seen_material.glsl"

layout(std430, set = 0, binding = 2) buffer Irradiances { vec4 irradiances[]; };
layout(std430, set = 0, binding = 16) writeonly buffer Materials { SeenMaterial materials[]; };

layout(push_constant) uniform Push {
  uint first;
  uint site;
  uint nodeCount;  // of all surfels' trees
  uint piecesPerSurfel;
};

#include "lib/irradiance.glsl"

SeenMaterial materialSeen(Seen seen, MeshPlace place, OpaqueData material) {
  MaterialPlace read = materialPlaceSeen(seen, place, material);
  SeenMaterial result = materialAt(material, read);
  SeenNormal mapped = mappedNormalSeen(seen, place, material, read);
  result.normal.xyz = mapped.normal;
  result.diffuse.w = widenedAlpha(result.diffuse.w, mapped.widened);
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
  if (withThinParts != 0u) extent = lengthsOver(seen, place);
  vec3 found = lightsIrradiance(liftedPlace(place), material.normal.xyz, place.normal, medium);
  irradiances[seen.entry] = vec4(found, 0.0);
}
