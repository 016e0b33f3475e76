#include "passes/boundary/solver_pass.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "gpu/device.h"
#include "gpu/transfer.h"
#include "passes/mechanics.h"
#include "shaders/shared/boundary.h"

namespace opaline::passes {

namespace {

std::uint32_t densityGroups(const Clusters& clusters) {
  return shared::groupsOfNodes(clusters.count + clusters.smallInnerCount) + clusters.innerCount -
         clusters.smallInnerCount;
}

// The offset of a member of the solution's state among all states.
std::size_t inState(const SolverPass::Order& order, std::size_t member) {
  return order.solution * sizeof(shared::SolverState) + member;
}

// Nodes per tile whose coefficients are kept. On the marble bunny, 700 nodes act on a tile on
// average and at most 1120.
std::uint32_t roomOfCoefficients(const gpu::Device& device, const Clusters& clusters) {
  constexpr std::size_t mostBytesOfAll = std::size_t{64} << 20U;
  const std::size_t texels =
      std::min(mostBytesOfAll, mostBytes(device.limits())) / sizeof(shared::vec4);
  const std::size_t tiles = std::max(clusters.tileCount, 1U);
  const std::size_t nodes = texels / (shared::texelsOfActions * tiles);
  return static_cast<std::uint32_t>(std::min<std::size_t>(nodes, clusters.roomOfList - 1));
}

bool entersAtSurface(const SolverPass::Order& order, const SceneTables& tables) {
  return order.isDiffuse && tables.entersAtSurface;
}

}  // namespace

SolverPass::SolverPass(gpu::Device& device)
    : coefficients_{{device, "coefficients", {.withSeveralMedia = 0}},
                    {device, "coefficients", {.withSeveralMedia = 1}}},
      plain_(makePipelines(device, false)),
      painted_(makePipelines(device, true)),
      powerOfLastButOne_(device, "power of a bounce", {.ofLast = 0, .withPaint = 0}),
      furtherBounces_{{device, "further bounces", {.ofLast = 1, .withPaint = 0}},
                      {device, "further bounces", {.ofLast = 1, .withPaint = 1}}} {}

SolverPass::Pipelines SolverPass::makePipelines(gpu::Device& device, bool withPaint) {
  return {{{device, "densities", {.withPaint = withPaint, .withLinings = 0}},
           {device, "densities", {.withPaint = withPaint, .withLinings = 1}}},
          {{device, "product", {.withPaint = withPaint, .withLinings = 0, .withSeveralMedia = 0}},
           {device, "product", {.withPaint = withPaint, .withLinings = 1, .withSeveralMedia = 0}}},
          {device, "product", {.withPaint = withPaint, .withLinings = 1, .withSeveralMedia = 1}},
          {device, "exitance of clusters", {.withPaint = withPaint}}};
}

Solver SolverPass::makeSolver(gpu::Device& device, const Clusters& clusters,
                              std::uint32_t solutions) {
  // When densities are found, the basis has at most that many vectors.
  const std::size_t nodes = std::size_t{clusters.tree.nodeCount} * shared::maxSolverSteps;
  const std::size_t count = clusters.count;
  Solver solver;
  solver.densities = makeRoom<shared::DensityNode>(device, "densities", nodes);
  solver.products = makeRoom<shared::vec4>(device, "products", count);
  solver.basis =
      makeRoom<shared::vec4>(device, "basis of the solver", count * (shared::maxSolverSteps + 1));
  solver.sums = makeRoom<shared::vec4>(
      device, "sums of the solver", std::size_t{clusters.tileCount} * (shared::maxSolverSteps + 1));
  // Each step resets the count of tiles, which has to start at 0.
  solver.states =
      gpu::makeBuffer(device, "states of the solver",
                      std::vector<shared::SolverState>(solutions, shared::SolverState{}),
                      roomUsage | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT);
  return solver;
}

void SolverPass::makeCoefficients(gpu::Device& device, const Clusters& clusters, Solver& solver) {
  solver.roomOfCoefficients = roomOfCoefficients(device, clusters);
  const std::size_t nodes = std::size_t{clusters.tileCount} * solver.roomOfCoefficients;
  solver.coefficients =
      makeRoom<shared::vec4>(device, "coefficients of the solver", nodes * shared::texelsOfActions);
}

void SolverPass::recordCoefficients(gpu::CommandList& commands, float openingAngle,
                                    SceneTables& tables, Clusters& clusters, Solver& solver) const {
  commands.beginPass("coefficients");
  commands.bind(coefficients_.of(clusters.haveSeveralMedia),
                {.objects = tables.objects,
                 .media = tables.media,
                 .tiles = clusters.tiles,
                 .clusterTexels = clusters.clusters,
                 .clusterNodes = clusters.nodes,
                 .objectOfNode = clusters.objectOfNode,
                 .lists = clusters.lists,
                 .coefficients = solver.coefficients},
                {.tileCount = clusters.tileCount,
                 .openingAngle = openingAngle,
                 .roomOfList = clusters.roomOfList,
                 .roomOfCoefficients = solver.roomOfCoefficients});
  commands.dispatchGroups(clusters.tileCount, roundsOfWalk);
  commands.endPass();
}

void SolverPass::record(gpu::CommandList& commands, const Order& order, SceneTables& tables,
                        Clusters& clusters, Solver& solver) const {
  commands.beginPass("solve");
  if (entersAtSurface(order, tables))
    findDensities(commands, order, Of::Entered, tables, clusters, solver);
  multiply(commands, order, 0, tables, clusters, solver);
  // There are no more directions than clusters; one more step may reduce rounding errors.
  const std::uint32_t steps = std::min({order.steps, shared::maxSolverSteps, clusters.count + 1});
  for (std::uint32_t step = 1; step <= steps; ++step) {
    findDensities(commands, order, Of::Basis, tables, clusters, solver);
    multiply(commands, order, step, tables, clusters, solver);
  }
  commands.bind(pipelines(tables).exitance,
                {.objects = tables.objects,
                 .media = tables.media,
                 .ranges = clusters.ranges,
                 .basis = solver.basis,
                 .states = solver.states,
                 .latest = clusters.latest,
                 .exitances = clusters.exitances,
                 .clusters = clusters.clusters,
                 .entered = clusters.entered,
                 .enteredBefore = clusters.enteredBefore,
                 .clusterPaints = tables.paint.clusters,
                 .bareLights = clusters.bareLights,
                 .entries = clusters.entries,
                 .nearby = clusters.nearby,
                 .enteredInAll = clusters.enteredInAll,
                 .peaks = clusters.peaks},
                {.clusterCount = clusters.count,
                 .solution = order.solution,
                 .adds = order.adds,
                 .isDiffuse = order.isDiffuse,
                 .atSurface = entersAtSurface(order, tables),
                 .scattersOnce = tables.followsLight,
                 .lights = order.adds ? 0 : clusters.lights});
  commands.dispatchLinear(clusters.count);
  commands.endPass();
}

void SolverPass::recordFurtherBounces(gpu::CommandList& commands, Bounce bounce,
                                      SceneTables& tables, Clusters& clusters) const {
  commands.beginPass("solve");
  commands.bind(bounce == Bounce::Last ? furtherBounces_.of(tables.paint.any) : powerOfLastButOne_,
                {.clusters = clusters.clusters,
                 .latest = clusters.latest,
                 .entered = clusters.entered,
                 .powerBefore = clusters.power,
                 .exitances = clusters.exitances,
                 .bareLights = clusters.bareLights,
                 .peaks = clusters.peaks},
                {.clusterCount = clusters.count});
  commands.dispatchLinear(groupSize);
  commands.endPass();
}

// Finds the densities of the vector that the last product adds to the basis, or of diffuse light at
// the surface.
void SolverPass::findDensities(gpu::CommandList& commands, const Order& order, Of of,
                               SceneTables& tables, Clusters& clusters, Solver& solver) const {
  commands.bind(pipelines(tables).densities.of(clusters.haveLinings),
                {.objects = tables.objects,
                 .media = tables.media,
                 .clusterNodes = clusters.nodes,
                 .innerNodes = clusters.inner,
                 .ranges = clusters.ranges,
                 .clusterTexels = clusters.clusters,
                 .products = solver.products,
                 .basis = solver.basis,
                 .nodes = solver.densities,
                 .states = solver.states,
                 .entered = clusters.entered,
                 .clusterPaints = tables.paint.clusters,
                 .opaqueShares = tables.opaqueShares},
                {.clusterCount = clusters.count,
                 .smallCount = clusters.smallInnerCount,
                 .innerCount = clusters.innerCount,
                 .nodeCount = clusters.tree.nodeCount,
                 .solution = order.solution,
                 .ofEntered = of == Of::Entered});
  if (of == Of::Entered) {
    commands.dispatchGroups(densityGroups(clusters));
  } else {
    commands.use(solver.states, gpu::Access::Indirect);
    commands.dispatchIndirect(solver.states,
                              inState(order, offsetof(shared::SolverState, groupsOfDensities)));
  }
}

// Applies the operator to the last vector of the basis, or in step 0 makes the right-hand side,
// then updates the solution's state.
void SolverPass::multiply(gpu::CommandList& commands, const Order& order, std::uint32_t step,
                          SceneTables& tables, Clusters& clusters, Solver& solver) const {
  const bool atSurface = step == 0 && entersAtSurface(order, tables);
  const Pipelines& all = pipelines(tables);
  commands.bind(
      clusters.haveSeveralMedia ? all.productOfSeveralMedia : all.product.of(clusters.haveLinings),
      {.objects = tables.objects,
       .media = tables.media,
       .tiles = clusters.tiles,
       .clusterTexels = clusters.clusters,
       .clusterNodes = clusters.nodes,
       .clusters = clusters.clusters,
       .ranges = clusters.ranges,
       .lists = clusters.lists,
       .densities = solver.densities,
       .sources = clusters.sources,
       .basis = solver.basis,
       .products = solver.products,
       .sums = solver.sums,
       .states = gpu::WriteIndirect(solver.states),
       .entered = clusters.entered,
       .clusterPaints = tables.paint.clusters,
       .opaqueShares = tables.opaqueShares,
       .objectOfNode = clusters.objectOfNode,
       .coefficients = solver.coefficients},
      {.tileCount = clusters.tileCount,
       .clusterCount = clusters.count,
       .openingAngle = order.openingAngle,
       .tolerance = order.tolerance,
       .step = step,
       .solution = order.solution,
       .atSurface = atSurface,
       .nodeCount = clusters.tree.nodeCount,
       .densityGroups = densityGroups(clusters),
       .roomOfList = clusters.roomOfList,
       .roomOfCoefficients = order.keepsCoefficients ? solver.roomOfCoefficients : 0});
  if (step > 0)
    commands.dispatchIndirect(solver.states,
                              inState(order, offsetof(shared::SolverState, groupsOfProduct)));
  else
    commands.dispatchGroups(clusters.tileCount, atSurface ? roundsOfWalk : 1);
}

}  // namespace opaline::passes
