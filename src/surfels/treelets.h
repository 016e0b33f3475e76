#pragma once

#include <cstdint>
#include <vector>

#include "surfels/tree.h"

namespace opaline::surfels {

/// The largest number of inner nodes of a treelet. One work group fits a treelet.
constexpr std::uint32_t maxNodesOfTreelet = 256;

/// The order in which the nodes of a tree are fitted in few steps, children before parents: leaves,
/// then stages. Treelets of a stage do not depend on each other.
struct Treelets {
  std::vector<std::uint32_t> leaves;
  /// Inner nodes, treelet after treelet and level after level.
  std::vector<std::uint32_t> nodes;
  /// Indices into nodes, of the levels of treelets. No node of a level is below another.
  std::vector<std::uint32_t> firstOfLevel;
  /// Indices into firstOfLevel; one more than there are treelets.
  std::vector<std::uint32_t> levelOfTreelet;
  /// The first treelet of each stage; one more entry than there are stages.
  std::vector<std::uint32_t> firstOfStage;
};

/// Takes subtrees of at most that many inner nodes, several small ones together, as treelets, and
/// repeats this with the rest of the tree until nothing is left.
Treelets makeTreelets(const Tree& tree, std::uint32_t maxNodes = maxNodesOfTreelet);

}  // namespace opaline::surfels
