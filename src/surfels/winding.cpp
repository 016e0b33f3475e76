#include "surfels/winding.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace opaline::surfels {

namespace {

constexpr std::uint32_t trianglesOfLeaf = 8;

// Beyond this many of its radii, a node is taken as a whole.
constexpr double farInRadii = 4;

// Van Oosterom and Strackee 1983; positive from inside.
double solidAngle(const std::array<Vector, 3>& corners, const Vector& from) {
  const Vector a = difference(corners[0], from);
  const Vector b = difference(corners[1], from);
  const Vector c = difference(corners[2], from);
  const double la = lengthOf(a);
  const double lb = lengthOf(b);
  const double lc = lengthOf(c);
  const double over = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
  return 2 * std::atan2(dot(a, cross(b, c)), over);
}

Vector middleOf(const std::array<Vector, 3>& corners) {
  Vector middle{};
  for (const Vector& corner : corners) addTimes(1.0 / 3, corner, middle);
  return middle;
}

}  // namespace

WindingNumber::WindingNumber(const core::RestSurface& surface,
                             std::span<const std::uint32_t> triangles) {
  triangles_.reserve(triangles.size());
  for (const std::uint32_t t : triangles) {
    Corners corners{};
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = vectorOf(surface.positionsMm[surface.triangles[t][i]]);
      box_.include(corners[i]);
    }
    triangles_.push_back(corners);
  }
  if (!triangles_.empty()) add(0, static_cast<std::uint32_t>(triangles_.size()));
}

WindingNumber::Node WindingNumber::nodeOf(std::uint32_t first, std::uint32_t end) const {
  Node node{.first = first, .end = end};
  double area = 0;
  Vector plain{};
  for (std::uint32_t t = first; t < end; ++t) {
    const Corners& corners = triangles_[t];
    const Vector twice =
        cross(difference(corners[1], corners[0]), difference(corners[2], corners[0]));
    addTimes(0.5, twice, node.vectorAreaMm2);
    addTimes(lengthOf(twice), middleOf(corners), node.middleMm);
    area += lengthOf(twice);
    addTimes(1.0 / (end - first), middleOf(corners), plain);
  }
  if (area > 0)
    for (double& axis : node.middleMm) axis /= area;
  else
    node.middleMm = plain;
  for (std::uint32_t t = first; t < end; ++t)
    for (const Vector& corner : triangles_[t])
      node.radiusMm = std::max(node.radiusMm, lengthOf(difference(corner, node.middleMm)));
  return node;
}

void WindingNumber::add(std::uint32_t first, std::uint32_t end) {
  const std::size_t made = nodes_.size();
  nodes_.push_back(nodeOf(first, end));
  if (end - first > trianglesOfLeaf) {
    Box middles;
    for (std::uint32_t t = first; t < end; ++t) middles.include(middleOf(triangles_[t]));
    const Vector extent = difference(middles.high, middles.low);
    const auto axis =
        static_cast<std::size_t>(std::max_element(extent.begin(), extent.end()) - extent.begin());
    const std::uint32_t half = first + (end - first) / 2;
    std::nth_element(triangles_.begin() + first, triangles_.begin() + half,
                     triangles_.begin() + end, [axis](const Corners& a, const Corners& b) {
                       return middleOf(a)[axis] < middleOf(b)[axis];
                     });
    add(first, half);
    add(half, end);
  }
  nodes_[made].next = static_cast<std::uint32_t>(nodes_.size());
}

double WindingNumber::at(const Vector& placeMm) const {
  double sum = 0;
  for (std::uint32_t n = 0; n < nodes_.size();) {
    const Node& node = nodes_[n];
    const Vector offset = difference(node.middleMm, placeMm);
    const double away = lengthOf(offset);
    const bool leaf = node.end - node.first <= trianglesOfLeaf;
    if (away > farInRadii * node.radiusMm)
      sum += dot(offset, node.vectorAreaMm2) / (away * away * away);
    else if (leaf)
      for (std::uint32_t t = node.first; t < node.end; ++t)
        sum += solidAngle(triangles_[t], placeMm);
    else {
      ++n;
      continue;
    }
    n = node.next;
  }
  return sum / (4 * std::numbers::pi);
}

bool WindingNumber::isInside(const Vector& placeMm) const {
  return box_.contains(placeMm) && at(placeMm) > 0.5;
}

}  // namespace opaline::surfels
