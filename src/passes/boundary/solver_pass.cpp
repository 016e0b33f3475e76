#include "passes/boundary/solver_pass.h"

#include <algorithm>

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "shaders/shared/boundary.h"

namespace opaline::passes {

namespace {

constexpr std::uint32_t clustersOfGroup = 64;

}  // namespace

SolverPass::SolverPass(gpu::Device& device)
    : leaves_(device, "densities of leaves", {.ofLeaves = 1}),
      nodes_(device, "densities of nodes", {.ofLeaves = 0}),
      product_(device, "product"),
      dots_(device, "inner products"),
      step_(device, "step of the solver"),
      finish_(device, "solution") {}

Solver SolverPass::makeSolver(gpu::Device& device, const Clusters& clusters,
                              std::uint32_t solutions) {
  const std::size_t nodes = clusters.firstOfHeight.back();
  const std::size_t count = clusters.count;
  const std::size_t groups = (count + clustersOfGroup - 1) / clustersOfGroup;
  Solver solver;
  solver.densities = makeRoom<shared::DensityNode>(device, "densities", nodes);
  solver.products = makeRoom<shared::vec4>(device, "products", count);
  solver.basis =
      makeRoom<shared::vec4>(device, "basis of the solver", count * (shared::maxSolverSteps + 1));
  solver.sums =
      makeRoom<shared::vec4>(device, "sums of the solver", groups * (shared::maxSolverSteps + 1));
  solver.states = makeRoom<shared::SolverState>(device, "states of the solver", solutions);
  return solver;
}

void SolverPass::record(gpu::CommandList& commands, const Order& order, SceneTables& tables,
                        Clusters& clusters, Solver& solver) const {
  commands.beginPass("solve");
  commands.fill(clusters.fluences, 0);
  orthogonalise(commands, order, 0, clusters, clusters.sources, solver);
  for (std::uint32_t step = 1; step <= std::min(order.steps, shared::maxSolverSteps); ++step) {
    multiply(commands, order, step, tables, clusters, solver);
    orthogonalise(commands, order, step, clusters, solver.products, solver);
  }
  commands.bind(finish_,
                {.fluences = clusters.fluences, .basis = solver.basis, .states = solver.states},
                {.clusterCount = clusters.count, .solution = order.solution});
  commands.dispatchLinear(clusters.count);
  commands.endPass();
}

void SolverPass::orthogonalise(gpu::CommandList& commands, const Order& order, std::uint32_t step,
                               Clusters& clusters, gpu::Buffer& product, Solver& solver) const {
  commands.bind(dots_,
                {.clusters = clusters.clusters,
                 .products = product,
                 .basis = solver.basis,
                 .wanted = clusters.sources,
                 .sums = solver.sums,
                 .states = solver.states},
                {.clusterCount = clusters.count, .step = step, .solution = order.solution});
  commands.dispatchLinear(clusters.count);
  commands.bind(
      step_,
      {.products = product, .basis = solver.basis, .sums = solver.sums, .states = solver.states},
      {.clusterCount = clusters.count,
       .step = step,
       .tolerance = order.tolerance,
       .solution = order.solution});
  commands.dispatchLinear(clusters.count);
}

// The operator on the last vector of the basis.
void SolverPass::multiply(gpu::CommandList& commands, const Order& order, std::uint32_t step,
                          SceneTables& tables, Clusters& clusters, Solver& solver) const {
  const std::uint32_t firstFluence = (step - 1) * clusters.count;
  forEachHeight(clusters.firstOfHeight, [&](std::size_t height, const NodeRange& range) {
    commands.bind(height == 0 ? leaves_ : nodes_,
                  {.links = clusters.links,
                   .byHeight = clusters.byHeight,
                   .nodes = solver.densities,
                   .clusters = clusters.clusters,
                   .ranges = clusters.ranges,
                   .fluences = solver.basis,
                   .states = solver.states,
                   .objects = tables.objects,
                   .media = tables.media,
                   .shapes = clusters.nodes},
                  {.first = height == 0 ? firstFluence : range.first,
                   .count = range.count,
                   .step = step,
                   .solution = order.solution});
    commands.dispatchLinear(range.count);
  });
  commands.bind(product_,
                {.objects = tables.objects,
                 .media = tables.media,
                 .tiles = clusters.tiles,
                 .clusterTexels = clusters.clusters,
                 .clusterNodes = clusters.nodes,
                 .clusters = clusters.clusters,
                 .ranges = clusters.ranges,
                 .lists = clusters.lists,
                 .densities = solver.densities,
                 .fluences = solver.basis,
                 .products = solver.products,
                 .states = solver.states},
                {.tileCount = clusters.tileCount,
                 .openingAngle = order.openingAngle,
                 .first = firstFluence,
                 .step = step,
                 .solution = order.solution});
  commands.dispatchLinear(invocationsOfTiles(clusters), roundsOfWalk);
}

}  // namespace opaline::passes
