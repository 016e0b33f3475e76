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

/// One channel of a texture at a point of a body, between its pixels linear; 1 where there is no
/// texture.
double textureAt(const Body& body, const SurfacePoint& point, const std::optional<Texture>& texture,
                 std::size_t channel, TexelKind kind);

/// One channel of the colours of a body's vertices; 1 where they have none.
double vertexColorAt(const Body& body, const SurfacePoint& point, std::size_t channel);

}  // namespace opaline::reference
