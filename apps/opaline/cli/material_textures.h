#pragma once

#include <string_view>
#include <vector>

#include "opaline/scene.h"

namespace opaline::app {

/// A texture and its use.
struct NamedTexture {
  std::string_view use;
  const Texture* texture;  ///< belongs to the object
};

/// All textures of an object's material: of an opaque one, of a paint, and of a translucent
/// surface.
std::vector<NamedTexture> texturesOf(const Object& object);

}  // namespace opaline::app
