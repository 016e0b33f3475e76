#pragma once

#include <cstddef>
#include <cstdint>

#include "gpu/transfer.h"
#include "passes/mechanics.h"
#include "surfels/treelets.h"

/// Trees whose nodes are fitted to the surface in every frame, in few dispatches.
namespace opaline::passes {

inline FittedTree makeFittedTree(gpu::Device& device, const surfels::Tree& tree) {
  constexpr VkBufferUsageFlags usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  const surfels::Treelets order = surfels::makeTreelets(tree);
  return {.links = gpu::makeBuffer(device, "links of a tree", tree.links, usage),
          .leafNodes = gpu::makeBuffer(device, "leaves of a tree", order.leaves, usage),
          .treeletNodes = gpu::makeBuffer(device, "nodes of treelets", order.nodes, usage),
          .firstOfLevel = gpu::makeBuffer(device, "levels of treelets", order.firstOfLevel, usage),
          .levelOfTreelet = gpu::makeBuffer(device, "treelets", order.levelOfTreelet, usage),
          .firstOfStage = order.firstOfStage,
          .leafCount = static_cast<std::uint32_t>(order.leaves.size()),
          .nodeCount = static_cast<std::uint32_t>(tree.links.size())};
}

/// The bindings of shaders with lib/treelets.glsl.
inline shaders::TreeletOrder treeletOrder(FittedTree& tree) {
  return {.links = tree.links,
          .treeletNodes = tree.treeletNodes,
          .firstOfLevel = tree.firstOfLevel,
          .levelOfTreelet = tree.levelOfTreelet};
}

/// Fits the inner nodes. For each stage it calls `bind(firstTreelet, treeletCount)`, which binds a
/// shader with lib/treelets.glsl, and dispatches that for `trees` trees of the same links.
template <typename Bind>
void fitInnerNodes(gpu::CommandList& commands, const FittedTree& tree, const Bind& bind,
                   std::uint32_t trees = 1) {
  for (std::size_t stage = 0; stage + 1 < tree.firstOfStage.size(); ++stage) {
    const std::uint32_t first = tree.firstOfStage[stage];
    const std::uint32_t count = tree.firstOfStage[stage + 1] - first;
    bind(first, count);
    commands.dispatchGroups(trees * count);
  }
}

}  // namespace opaline::passes
