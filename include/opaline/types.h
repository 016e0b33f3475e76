#pragma once

#include <array>
#include <cstdint>

namespace opaline {

/// Two coordinates without a unit, for example a place in a texture.
using Vec2 = std::array<float, 2>;

/// Three coordinates. Lengths are millimetres, directions have unit length unless said otherwise.
using Vec3 = std::array<float, 3>;

/// A light quantity in linear sRGB primaries.
using Rgb = std::array<float, 3>;

/// Vertex indices, counter-clockwise seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

/// For the library: whether a value of an enumeration is one of those up to the last, for a cast
/// makes a value of any number.
template <typename Enumeration>
constexpr bool isUpTo(Enumeration last, Enumeration value) {
  return value >= Enumeration{} && value <= last;
}

}  // namespace opaline
