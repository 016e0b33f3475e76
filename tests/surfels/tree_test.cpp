#include "surfels/tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <tuple>
#include <vector>

namespace opaline::surfels {
namespace {

using Items = std::vector<TreeItem>;

Items scattered(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(-1, 1);
  Items items;
  for (std::uint32_t i = 0; i < count; ++i)
    items.push_back({{3 * place(random), place(random), place(random)}, i});
  return items;
}

Items inOnePlace(std::size_t count) {
  Items items;
  for (std::uint32_t i = 0; i < count; ++i) items.push_back({{1, 2, 3}, i});
  return items;
}

Tree treeOf(std::vector<Items>& objects, std::uint32_t itemsPerSurfel = 1) {
  const std::vector<std::span<TreeItem>> spans(objects.begin(), objects.end());
  return makeTree(spans, itemsPerSurfel);
}

struct Node {
  bool leaf;
  std::uint32_t firstSurfel;
  std::uint32_t surfels;
  std::uint32_t end;  // the node after all below
};

// By the description in tree.h only.
Node nodeOf(const Tree& tree, std::uint32_t index) {
  const std::uint32_t link = tree.links[index];
  EXPECT_NE(link & (1U << 29U), 0U) << index;
  if ((link >> 31U) != 0)
    return {true, link & ((1U << 26U) - 1), ((link >> 26U) & 7U) + 1, index + 1};
  return {false, 0, 0, link & ((1U << 29U) - 1)};
}

/// Goes through the tree depth first, like the sums over it.
class Walk {
 public:
  explicit Walk(const Tree& tree) : tree_(tree) {}

  std::uint32_t surfels() const { return nextSurfel_; }

  void enter(std::uint32_t index, std::uint32_t end, bool root) {
    const Node node = nodeOf(tree_, index);
    EXPECT_LE(node.end, end) << index;
    if (node.leaf) {
      EXPECT_EQ(node.firstSurfel, nextSurfel_) << index;
      EXPECT_LE(node.surfels, maxSurfelsOfLeaf);
      if (!root) {
        EXPECT_GE(node.surfels, 2U);
      }
      nextSurfel_ += node.surfels;
      return;
    }
    EXPECT_GT(node.end, index + 1) << index;
    std::uint32_t children = 0;
    for (std::uint32_t child = index + 1; child < node.end && !testing::Test::HasFailure();
         child = nodeOf(tree_, child).end) {
      enter(child, node.end, false);
      ++children;
    }
    EXPECT_GE(children, 2U) << index;
    EXPECT_LE(children, 4U) << index;
  }

 private:
  const Tree& tree_;
  std::uint32_t nextSurfel_ = 0;
};

void expectSound(std::vector<Items> objects, std::uint32_t itemsPerSurfel = 1) {
  const std::vector<Items> before = objects;
  const Tree tree = treeOf(objects, itemsPerSurfel);
  ASSERT_EQ(tree.rootOfObject.size(), objects.size() + 1);
  EXPECT_EQ(tree.rootOfObject.front(), 0U);
  EXPECT_EQ(tree.rootOfObject.back(), tree.links.size());
  Walk walk(tree);
  std::uint32_t surfels = 0;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    surfels += static_cast<std::uint32_t>(objects[i].size() / itemsPerSurfel);
    const std::uint32_t root = tree.rootOfObject[i];
    const std::uint32_t end = tree.rootOfObject[i + 1];
    EXPECT_EQ(root == end, objects[i].empty());
    if (root < end) {
      walk.enter(root, end, true);
      EXPECT_EQ(nodeOf(tree, root).end, end);
    }
    // The leaves of this object hold its surfels, each once, in their order.
    ASSERT_EQ(walk.surfels(), surfels);
    // And those are the object's items in another order.
    Items sorted = objects[i];
    std::sort(sorted.begin(), sorted.end(),
              [](const TreeItem& a, const TreeItem& b) { return a.index < b.index; });
    for (std::size_t k = 0; k < sorted.size(); ++k) {
      ASSERT_EQ(sorted[k].index, before[i][k].index);
      ASSERT_EQ(sorted[k].placeMm, before[i][k].placeMm);
    }
  }
}

TEST(Tree, HoldsEverySurfelOnceWhateverTheirNumber) {
  for (std::size_t count = 0; count < 300; ++count) {
    expectSound({scattered(count, 1)});
    expectSound({inOnePlace(count)});
    if (HasFailure()) FAIL() << count;
  }
  expectSound({scattered(100'000, 2)});
}

TEST(Tree, HoldsEverySurfelOfSeveralPieces) {
  for (const std::uint32_t itemsPerSurfel : {2U, 4U, 32U})
    for (std::size_t surfels = 0; surfels < 60; ++surfels) {
      expectSound({scattered(surfels * itemsPerSurfel, 3)}, itemsPerSurfel);
      if (HasFailure()) FAIL() << surfels << " of " << itemsPerSurfel;
    }
}

TEST(Tree, HoldsSeveralObjectsApart) {
  expectSound({{}, scattered(100, 1), {}, scattered(1, 2), scattered(9, 3), inOnePlace(77), {}});
  expectSound({{}, {}});
}

double diagonal(std::span<const TreeItem> items) {
  std::array<std::array<float, 2>, 3> range{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::minmax_element(
        items.begin(), items.end(),
        [axis](const TreeItem& a, const TreeItem& b) { return a.placeMm[axis] < b.placeMm[axis]; });
    range[axis] = {low->placeMm[axis], high->placeMm[axis]};
  }
  return std::hypot(static_cast<double>(range[0][1] - range[0][0]),
                    static_cast<double>(range[1][1] - range[1][0]),
                    static_cast<double>(range[2][1] - range[2][0]));
}

// On a grid of spacing 1, n² consecutive items would at best form a square of diagonal n √2.
TEST(Tree, NeighboursInItsOrderAreNeighboursInSpace) {
  constexpr std::uint32_t edge = 128;
  std::vector<Items> objects(1);
  for (std::uint32_t i = 0; i < edge * edge; ++i)
    objects[0].push_back({{static_cast<float>(i % edge), 0, static_cast<float>(i / edge)}, i});
  std::shuffle(objects[0].begin(), objects[0].end(), std::mt19937(7));
  treeOf(objects);
  for (const std::size_t wide : {2U, 4U, 8U, 16U}) {
    double sum = 0;
    const std::size_t count = wide * wide;
    for (std::size_t first = 0; first < objects[0].size(); first += count)
      sum += diagonal(std::span(objects[0]).subspan(first, count));
    const double mean = sum * static_cast<double>(count) / static_cast<double>(objects[0].size());
    EXPECT_LE(mean, static_cast<double>(wide) * std::sqrt(2.0)) << wide;
  }
}

TEST(Tree, PiecesOfASurfelLieTogether) {
  constexpr std::uint32_t edge = 64;
  constexpr std::uint32_t itemsPerSurfel = 16;
  std::vector<Items> objects(1);
  for (std::uint32_t i = 0; i < edge * edge; ++i)
    objects[0].push_back({{static_cast<float>(i % edge), static_cast<float>(i / edge), 0}, i});
  std::shuffle(objects[0].begin(), objects[0].end(), std::mt19937(8));
  treeOf(objects, itemsPerSurfel);
  for (std::size_t first = 0; first < objects[0].size(); first += itemsPerSurfel)
    EXPECT_LE(diagonal(std::span(objects[0]).subspan(first, itemsPerSurfel)), 3 * std::sqrt(2.0));
}

// Two runs with the items in different orders: the index decides between equal places.
TEST(Tree, IsAlwaysTheSame) {
  std::vector<Items> items{scattered(3000, 5), inOnePlace(500)};
  for (TreeItem& item : items[0])
    for (float& x : item.placeMm) x = std::round(4 * x);  // many in the same place
  std::vector<Items> shuffled = items;
  for (Items& list : shuffled) std::shuffle(list.begin(), list.end(), std::mt19937(9));
  std::vector<Items> again = items;
  const Tree tree = treeOf(items);
  const Tree same = treeOf(again);
  const Tree other = treeOf(shuffled);
  EXPECT_EQ(tree.links, same.links);
  EXPECT_EQ(tree.links, other.links);
  for (std::size_t i = 0; i < items.size(); ++i)
    for (std::size_t k = 0; k < items[i].size(); ++k)
      ASSERT_EQ(items[i][k].index, again[i][k].index);
  // The order of surfels within a leaf may differ, but not the set.
  for (std::uint32_t n = 0; n < tree.links.size(); ++n) {
    const Node node = nodeOf(tree, n);
    if (!node.leaf || node.firstSurfel + node.surfels > items[0].size()) continue;
    std::array<std::vector<std::uint32_t>, 2> held;
    for (std::uint32_t s = node.firstSurfel; s < node.firstSurfel + node.surfels; ++s) {
      held[0].push_back(items[0][s].index);
      held[1].push_back(shuffled[0][s].index);
    }
    for (std::vector<std::uint32_t>& list : held) std::sort(list.begin(), list.end());
    ASSERT_EQ(held[0], held[1]);
  }
}

}  // namespace
}  // namespace opaline::surfels
