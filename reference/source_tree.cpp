#include "reference/source_tree.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace opaline::reference {

namespace {

/// Halves a range along the longest edge of its box.
std::uint32_t* halve(std::uint32_t* begin, std::uint32_t* end,
                     const std::vector<Moments>& moments) {
  Vector least = moments[*begin].centre;
  Vector most = least;
  for (const std::uint32_t* i = begin; i != end; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      least[k] = std::min(least[k], moments[*i].centre[k]);
      most[k] = std::max(most[k], moments[*i].centre[k]);
    }
  }
  const Vector size = most - least;
  const auto axis =
      static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
  std::uint32_t* middle = begin + (end - begin) / 2;
  // The index breaks ties, so that the order is always the same.
  std::nth_element(begin, middle, end, [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(moments[a].centre[axis], a) < std::pair(moments[b].centre[axis], b);
  });
  return middle;
}

}  // namespace

SourceTree::SourceTree(Patches patches, std::stop_token stop)
    : patches_(std::move(patches.patches)), stop_(std::move(stop)) {
  if (patches_.empty()) return;
  std::vector<std::uint32_t> order(patches_.size());
  std::iota(order.begin(), order.end(), 0U);
  nodes_.reserve(patches_.size() + patches_.size() / 2 + 2);
  nodes_.emplace_back();
  build(0, order.data(), order.data() + order.size(), patches.moments);
}

void SourceTree::build(std::uint32_t node, std::uint32_t* begin, std::uint32_t* end,
                       const std::vector<Moments>& moments) {
  throwIfStopped(stop_);
  if (end - begin == 1) {
    nodes_[node] = {moments[*begin], *begin, 0};
    return;
  }
  std::array<std::uint32_t*, 5> cuts{begin, nullptr, halve(begin, end, moments), nullptr, end};
  cuts[1] = cuts[2] - begin > 1 ? halve(begin, cuts[2], moments) : begin;
  cuts[3] = end - cuts[2] > 1 ? halve(cuts[2], end, moments) : cuts[2];
  const auto first = static_cast<std::uint32_t>(nodes_.size());
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < 4; ++i) count += cuts[i] != cuts[i + 1] ? 1U : 0U;
  nodes_.resize(nodes_.size() + count);
  std::uint32_t child = first;
  for (std::size_t i = 0; i < 4; ++i) {
    if (cuts[i] != cuts[i + 1]) build(child++, cuts[i], cuts[i + 1], moments);
  }
  std::array<Moments, 4> parts;
  for (std::uint32_t i = 0; i < count; ++i) parts[i] = nodes_[first + i].moments;
  nodes_[node] = {joined(parts.data(), count), first, count};
}

}  // namespace opaline::reference
