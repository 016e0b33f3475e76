#include "surfels/tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace opaline::surfels {

namespace {

// Axes 0 to 2 are places, 3 to 5 facings, 6 is the layer.
constexpr std::size_t axes = 7;

float coordinate(const TreeItem& item, std::size_t axis) {
  if (axis < 3) return item.placeMm[axis];
  return axis < 6 ? item.facingMm[axis - 3] : item.layerMm;
}

struct Range {
  float low;
  float high;
};

Range rangeOf(std::span<const TreeItem> items, std::size_t axis) {
  const auto [low, high] =
      std::minmax_element(items.begin(), items.end(), [axis](const TreeItem& a, const TreeItem& b) {
        return coordinate(a, axis) < coordinate(b, axis);
      });
  return {coordinate(*low, axis), coordinate(*high, axis)};
}

std::size_t longestAxis(std::span<const TreeItem> items) {
  std::size_t longest = 0;
  float length = -1;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    const auto [low, high] = rangeOf(items, axis);
    if (high - low <= length) continue;
    longest = axis;
    length = high - low;
  }
  return longest;
}

// See maxSurfelsOfLeaf.
constexpr std::size_t leastSurfelsOfLeaf = 2;

class TreeBuilder {
 public:
  explicit TreeBuilder(std::uint32_t itemsPerSurfel) : itemsPerSurfel_(itemsPerSurfel) {}

  void addObject(std::span<TreeItem> items) {
    tree_.rootOfObject.push_back(nodeCount());
    if (!items.empty()) add(items);
  }

  Tree finish() {
    tree_.rootOfObject.push_back(nodeCount());
    return std::move(tree_);
  }

 private:
  std::uint32_t nodeCount() const { return static_cast<std::uint32_t>(tree_.links.size()); }

  // How many surfels go into the lower half along an axis. Places are cut at the median, but
  // facings, layers and places with a gap in the middle of their range: at the median the larger of
  // two sides would keep a part of the other.
  std::size_t surfelsInFront(std::span<const TreeItem> items, std::size_t axis) const {
    const std::size_t surfels = items.size() / itemsPerSurfel_;
    if (surfels < 2 * leastSurfelsOfLeaf) return surfels / 2;
    const auto [low, high] = rangeOf(items, axis);
    const float middle = (low + high) / 2;
    const float gap = (high - low) / 8;
    std::size_t lower = 0;
    std::size_t inGap = 0;
    for (const TreeItem& item : items) {
      const float at = coordinate(item, axis);
      if (at < middle) ++lower;
      if (std::abs(at - middle) < gap) ++inGap;
    }
    if (axis < 3 && inGap > 0) return surfels / 2;
    const std::size_t nearest = (lower + itemsPerSurfel_ / 2) / itemsPerSurfel_;
    return std::clamp(nearest, leastSurfelsOfLeaf, surfels - leastSurfelsOfLeaf);
  }

  // Moves the lower half along the longest axis to the front, in whole surfels.
  std::array<std::span<TreeItem>, 2> halve(std::span<TreeItem> items) const {
    const std::size_t axis = longestAxis(items);
    const std::size_t front = surfelsInFront(items, axis) * itemsPerSurfel_;
    // The index decides between equal places: one order on every machine.
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(front), items.end(),
                     [axis](const TreeItem& a, const TreeItem& b) {
                       const float left = coordinate(a, axis);
                       const float right = coordinate(b, axis);
                       return left != right ? left < right : a.index < b.index;
                     });
    return {items.first(front), items.subspan(front)};
  }

  void add(std::span<TreeItem> items) {
    const std::uint32_t node = nodeCount();
    const auto surfels = static_cast<std::uint32_t>(items.size() / itemsPerSurfel_);
    tree_.links.push_back(0);
    if (surfels <= maxSurfelsOfLeaf) {
      tree_.links[node] =
          Tree::leafBit | Tree::setBit | ((surfels - 1) << Tree::countShift) | firstSurfel_;
      firstSurfel_ += surfels;
      orderWithin(items);
      return;
    }
    for (const std::span<TreeItem> half : halve(items)) {
      if (half.size() <= std::size_t{maxSurfelsOfLeaf} * itemsPerSurfel_) {
        add(half);
        continue;
      }
      for (const std::span<TreeItem> quarter : halve(half)) add(quarter);
    }
    tree_.links[node] = Tree::setBit | nodeCount();
  }

  // Orders the items of a leaf so that each surfel's items are neighbours in space.
  void orderWithin(std::span<TreeItem> items) const {
    if (itemsPerSurfel_ == 1 || items.size() <= itemsPerSurfel_) return;
    for (const std::span<TreeItem> half : halve(items)) orderWithin(half);
  }

  std::uint32_t itemsPerSurfel_;
  std::uint32_t firstSurfel_ = 0;
  Tree tree_;
};

}  // namespace

NodeLink linkOf(const Tree& tree, std::uint32_t node) {
  const std::uint32_t link = tree.links[node];
  if ((link & Tree::leafBit) == 0) return {.end = link & (Tree::setBit - 1)};
  return {.leaf = true,
          .first = link & ((1U << Tree::countShift) - 1),
          .count = ((link & (Tree::setBit - 1)) >> Tree::countShift) + 1,
          .end = node + 1};
}

Tree makeTree(std::span<const std::span<TreeItem>> itemsOfObject, std::uint32_t itemsPerSurfel) {
  TreeBuilder builder(itemsPerSurfel);
  for (const std::span<TreeItem> items : itemsOfObject) builder.addObject(items);
  return builder.finish();
}

}  // namespace opaline::surfels
