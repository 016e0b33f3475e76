#include "surfels/treelets.h"

#include <algorithm>
#include <cstddef>

namespace opaline::surfels {

namespace {

// Calls `visit` with the children of a node.
template <typename Visit>
void forEachChild(const Tree& tree, std::uint32_t node, const Visit& visit) {
  const std::uint32_t end = linkOf(tree, node).end;
  for (std::uint32_t child = node + 1; child < end; child = linkOf(tree, child).end) visit(child);
}

class TreeletBuilder {
 public:
  TreeletBuilder(const Tree& tree, std::uint32_t maxNodes)
      : tree_(tree), maxNodes_(maxNodes), height_(nodeCount(), 0), left_(nodeCount(), 0) {
    for (std::uint32_t node = nodeCount(); node-- > 0;)
      forEachChild(tree_, node, [&](std::uint32_t child) {
        height_[node] = std::max(height_[node], height_[child] + 1);
      });
    for (std::uint32_t node = 0; node < nodeCount(); ++node) {
      if (!linkOf(tree_, node).leaf) continue;
      made_.leaves.push_back(node);
      left_[node] = isPlaced;
    }
  }

  Treelets finish() {
    made_.firstOfStage.push_back(0);
    while (made_.leaves.size() + made_.nodes.size() < nodeCount()) addStage();
    made_.firstOfLevel.push_back(static_cast<std::uint32_t>(made_.nodes.size()));
    made_.levelOfTreelet.push_back(static_cast<std::uint32_t>(made_.firstOfLevel.size()) - 1);
    return std::move(made_);
  }

 private:
  static constexpr std::uint32_t isPlaced = ~0U;

  std::uint32_t nodeCount() const { return static_cast<std::uint32_t>(tree_.links.size()); }

  // Counts the inner nodes of each subtree that are not placed yet. Below a placed node there are
  // none.
  void countLeft() {
    for (std::uint32_t node = nodeCount(); node-- > 0;) {
      if (left_[node] == isPlaced) continue;
      left_[node] = 1;
      forEachChild(tree_, node, [&](std::uint32_t child) {
        if (left_[child] != isPlaced) left_[node] += left_[child];
      });
    }
  }

  void addStage() {
    countLeft();
    std::vector<std::uint32_t> treelet;
    for (std::uint32_t node = 0; node < nodeCount();) {
      const std::uint32_t end = linkOf(tree_, node).end;
      if (left_[node] == isPlaced) {
        node = end;
      } else if (left_[node] > maxNodes_) {
        ++node;
      } else {
        if (treelet.size() + left_[node] > maxNodes_) addTreelet(treelet);
        for (; node < end; ++node)
          if (left_[node] != isPlaced) treelet.push_back(node);
      }
    }
    addTreelet(treelet);
    made_.firstOfStage.push_back(static_cast<std::uint32_t>(made_.levelOfTreelet.size()));
  }

  // Adds the nodes as a treelet and empties the list.
  void addTreelet(std::vector<std::uint32_t>& nodes) {
    std::stable_sort(nodes.begin(), nodes.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return height_[a] < height_[b]; });
    made_.levelOfTreelet.push_back(static_cast<std::uint32_t>(made_.firstOfLevel.size()));
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (i == 0 || height_[nodes[i]] > height_[nodes[i - 1]])
        made_.firstOfLevel.push_back(static_cast<std::uint32_t>(made_.nodes.size()));
      made_.nodes.push_back(nodes[i]);
      left_[nodes[i]] = isPlaced;
    }
    nodes.clear();
  }

  const Tree& tree_;
  std::uint32_t maxNodes_;
  std::vector<std::uint32_t> height_;
  std::vector<std::uint32_t> left_;
  Treelets made_;
};

}  // namespace

Treelets makeTreelets(const Tree& tree, std::uint32_t maxNodes) {
  return TreeletBuilder(tree, maxNodes).finish();
}

}  // namespace opaline::surfels
