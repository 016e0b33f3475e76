#include "passes/boundary/solver_pass.h"

#include <algorithm>

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "shaders/shared/boundary.h"

namespace opaline::passes {

namespace {

constexpr std::uint32_t groupSize = 64;

std::uint32_t groupsOf(std::uint32_t invocations) {
  return (invocations + groupSize - 1) / groupSize;
}

}  // namespace

SolverPass::SolverPass(gpu::Device& device)
    : densities_(device, "densities"),
      product_(device, "product"),
      dots_(device, "inner products"),
      step_(device, "step of the solver"),
      finish_(device, "solution") {}

Solver SolverPass::makeSolver(gpu::Device& device, const Clusters& clusters,
                              std::uint32_t solutions) {
  const std::size_t nodes = clusters.tree.nodeCount;
  const std::size_t count = clusters.count;
  const std::size_t groups = groupsOf(clusters.count);
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
  commands.bind(densities_,
                {.objects = tables.objects,
                 .media = tables.media,
                 .clusterNodes = clusters.nodes,
                 .innerNodes = clusters.inner,
                 .ranges = clusters.ranges,
                 .clusterTexels = clusters.clusters,
                 .fluences = solver.basis,
                 .nodes = solver.densities,
                 .states = solver.states},
                {.clusterCount = clusters.count,
                 .smallCount = clusters.smallInnerCount,
                 .innerCount = clusters.innerCount,
                 .first = firstFluence,
                 .step = step,
                 .solution = order.solution});
  const std::uint32_t alone = groupsOf(clusters.count + clusters.smallInnerCount);
  commands.dispatchLinear(groupSize * (alone + clusters.innerCount - clusters.smallInnerCount));
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
