#include "cli/material_textures.h"

namespace opaline::app {

std::vector<NamedTexture> texturesOf(const Object& object) {
  std::vector<NamedTexture> there;
  const auto add = [&](std::string_view use, const std::optional<Texture>& texture) {
    if (texture) there.push_back({use, &*texture});
  };
  if (object.opaque) {
    for (const TextureOfMaterial& of : texturesOfMaterial)
      add(of.use, (*object.opaque).*of.texture);
    return there;
  }
  if (object.paint) add("color", object.paint->colorTexture);
  if (!object.surface) return there;
  add("metallic-roughness", object.surface->metallicRoughnessTexture);
  add("normal", object.surface->normalTexture);
  return there;
}

}  // namespace opaline::app
