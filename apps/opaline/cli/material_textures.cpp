#include "cli/material_textures.h"

namespace opaline::app {

std::vector<NamedTexture> texturesOf(const Object& object) {
  std::vector<NamedTexture> there;
  const auto add = [&](const char* use, const std::optional<Texture>& texture) {
    if (texture) there.push_back({use, &*texture});
  };
  if (object.opaque) {
    const OpaqueMaterial& material = *object.opaque;
    add("base color", material.baseColorTexture);
    add("metallic-roughness", material.metallicRoughnessTexture);
    add("specular", material.specularTexture);
    add("specular color", material.specularColorTexture);
    add("normal", material.normalTexture);
    add("occlusion", material.occlusionTexture);
    add("emission", material.emissionTexture);
    return there;
  }
  if (object.paint) add("color", object.paint->colorTexture);
  if (!object.surface) return there;
  add("metallic-roughness", object.surface->metallicRoughnessTexture);
  add("normal", object.surface->normalTexture);
  return there;
}

}  // namespace opaline::app
