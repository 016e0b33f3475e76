// The nodes of the tree as the device computes them in every frame, against sums in double
// precision over everything below each.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "gpu/command_list.h"
#include "gpu/gpu_fixture.h"
#include "gpu/helpers.h"
#include "gpu/pipeline.h"
#include "gpu/transfer.h"
#include "passes/fitted_tree.h"
#include "passes/mechanics.h"
#include "renderer/shapes.h"
#include "shaders/gather/tree_leaves.comp.h"
#include "shaders/gather/tree_nodes.comp.h"
#include "shaders/shared/surfels.h"
#include "surfels/tree.h"

namespace opaline {
namespace {

using namespace test;
using shared::Source;
using shared::TreeNode;

constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;

/// Surfels with three sources each, in the order of their tree.
struct Lit {
  surfels::Tree tree;
  std::vector<Source> sources;
};

Vector placeOf(const Source& source) {
  return {static_cast<double>(source.positionArea.x), static_cast<double>(source.positionArea.y),
          static_cast<double>(source.positionArea.z)};
}

/// Surfels scattered over three unit cubes, each cube being one object. Sources lie within a
/// hundredth of their surfels, then move as `move` says.
template <typename FluxAt, typename Move>
Lit scattered(std::size_t surfelsOfObject, const FluxAt& fluxAt, const Move& move) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> unit(0, 1);
  std::vector<std::vector<surfels::TreeItem>> objects(3);
  for (std::size_t object = 0; object < objects.size(); ++object)
    for (std::uint32_t i = 0; i < surfelsOfObject; ++i)
      objects[object].push_back(
          {{unit(random) + 4 * static_cast<float>(object), unit(random), unit(random)}, i});
  const std::vector<std::span<surfels::TreeItem>> spans(objects.begin(), objects.end());
  Lit lit{surfels::makeTree(spans, 1), {}};
  for (const std::vector<surfels::TreeItem>& items : objects)
    for (const surfels::TreeItem& item : items)
      for (std::uint32_t k = 0; k < shared::sourcesPerSurfel; ++k) {
        Vector place = toVector(item.placeMm);
        for (double& x : place) x += 0.01 * static_cast<double>(unit(random));
        const Vec3 moved = toVec3(move(place));
        const Vec3 flux = fluxAt(moved);
        lit.sources.push_back({.positionArea = {moved[0], moved[1], moved[2], 1 + unit(random)},
                               .flux = {flux[0], flux[1], flux[2], 0}});
      }
  return lit;
}

class RefitTest : public gpu::GpuTest {
 protected:
  static std::vector<TreeNode> nodesOf(const Lit& lit) {
    const surfels::Tree& tree = lit.tree;
    passes::FittedTree fitted = passes::makeFittedTree(device(), tree);
    gpu::Buffer sources = gpu::makeBuffer(device(), "sources", lit.sources, passes::roomUsage);
    gpu::Buffer nodes =
        gpu::makeBuffer(device(), "nodes", std::vector<TreeNode>(tree.links.size()), storage);
    gpu::Buffer boxes = gpu::makeBuffer(device(), "boxes",
                                        std::vector<shared::NodeBox>(tree.links.size()), storage);
    const gpu::Compute<shaders::GatherTreeLeaves> leaves(device(), "leaves");
    const gpu::Compute<shaders::GatherTreeNodes> inner(device(), "nodes");
    gpu::CommandList commands(device(), "refit");
    commands.begin();
    commands.bind(leaves,
                  {.links = fitted.links,
                   .leafNodes = fitted.leafNodes,
                   .sources = sources,
                   .nodes = nodes,
                   .boxes = boxes},
                  {.leafCount = fitted.leafCount});
    commands.dispatchLinear(fitted.leafCount);
    passes::fitInnerNodes(commands, fitted, [&](std::uint32_t first, std::uint32_t count) {
      commands.bind(inner,
                    {.treeletOrder = passes::treeletOrder(fitted), .nodes = nodes, .boxes = boxes},
                    {.firstTreelet = first, .treeletCount = count});
    });
    commands.submit();
    return gpu::readAs<TreeNode>(device(), nodes);
  }

  static void expectSums(const Lit& lit);
};

Vector vectorOf(const glm::vec3& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

// The sources below a node.
std::span<const Source> sourcesBelow(const Lit& lit, std::uint32_t node) {
  const auto leafOf = [&](std::uint32_t index) {
    const std::uint32_t link = lit.tree.links[index];
    const std::uint32_t first = link & ((1U << surfels::Tree::countShift) - 1);
    return std::array{first, first + ((link >> surfels::Tree::countShift) & 7U) + 1};
  };
  const auto isLeaf = [&](std::uint32_t index) {
    return (lit.tree.links[index] & surfels::Tree::leafBit) != 0;
  };
  std::uint32_t last = node;
  if (!isLeaf(node)) last = (lit.tree.links[node] & (surfels::Tree::setBit - 1)) - 1;
  std::uint32_t first = node;
  while (!isLeaf(first)) ++first;
  const std::size_t from = std::size_t{leafOf(first)[0]} * shared::sourcesPerSurfel;
  const std::size_t to = std::size_t{leafOf(last)[1]} * shared::sourcesPerSurfel;
  return std::span(lit.sources).subspan(from, to - from);
}

struct Sums {
  Vector flux{};
  std::array<Vector, 3> centroids{};
  Vector middle{};  // weighted by all flux
  std::array<Vector, 3> moments{};
};

Sums sumsOf(std::span<const Source> sources) {
  Sums sums;
  const auto all = [](const Source& s) {
    return static_cast<double>(s.flux.x + s.flux.y + s.flux.z);
  };
  double total = 0;
  for (const Source& source : sources) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto flux = static_cast<double>(source.flux[static_cast<int>(c)]);
      sums.flux[c] += flux;
      sums.centroids[c] = sums.centroids[c] + flux * placeOf(source);
    }
    sums.middle = sums.middle + all(source) * placeOf(source);
    total += all(source);
  }
  sums.middle = (1 / total) * sums.middle;
  for (std::size_t c = 0; c < 3; ++c)
    sums.centroids[c] = sums.flux[c] > 0 ? (1 / sums.flux[c]) * sums.centroids[c] : sums.middle;
  for (const Source& source : sources) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Vector offset = placeOf(source) - sums.centroids[c];
      const double part = static_cast<double>(source.flux[static_cast<int>(c)]) / total;
      for (std::size_t i = 0; i < 3; ++i)
        sums.moments[i] = sums.moments[i] + (part * offset[i]) * offset;
    }
  }
  return sums;
}

void RefitTest::expectSums(const Lit& lit) {
  const std::vector<TreeNode> nodes = nodesOf(lit);
  for (std::uint32_t n = 0; n < nodes.size() && !HasFailure(); ++n) {
    const TreeNode& node = nodes[n];
    ASSERT_EQ(node.link, lit.tree.links[n]);
    const std::span<const Source> sources = sourcesBelow(lit, n);
    const std::array<Vector, 3> found{vectorOf(node.red), vectorOf(node.green),
                                      vectorOf(node.blue)};
    double furthest = 0;
    for (const Source& source : sources)
      for (const Vector& centroid : found)
        furthest = std::max(furthest, length(placeOf(source) - centroid));
    // Circles contain everything, and those around the children's circles are not much larger.
    ASSERT_GE(static_cast<double>(node.radius), furthest * (1 - 1e-5)) << n;
    ASSERT_LE(static_cast<double>(node.radius), 2.5 * furthest) << n;

    const Sums sums = sumsOf(sources);
    if (sums.flux == Vector{}) {
      for (int c = 0; c < 3; ++c) ASSERT_EQ(node.flux[c], 0) << n;
      continue;
    }
    const double size = std::max(furthest, 1e-3);
    for (std::size_t c = 0; c < 3; ++c) {
      ASSERT_NEAR(static_cast<double>(node.flux[static_cast<int>(c)]), sums.flux[c],
                  1e-5 * sums.flux[c])
          << n;
      ASSERT_LT(length(found[c] - sums.centroids[c]), 1e-4 * size + 1e-5) << n << ' ' << c;
    }
    const std::array<std::array<float, 3>, 3> moments{
        {{node.momentXx, node.moments.y, node.moments.z},
         {node.moments.y, node.momentYy, node.moments.w},
         {node.moments.z, node.moments.w, node.moments.x}}};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        ASSERT_NEAR(static_cast<double>(moments[i][k]), sums.moments[i][k], 1e-3 * size * size)
            << n << ' ' << i << k;
  }
}

const auto still = [](const Vector& place) { return place; };

TEST_F(RefitTest, NodesAreTheSumsOfWhatIsBelow) {
  for (const std::size_t count : {1U, 2U, 9U, 5000U})
    expectSums(scattered(
        count,
        [](const Vec3& p) {
          return Vec3{p[0] + 0.1F, 1 - 0.2F * p[1], 0.3F + p[2]};
        },
        still));
}

// Far from the rest pose the tree is the same, and its nodes are still right.
TEST_F(RefitTest, NodesFollowTheSurfaceFarFromItsRestPose) {
  expectSums(scattered(
      3000,
      [](const Vec3& p) {
        return Vec3{std::abs(p[0]), 1, p[2] > 0.5F ? 1.0F : 0.25F};
      },
      [](const Vector& p) {
        const double angle = 5 * p[1];
        return Vector{std::cos(angle) * p[0] - std::sin(angle) * p[2], 3 * p[1] * p[1],
                      std::sin(angle) * p[0] + std::cos(angle) * p[2]};
      }));
}

TEST_F(RefitTest, LightOfOneColourOrOnOneSideOnly) {
  expectSums(scattered(
      2000,
      [](const Vec3& p) {
        return Vec3{p[1] > 0.6F ? 2.0F : 0.0F, p[2] < 0.3F ? 1.0F : 0.0F, 0};
      },
      still));
}

TEST_F(RefitTest, DarknessIsNoNaN) {
  const Lit lit = scattered(
      500, [](const Vec3&) { return Vec3{}; }, still);
  expectSums(lit);
  for (const TreeNode& node : nodesOf(lit))
    for (const glm::vec3& centroid : {node.red, node.green, node.blue})
      for (int axis = 0; axis < 3; ++axis)
        EXPECT_TRUE(std::isfinite(centroid[axis]) && centroid[axis] >= 0 && centroid[axis] < 10);
}

}  // namespace
}  // namespace opaline
