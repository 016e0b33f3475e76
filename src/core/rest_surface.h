#pragma once

#include <cstdint>
#include <span>

#include "opaline/types.h"

namespace opaline::core {

/// The rest pose of everything that is divided or flattened together, seen as one surface.
struct RestSurface {
  std::span<const Vec3> positionsMm;
  std::span<const Triangle> triangles;
  std::span<const std::uint32_t> objectOfTriangle;
};

}  // namespace opaline::core
