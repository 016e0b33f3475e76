#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "soft_body/cage.h"

namespace opaline::soft_body {

/// The weight of a node of the cage at a place of the grid.
struct SpreadPart {
  std::uint32_t node = 0;
  float weight = 0;
};

/// A full grid of places around a cage, x fastest, which extends one cell beyond it on every side,
/// and how values at the cage's nodes are carried to these places. Places far from the cage get
/// nothing.
struct Spread {
  std::array<std::uint32_t, 3>
      size{};  ///< places; the first lies one cell before the cage's origin
  std::vector<std::uint32_t> firstPart;  ///< one per place and one more
  std::vector<SpreadPart> parts;
};

/// Places at nodes of the cage take the nodes' values. Places beside it take moving least squares
/// of first order (Lancaster and Šalkauskas 1981), so that a body's outermost parts continue the
/// motion of its inside.
Spread makeSpread(const Cage& cage);

}  // namespace opaline::soft_body
