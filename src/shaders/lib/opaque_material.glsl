// What opaque surfaces are made of. Needs, before it, BINDING_OPAQUES, the first of three bindings,
// and BINDING_TEXELS.
#ifndef OPALINE_LIB_OPAQUE_MATERIAL
#define OPALINE_LIB_OPAQUE_MATERIAL
#include "lib/texture.glsl"
#include "lib/unit.glsl"

layout(std430, set = 0, binding = BINDING_OPAQUES) readonly buffer Opaques { OpaqueData opaques[]; };
layout(std430, set = 0, binding = BINDING_OPAQUES + 1) readonly buffer Attributes { VertexAttributes attributes[]; };
layout(std430, set = 0, binding = BINDING_OPAQUES + 2) readonly buffer Tangents { CornerTangents tangents[]; };

// What a material needs of a mesh at one place.
struct MaterialPlace {
  TexturePlace first;  // by the first set of coordinates
  TexturePlace second;
  vec4 color;
};

MaterialPlace plainPlace() {
  TexturePlace none = TexturePlace(vec2(0.0), vec2(0.0), vec2(0.0));
  return MaterialPlace(none, none, vec4(1.0));
}

// On a triangle, by the weights of its corners there and their change to the right and down.
MaterialPlace materialPlaceOn(uvec3 vertices, vec3 at, vec3 right, vec3 down) {
  VertexAttributes a = attributes[vertices.x];
  VertexAttributes b = attributes[vertices.y];
  VertexAttributes c = attributes[vertices.z];
  vec4 coordinates = at.x * a.coordinates + at.y * b.coordinates + at.z * c.coordinates;
  vec4 toRight = right.x * a.coordinates + right.y * b.coordinates + right.z * c.coordinates;
  vec4 toDown = down.x * a.coordinates + down.y * b.coordinates + down.z * c.coordinates;
  vec4 color = at.x * a.color + at.y * b.color + at.z * c.color;
  return MaterialPlace(TexturePlace(coordinates.xy, toRight.xy, toDown.xy),
                       TexturePlace(coordinates.zw, toRight.zw, toDown.zw), clamp(color, 0.0, 1.0));
}

vec4 textureAt(TextureData data, MaterialPlace place, vec4 missing) {
  if (!isThere(data)) return missing;
  if ((data.place.w & textureIsOnSecondSet) != 0u) return sampled(data, place.second);
  return sampled(data, place.first);
}

vec4 baseColorAt(OpaqueData material, MaterialPlace place) {
  return clamp(material.baseColor * place.color * textureAt(material.baseColorTexture, place, vec4(1.0)), 0.0, 1.0);
}

// α of the reflection, by what its texture says.
float alphaOf(OpaqueData material, float told) {
  float roughness = clamp(material.surface.y * told, 0.02, 1.0);
  return roughness * roughness;
}

float alphaAt(OpaqueData material, MaterialPlace place) {
  return alphaOf(material, textureAt(material.metallicRoughnessTexture, place, vec4(1.0)).g);
}

// For a surface whose normals differ within a pixel.
float widenedAlpha(float alpha, float widened) {
  return min(sqrt(alpha * alpha + widened), 1.0);
}

// The mean over the pixel, in tangent space.
vec3 toldNormal(OpaqueData material, MaterialPlace place) {
  return textureAt(material.normalTexture, place, vec4(0.0, 0.0, 1.0, 0.0)).xyz;
}

// Share of the diffuse light that goes through to the other side.
float throughAt(OpaqueData material, MaterialPlace place) {
  if (material.through.w == 0.0) return 0.0;
  return clamp(material.through.w * textureAt(material.throughTexture, place, vec4(1.0)).a, 0.0, 1.0);
}

// glTF 2.0, section 3.9 and appendix B, with KHR_materials_specular and KHR_materials_diffuse_transmission. The normal
// is not set.
SeenMaterial materialAt(OpaqueData material, MaterialPlace place) {
  vec3 base = baseColorAt(material, place).rgb;
  vec4 found = textureAt(material.metallicRoughnessTexture, place, vec4(1.0));
  float metallic = clamp(material.surface.x * found.b, 0.0, 1.0);
  float strength = material.surface.w * textureAt(material.specularTexture, place, vec4(1.0)).a;
  vec3 tint = material.specularColor.rgb * textureAt(material.specularColorTexture, place, vec4(1.0)).rgb;
  vec3 dielectric = min(material.surface.z * tint, vec3(1.0)) * strength;
  float occlusion = textureAt(material.occlusionTexture, place, vec4(1.0)).r;
  float through = throughAt(material, place);
  SeenMaterial result;
  result.diffuse = vec4((1.0 - metallic) * (1.0 - through) * base, alphaOf(material, found.g));
  result.dielectric = vec4(dielectric, strength);
  result.metal = vec4(base, metallic);
  result.normal = vec4(0.0, 0.0, 0.0, mix(1.0, occlusion, material.rest.x));
  result.emission = vec4(material.emission.rgb * textureAt(material.emissionTexture, place, vec4(1.0)).rgb,
                         material.rest.y);
  result.around = vec4(0.0, 0.0, 0.0, 1.0);
  if (material.rest.y != 0.0) {
    result.emission.rgb = base;
    result.diffuse.rgb = vec3(0.0);
    result.dielectric = vec4(0.0);
    result.metal = vec4(0.0);
    through = 0.0;
  }
  result.through = vec4(0.0);
  result.behind = vec4(0.0);
  if (through > 0.0) {
    vec3 tint = material.through.rgb * textureAt(material.throughColorTexture, place, vec4(1.0)).rgb;
    result.through.rgb = (1.0 - metallic) * through * min(tint, vec3(1.0));
  }
  return result;
}

// The normal that the texture gives, where these are the edges from the first corner of a triangle.
// `widened` is how much less sharp the reflection becomes (Toksvig 2005), as more of roughness⁴.
vec3 mappedNormal(OpaqueData material, MaterialPlace place, uint triangle, vec3 weights, vec3 toSecond,
                  vec3 toThird, vec3 normal, out float widened) {
  widened = 0.0;
  if (!isThere(material.normalTexture)) return normal;
  vec3 told = toldNormal(material, place);
  float size = clamp(length(told), 1e-3, 1.0);
  widened = max(2.0 * (1.0 - size) / size - 2e-3, 0.0);
  told.xy *= material.specularColor.w;
  CornerTangents corners = tangents[triangle];
  vec3 tangent = weights.x * unitOr(corners.first.x * toSecond + corners.first.y * toThird, vec3(0.0)) +
                 weights.y * unitOr(corners.first.z * toSecond + corners.first.w * toThird, vec3(0.0)) +
                 weights.z * unitOr(corners.last.x * toSecond + corners.last.y * toThird, vec3(0.0));
  tangent -= dot(tangent, normal) * normal;
  vec3 along = unitOr(tangent, vec3(0.0));
  vec3 across = corners.last.z * cross(normal, along);
  return unitOr(told.x * along + told.y * across + told.z * normal, normal);
}

#endif
