// The order of fitting a tree's nodes: all of them, and none before its children.

#include "surfels/treelets.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

namespace opaline::surfels {
namespace {

Tree treeOf(const std::vector<std::uint32_t>& surfelsOfObjects) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> place(-1, 1);
  std::vector<std::vector<TreeItem>> objects;
  for (const std::uint32_t count : surfelsOfObjects) {
    objects.emplace_back();
    for (std::uint32_t i = 0; i < count; ++i)
      objects.back().push_back({{3 * place(random), place(random), place(random)}, i});
  }
  const std::vector<std::span<TreeItem>> spans(objects.begin(), objects.end());
  return makeTree(spans, 1);
}

// When a node is fitted, by the description in treelets.h.
struct Turn {
  std::uint32_t stage = 0;
  std::uint32_t treelet = 0;
  std::uint32_t level = 0;
  bool given = false;
  bool isLeaf = false;  // fitted first
};

std::vector<Turn> turnsOf(const Treelets& order, std::size_t nodes) {
  std::vector<Turn> turns(nodes);
  for (const std::uint32_t leaf : order.leaves) {
    EXPECT_FALSE(turns.at(leaf).given) << leaf;
    turns[leaf] = {.given = true, .isLeaf = true};
  }
  for (std::uint32_t stage = 0; stage + 1 < order.firstOfStage.size(); ++stage)
    for (std::uint32_t treelet = order.firstOfStage[stage]; treelet < order.firstOfStage[stage + 1];
         ++treelet)
      for (std::uint32_t level = order.levelOfTreelet[treelet];
           level < order.levelOfTreelet[treelet + 1]; ++level)
        for (std::uint32_t at = order.firstOfLevel[level]; at < order.firstOfLevel[level + 1];
             ++at) {
          Turn& turn = turns.at(order.nodes.at(at));
          EXPECT_FALSE(turn.given) << order.nodes[at];
          turn = {stage, treelet, level, true, false};
        }
  return turns;
}

bool isBefore(const Turn& a, const Turn& b) {
  if (a.isLeaf) return !b.isLeaf;
  if (a.stage != b.stage) return a.stage < b.stage;
  return a.treelet == b.treelet && a.level < b.level;
}

void expectOrder(const Tree& tree, const Treelets& order, std::uint32_t maxNodes) {
  ASSERT_EQ(order.leaves.size() + order.nodes.size(), tree.links.size());
  ASSERT_EQ(order.firstOfStage.back() + 1, order.levelOfTreelet.size());
  for (std::size_t t = 0; t + 1 < order.levelOfTreelet.size(); ++t)
    EXPECT_LE(order.firstOfLevel[order.levelOfTreelet[t + 1]] -
                  order.firstOfLevel[order.levelOfTreelet[t]],
              maxNodes);
  const std::vector<Turn> turns = turnsOf(order, tree.links.size());
  for (std::uint32_t node = 0; node < tree.links.size(); ++node) {
    ASSERT_TRUE(turns[node].given) << node;
    const NodeLink link = linkOf(tree, node);
    ASSERT_EQ(turns[node].isLeaf, link.leaf);
    for (std::uint32_t child = node + 1; child < link.end; child = linkOf(tree, child).end)
      ASSERT_TRUE(isBefore(turns[child], turns[node])) << child << " below " << node;
  }
}

TEST(Treelets, FitChildrenBeforeTheirParents) {
  const std::vector<std::vector<std::uint32_t>> scenes{
      {1}, {5}, {2000}, {100'000}, {700, 0, 1, 30'000}, std::vector<std::uint32_t>(300, 3)};
  for (const std::vector<std::uint32_t>& scene : scenes)
    for (const std::uint32_t maxNodes : {1U, 7U, maxNodesOfTreelet}) {
      const Tree tree = treeOf(scene);
      expectOrder(tree, makeTreelets(tree, maxNodes), maxNodes);
    }
}

TEST(Treelets, NeedFewStages) {
  const Tree tree = treeOf({300'000});
  EXPECT_LE(makeTreelets(tree).firstOfStage.size(), 3U + 1U);
}

TEST(Treelets, OfNothingAreNone) {
  const Treelets order = makeTreelets(treeOf({0}));
  EXPECT_TRUE(order.nodes.empty());
  EXPECT_EQ(order.firstOfStage.size(), 1U);
}

}  // namespace
}  // namespace opaline::surfels
