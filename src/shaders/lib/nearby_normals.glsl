// Normals by which light falls on the surface around a place that a pixel sees, where a texture gives them: means over
// the disc and the rings of lib/nearby.glsl. Needs what lib/nearby.glsl and lib/seen_material.glsl need.
#ifndef OPALINE_LIB_NEARBY_NORMALS
#define OPALINE_LIB_NEARBY_NORMALS
#include "lib/nearby.glsl"
#include "lib/seen_material.glsl"

float sizeOf(MaterialPlace read, OpaqueData material) {
  bool second = (material.normalTexture.place.w & textureIsOnSecondSet) != 0u;
  TexturePlace place = read.first;
  if (second) place = read.second;
  return max(length(place.right), length(place.down));
}

// Reads over a disc of that radius, mm, around the place in the plane of its triangle.
MaterialPlace materialPlaceAround(MeshPlace place, float radius) {
  vec3 first = positionOf(place.vertices.x);
  vec3 toSecond = positionOf(place.vertices.y) - first;
  vec3 toThird = positionOf(place.vertices.z) - first;
  vec3 facet = cross(toSecond, toThird);
  float squared = max(dot(facet, facet), 1e-30);
  vec3 along = 2.0 * radius * unitOr(toSecond, vec3(0.0));
  vec3 across = 2.0 * radius * unitOr(cross(facet, toSecond), vec3(0.0));
  vec2 right = vec2(dot(cross(along, toThird), facet), dot(cross(toSecond, along), facet)) / squared;
  vec2 down = vec2(dot(cross(across, toThird), facet), dot(cross(toSecond, across), facet)) / squared;
  return materialPlaceOn(place.vertices, place.weights, vec3(-right.x - right.y, right),
                         vec3(-down.x - down.y, down));
}

vec3 normalAround(Seen seen, MeshPlace place, OpaqueData material, MaterialPlace pixel, float radius) {
  MaterialPlace read = materialPlaceAround(place, radius);
  if (sizeOf(pixel, material) > sizeOf(read, material)) read = pixel;
  return place.side * mappedNormalAt(seen, place, material, read).normal;
}

LitNormals litNormalsAt(Seen seen, MeshPlace place, ObjectData body) {
  vec3 outwards = place.side * place.normal;
  MediumData medium = mediumAt(body, place.position);
  OpaqueData material = opaques[medium.tables.y];
  if (!hasOwnSurface(medium) || !isThere(material.normalTexture)) return LitNormals(outwards, outwards, outwards);
  float reach = body.darkest.w;
  MaterialPlace pixel = materialPlaceSeen(seen, place, material);
  return LitNormals(normalAround(seen, place, material, pixel, discInReaches * reach),
                    normalAround(seen, place, material, pixel, innerRingAt * reach),
                    normalAround(seen, place, material, pixel, outerRingAt * reach));
}

#endif
