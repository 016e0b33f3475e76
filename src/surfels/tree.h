#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "opaline/types.h"

namespace opaline::surfels {

/// Most surfels that a leaf holds. A leaf holds at least two, unless its object has only one.
constexpr std::uint32_t maxSurfelsOfLeaf = 4;

/// A tree of the surfels of each object, as an array of nodes in depth-first order: the first child
/// of an inner node follows it. It is made from the rest pose and kept when the surface deforms.
struct Tree {
  static constexpr std::uint32_t leafBit = 1U << 31U;
  static constexpr std::uint32_t setBit = 1U << 29U;  ///< set in all links, so that they are normal
                                                      ///< floats
  static constexpr std::uint32_t countShift = 26;

  /// One per node. A leaf has leafBit, the number of its surfels - 1 from bit countShift on, and
  /// its first surfel below that. An inner node, which has two to four children, has the node after
  /// the last of all those below it.
  std::vector<std::uint32_t> links;
  std::vector<std::uint32_t> rootOfObject;  ///< one more entry than there are objects
};

/// A node's link taken apart.
struct NodeLink {
  bool leaf = false;
  std::uint32_t first = 0;  ///< first surfel of a leaf
  std::uint32_t count = 0;  ///< of a leaf's surfels
  std::uint32_t end = 0;    ///< the node after all those below it
};
NodeLink linkOf(const Tree& tree, std::uint32_t node);

/// An item to be ordered: a place and what it belongs to.
struct TreeItem {
  Vec3 placeMm{};
  std::uint32_t index = 0;
  Vec3 facingMm{};    ///< normal, which separates items as places do; 0: does not
  float layerMm = 0;  ///< separates what lies upon each other as places do
};

/// Orders the items of each object so that neighbours in the order are neighbours in space and
/// every `itemsPerSurfel` of them are one surfel, and makes their tree. It halves items along the
/// longest axis of places, facings and layers: places at the median or in a gap, facings and layers
/// in the middle, so that sides and layers are separated as a whole. Every object's number of items
/// is a multiple of itemsPerSurfel.
Tree makeTree(std::span<const std::span<TreeItem>> itemsOfObject, std::uint32_t itemsPerSurfel);

}  // namespace opaline::surfels
