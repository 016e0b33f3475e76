#pragma once

#include <string_view>
#include <vector>

#include "opaline/scene.h"

namespace opaline::app {

/// A texture and what it is for.
struct NamedTexture {
  std::string_view use;
  const Texture* texture;  ///< of the object
};

/// All that an object's material has, of an opaque one, of a paint and of a translucent surface.
std::vector<NamedTexture> texturesOf(const Object& object);

}  // namespace opaline::app
