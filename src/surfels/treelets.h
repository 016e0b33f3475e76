#pragma once

#include <cstdint>
#include <vector>

#include "surfels/tree.h"

namespace opaline::surfels {

/// Most inner nodes of a treelet, which a work group fits.
constexpr std::uint32_t maxNodesOfTreelet = 256;

/// In which order the nodes of a tree are fitted, children before parents, in few steps: leaves,
/// then stages, whose treelets do not wait for each other.
struct Treelets {
  std::vector<std::uint32_t> leaves;
  /// Inner nodes, treelet after treelet and level after level.
  std::vector<std::uint32_t> nodes;
  /// Into nodes. The levels of a treelet: nodes of which none is below another.
  std::vector<std::uint32_t> firstOfLevel;
  /// Into firstOfLevel, of each treelet; one more than there are treelets.
  std::vector<std::uint32_t> levelOfTreelet;
  /// Treelets; one more than there are stages.
  std::vector<std::uint32_t> firstOfStage;
};

/// Subtrees of at most that many inner nodes, several small ones together; then the same of what is
/// left, until that is nothing.
Treelets makeTreelets(const Tree& tree, std::uint32_t maxNodes = maxNodesOfTreelet);

}  // namespace opaline::surfels
