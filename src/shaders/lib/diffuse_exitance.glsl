// What leaves an opaque surface diffusely towards the side that is seen: light that falls on that side, and light from
// the other side that gets through. Needs lib/bodies.glsl, lib/mesh.glsl with BINDING_MESH_EXITANCES, and shared/opaque.h.
#ifndef OPALINE_LIB_DIFFUSE_EXITANCE
#define OPALINE_LIB_DIFFUSE_EXITANCE

vec3 ofBothSides(SeenMaterial material, vec3 irradiance, vec3 behind) {
  return material.diffuse.rgb * irradiance + material.through.rgb * behind;
}

// From irradiances at vertices, where those of the backs of sheets follow the others.
vec3 diffuseExitanceOfVertices(MeshPlace place, SeenMaterial material, uint vertexCount) {
  if (!hasBack(objects[place.object])) return material.diffuse.rgb * meshExitanceAt(place, 0u).rgb;
  vec3 front = meshExitanceAt(place, 0u).rgb;
  vec3 back = meshExitanceAt(place, vertexCount).rgb;
  return place.side < 0.0 ? ofBothSides(material, back, front) : ofBothSides(material, front, back);
}

#endif
