#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "opaline/types.h"

namespace opaline::surfels {

/// Most surfels that a leaf holds. A leaf holds at least two, unless its object has only one.
constexpr std::uint32_t maxSurfelsOfLeaf = 4;

/// How many objects' surfels hang together, in an array of nodes in depth-first order: the first
/// child of an inner node follows it. It is made from the rest pose, and kept when that deforms.
struct Tree {
  static constexpr std::uint32_t leafBit = 1U << 31U;
  static constexpr std::uint32_t setBit = 1U << 29U;  ///< in all, which makes them normal floats
  static constexpr std::uint32_t countShift = 26;

  /// One a node. A leaf: leafBit, number of surfels - 1 from bit countShift, first surfel below. An
  /// inner node, which has two to four children: the node after the last of all below it.
  std::vector<std::uint32_t> links;
  std::vector<std::uint32_t> rootOfObject;  ///< one more than there are objects
};

/// A node's link taken apart.
struct NodeLink {
  bool leaf = false;
  std::uint32_t first = 0;  ///< surfel of a leaf
  std::uint32_t count = 0;  ///< of a leaf's surfels
  std::uint32_t end = 0;    ///< the node after all that are below
};
NodeLink linkOf(const Tree& tree, std::uint32_t node);

/// What is to be ordered: a place and what it belongs to.
struct TreeItem {
  Vec3 placeMm{};
  std::uint32_t index = 0;
  Vec3 facingMm{};  ///< normal, to be told apart like places; 0 where that is not wanted
};

/// Orders the items of each object so that any few neighbours in the order are neighbours in space,
/// every `itemsPerSurfel` of them one surfel, and makes their tree: halves along the longest axis
/// of places and facings, those at the median but in gaps, these in the middle, so that
/// sides come apart as a whole. Every object's number of items is a multiple of
/// itemsPerSurfel.
Tree makeTree(std::span<const std::span<TreeItem>> itemsOfObject, std::uint32_t itemsPerSurfel);

}  // namespace opaline::surfels
