#pragma once

#include <cmath>
#include <cstdint>

#include "opaline/types.h"

namespace opaline::passes {

/// Unit direction of a place in [0,1]² on a face of a cube map, in Vulkan's convention.
inline Vec3 cubeDirection(std::uint32_t face, float u, float v) {
  const float a = 2 * u - 1;
  const float b = 2 * v - 1;
  Vec3 d{};
  switch (face) {
    case 0:
      d = {1, -b, -a};
      break;
    case 1:
      d = {-1, -b, a};
      break;
    case 2:
      d = {a, 1, b};
      break;
    case 3:
      d = {a, -1, -b};
      break;
    case 4:
      d = {a, -b, 1};
      break;
    default:
      d = {-a, -b, -1};
      break;
  }
  const float length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  return {d[0] / length, d[1] / length, d[2] / length};
}

}  // namespace opaline::passes
