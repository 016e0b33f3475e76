#include "scene/mesh/point_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace opaline::scene {

namespace {

constexpr std::uint32_t none = ~0U;
constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

const PointTree::Node PointTree::empty{{infinity, infinity}, {-infinity, -infinity}, 0};

PointTree::Node PointTree::together(const Node& a, const Node& b) {
  return {{std::min(a.low[0], b.low[0]), std::min(a.low[1], b.low[1])},
          {std::max(a.high[0], b.high[0]), std::max(a.high[1], b.high[1])},
          a.left + b.left};
}

PointTree::Range PointTree::Range::half(std::size_t which) const {
  const std::size_t middle = begin + (end - begin) / 2;
  return which == 0 ? Range{2 * node + 1, begin, middle} : Range{2 * node + 2, middle, end};
}

void PointTree::build(std::span<const Double2> points) {
  points_ = points;
  order_.resize(points.size());
  placeOf_.resize(points.size());
  std::iota(order_.begin(), order_.end(), 0U);
  std::iota(placeOf_.begin(), placeOf_.end(), 0U);
  nodes_.clear();
  build({0, 0, points.size()});
  for (std::uint32_t i = 0; i < order_.size(); ++i) placeOf_[order_[i]] = i;
}

void PointTree::build(const Range& range) {
  if (nodes_.size() <= range.node) nodes_.resize(range.node + 1);
  nodes_[range.node] = nodeOf(range);
  if (range.isLeaf()) return;
  const Node& node = nodes_[range.node];
  const std::size_t axis = node.high[0] - node.low[0] >= node.high[1] - node.low[1] ? 0 : 1;
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  const auto precedes = [&](std::uint32_t a, std::uint32_t b) {
    return points_[a][axis] < points_[b][axis];
  };
  std::nth_element(at(range.begin), at(range.half(0).end), at(range.end), precedes);
  build(range.half(0));
  build(range.half(1));
}

/// The node for the points of a range.
PointTree::Node PointTree::nodeOf(const Range& range) const {
  Node node = empty;
  for (std::size_t i = range.begin; i < range.end; ++i) {
    if (placeOf_[order_[i]] == none) continue;
    const Double2& p = points_[order_[i]];
    node = together(node, {p, p, 1});
  }
  return node;
}

void PointTree::remove(std::uint32_t point) {
  const std::size_t place = placeOf_[point];
  placeOf_[point] = none;
  remove({0, 0, points_.size()}, place);
}

void PointTree::remove(const Range& range, std::size_t place) {
  if (range.isLeaf()) {
    nodes_[range.node] = nodeOf(range);
    return;
  }
  const Range first = range.half(0);
  const Range second = range.half(1);
  remove(place < first.end ? first : second, place);
  nodes_[range.node] = together(nodes_[first.node], nodes_[second.node]);
}

std::optional<std::uint32_t> PointTree::inside(const std::array<std::uint32_t, 3>& corners,
                                               std::size_t& steps) const {
  return inside({0, 0, points_.size()}, corners, steps);
}

std::optional<std::uint32_t> PointTree::inside(const Range& range,
                                               const std::array<std::uint32_t, 3>& corners,
                                               std::size_t& steps) const {
  ++steps;
  const Node& node = nodes_[range.node];
  if (node.left == 0 || isOutside(node, corners)) return std::nullopt;
  if (!range.isLeaf()) {
    const auto found = inside(range.half(0), corners, steps);
    return found ? found : inside(range.half(1), corners, steps);
  }
  steps += range.end - range.begin;
  for (std::size_t i = range.begin; i < range.end; ++i)
    if (placeOf_[order_[i]] != none && contains(corners, order_[i])) return order_[i];
  return std::nullopt;
}

/// Whether the box lies beyond one side of the triangle. turn() is largest at one corner of the
/// box, since rounding keeps it monotonic.
bool PointTree::isOutside(const Node& node, const std::array<std::uint32_t, 3>& corners) const {
  for (std::size_t i = 0; i < 3; ++i) {
    const Double2& a = points_[corners[i]];
    const Double2& b = points_[corners[(i + 1) % 3]];
    const Double2 nearest{b[1] - a[1] > 0 ? node.low[0] : node.high[0],
                          b[0] - a[0] > 0 ? node.high[1] : node.low[1]};
    if (turn(a, b, nearest) < 0) return true;
  }
  return false;
}

bool PointTree::contains(const std::array<std::uint32_t, 3>& corners, std::uint32_t point) const {
  const Double2& p = points_[point];
  for (std::size_t i = 0; i < 3; ++i) {
    const Double2& a = points_[corners[i]];
    if (corners[i] == point || a == p) return false;
    if (!(turn(a, points_[corners[(i + 1) % 3]], p) >= 0)) return false;
  }
  return true;
}

}  // namespace opaline::scene
