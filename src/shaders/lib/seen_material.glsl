// Where a pixel reads the textures of the surface that it sees. Needs what lib/seen_list.glsl and
// lib/opaque_material.glsl need.
#ifndef OPALINE_LIB_SEEN_MATERIAL
#define OPALINE_LIB_SEEN_MATERIAL
#include "lib/opaque_material.glsl"
#include "lib/seen_list.glsl"
#include "lib/footprint.glsl"

MaterialPlace materialPlaceSeen(Seen seen, MeshPlace place, OpaqueData material) {
  if (material.rest.z == 0.0) return plainPlace();
  mat2x3 over = weightsOver(seen, place);
  return materialPlaceOn(place.vertices, place.weights, over[0], over[1]);
}

// The normal that the texture gives there, on the side that is seen.
struct SeenNormal {
  vec3 normal;
  float widened;  // see mappedNormal
};

SeenNormal mappedNormalAt(Seen seen, MeshPlace place, OpaqueData material, MaterialPlace read) {
  vec3 first = positionOf(place.vertices.x);
  vec3 toSecond = positionOf(place.vertices.y) - first;
  vec3 toThird = positionOf(place.vertices.z) - first;
  SeenNormal mapped;
  mapped.normal = place.side * mappedNormal(material, read, triangleOf(seen.word), place.weights, toSecond, toThird,
                                            place.side * place.normal, mapped.widened);
  return mapped;
}

// A normal turned away from the eye would be black.
SeenNormal mappedNormalSeen(Seen seen, MeshPlace place, OpaqueData material, MaterialPlace read) {
  SeenNormal mapped = mappedNormalAt(seen, place, material, read);
  vec3 toCamera = normalize(toCameraFrom(place.position));
  float facing = dot(mapped.normal, toCamera);
  if (facing < 0.01) mapped.normal = normalize(mapped.normal + (0.01 - facing) * toCamera);
  return mapped;
}

#endif
