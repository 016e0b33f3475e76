// How rough the translucent surfaces are that pixels see, and which way they face.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SEEN 1
#define BINDING_OBJECTS 2
#define BINDING_MEDIA 3
#define MESH_BINDING 4
#define BINDING_SEEN_LIST 8
#define BINDING_OPAQUES 10
#define BINDING_TEXELS 13
#include "lib/frame.glsl"
#include "lib/material.glsl"
#include "lib/seen_material.glsl"

layout(std430, set = 0, binding = 14) writeonly buffer Materials { SeenMaterial materials[]; };

layout(push_constant) uniform Push {
  uint first;
  float alpha;  // roughness² where none is stated
};

void main() {
  Seen seen = seenOfInvocation(first);
  if (!seen.there) return;
  MeshPlace place = seenPlace(seen.pixel, seen.word);
  ObjectData body = objects[place.object];
  if (isOpaque(body)) return;
  MediumData medium = mediumAt(body, place.position);
  materials[seen.entry].diffuse.w = alpha;
  materials[seen.entry].normal.xyz = place.normal;
  if (!hasOwnSurface(medium)) return;
  OpaqueData material = opaques[medium.tables.y];
  MaterialPlace read = materialPlaceSeen(seen, place, material);
  SeenNormal mapped = mappedNormalSeen(seen, place, material, read);
  float its = material.surface.y < 0.0 ? alpha : alphaAt(material, read);
  materials[seen.entry].diffuse.w = widenedAlpha(its, mapped.widened);
  materials[seen.entry].normal.xyz = mapped.normal;
}
