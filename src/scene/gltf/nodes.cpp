#include "scene/gltf/nodes.h"

#include <fmt/format.h>

#include <algorithm>

namespace opaline::scene {

namespace {

Matrix4 localMatrix(const Input& input, const tinygltf::Node& node, std::size_t index) {
  const auto sized = [&](const std::vector<double>& values, std::size_t size) {
    if (!values.empty() && values.size() != size) {
      failGltf(input, fmt::format("the transform of node {} has {} numbers where {} are needed",
                                  index, values.size(), size));
    }
    return !values.empty();
  };
  if (sized(node.matrix, 16)) return matrixFromColumns(node.matrix);
  Double3 translation{0, 0, 0};
  std::array<double, 4> rotation{0, 0, 0, 1};
  Double3 scale{1, 1, 1};
  if (sized(node.translation, 3)) std::copy_n(node.translation.begin(), 3, translation.begin());
  if (sized(node.rotation, 4)) std::copy_n(node.rotation.begin(), 4, rotation.begin());
  if (sized(node.scale, 3)) std::copy_n(node.scale.begin(), 3, scale.begin());
  return matrixFromParts(translation, rotation, scale);
}

std::vector<int> parentsOf(const Input& input, const tinygltf::Model& model) {
  std::vector<int> parents(model.nodes.size(), -1);
  for (std::size_t n = 0; n < model.nodes.size(); ++n) {
    for (const int child : model.nodes[n].children) {
      if (child < 0 || static_cast<std::size_t>(child) >= model.nodes.size()) {
        failGltf(input, fmt::format("node {} has child {}, which does not exist", n, child));
      }
      int& parent = parents[static_cast<std::size_t>(child)];
      if (parent != -1) failGltf(input, fmt::format("node {} has two parents", child));
      parent = static_cast<int>(n);
    }
  }
  return parents;
}

/// Appends the nodes below those in `order`, parents first.
void appendSubtrees(const tinygltf::Model& model, std::vector<int>& order) {
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::vector<int>& children = model.nodes[static_cast<std::size_t>(order[i])].children;
    order.insert(order.end(), children.begin(), children.end());
  }
}

std::vector<int> rootsOfScene(const Input& input, const tinygltf::Model& model,
                              const std::vector<int>& allRoots) {
  if (model.scenes.empty()) return allRoots;
  const int chosen = std::max(model.defaultScene, 0);
  if (static_cast<std::size_t>(chosen) >= model.scenes.size()) {
    failGltf(input, fmt::format("its default scene {} does not exist", chosen));
  }
  std::vector<int> roots = model.scenes[static_cast<std::size_t>(chosen)].nodes;
  for (const int root : roots) {
    if (root < 0 || static_cast<std::size_t>(root) >= model.nodes.size()) {
      failGltf(input, fmt::format("its scene names node {}, which does not exist", root));
    }
  }
  return roots;
}

}  // namespace

GltfNodes resolveNodes(const Input& input, const tinygltf::Model& model) {
  GltfNodes nodes;
  nodes.parents = parentsOf(input, model);
  const std::vector<int>& parents = nodes.parents;
  std::vector<int> allRoots;
  for (std::size_t n = 0; n < parents.size(); ++n) {
    if (parents[n] == -1) allRoots.push_back(static_cast<int>(n));
  }
  nodes.order = allRoots;
  std::vector<int>& order = nodes.order;
  appendSubtrees(model, order);
  // Every node has at most one parent, so what no root reaches is on or below a cycle.
  if (order.size() != model.nodes.size()) failGltf(input, "its nodes form a cycle");

  nodes.world.resize(model.nodes.size());
  for (const int n : order) {
    const auto index = static_cast<std::size_t>(n);
    const Matrix4 local = localMatrix(input, model.nodes[index], index);
    const int parent = parents[index];
    nodes.world[index] = parent < 0 ? local : nodes.world[static_cast<std::size_t>(parent)] * local;
  }
  // A scene may list both a node and its ancestor; each node is drawn once.
  std::vector<bool> inScene(model.nodes.size());
  for (const int root : rootsOfScene(input, model, allRoots)) {
    inScene[static_cast<std::size_t>(root)] = true;
  }
  for (const int n : order) {
    const auto index = static_cast<std::size_t>(n);
    const int parent = parents[index];
    if (parent >= 0 && inScene[static_cast<std::size_t>(parent)]) inScene[index] = true;
    if (inScene[index]) nodes.drawn.push_back(n);
  }
  return nodes;
}

}  // namespace opaline::scene
