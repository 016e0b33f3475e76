#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "soft_body/cage.h"

namespace opaline::soft_body {

/// Part that a node of the cage has in a place of the grid.
struct SpreadPart {
  std::uint32_t node = 0;
  float weight = 0;
};

/// A full grid of places around a cage, one cell beyond it on every side, x fastest, and how what
/// is known at the cage's nodes is carried to them. Places far from the cage get nothing.
struct Spread {
  std::array<std::uint32_t, 3>
      size{};  ///< places; the first lies one cell before the cage's origin
  std::vector<std::uint32_t> firstPart;  ///< one a place and one more
  std::vector<SpreadPart> parts;
};

/// At nodes of the cage what they have; next to it by moving least squares of first order
/// (Lancaster and Šalkauskas 1981), so that a body's outermost parts go on as its inside does.
Spread makeSpread(const Cage& cage);

}  // namespace opaline::soft_body
