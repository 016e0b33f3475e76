#pragma once

#include <cstddef>

#include "opaline/material.h"
#include "reference/geometry.h"

namespace opaline::reference {

/// How a texture's numbers are to be read.
enum class TexelKind {
  Color,  ///< sRGB, but for alpha
  Number,
};

/// One channel of a texture at a point of a body, interpolated linearly between pixels; 1 without a
/// texture.
double textureAt(const Body& body, const SurfacePoint& point, const std::optional<Texture>& texture,
                 std::size_t channel, TexelKind kind);

/// One channel of the vertex colours of a body; 1 where it has none.
double vertexColorAt(const Body& body, const SurfacePoint& point, std::size_t channel);

}  // namespace opaline::reference
