#include "passes/boundary/solver_pass.h"

#include <algorithm>

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "shaders/shaders.h"
#include "shaders/shared/boundary.h"

namespace opaline::passes {

namespace {

using gpu::Binding;

constexpr std::uint32_t clustersOfGroup = 64;

struct DensityRange {
  std::uint32_t first;
  std::uint32_t count;
  std::uint32_t step;
  std::uint32_t solution;
};

struct ProductRange {
  std::uint32_t clusters;
  float openingAngle;
  std::uint32_t first;
  std::uint32_t step;
  std::uint32_t solution;
};

struct FinishRange {
  std::uint32_t clusters;
  std::uint32_t solution;
};

struct DotRange {
  std::uint32_t clusters;
  std::uint32_t step;
  std::uint32_t solution;
};

struct Step {
  std::uint32_t clusters;
  std::uint32_t step;
  float tolerance;
  std::uint32_t solution;
};

gpu::Pipeline makeDensities(gpu::Device& device, bool leaves) {
  return {device,
          gpu::ComputePipelineOptions{.name = leaves ? "densities of leaves" : "densities of nodes",
                                      .shader = shaders::boundary_densities_comp,
                                      .bindings = slots(10),
                                      .pushConstantBytes = sizeof(DensityRange),
                                      .specialization = {leaves ? 1U : 0U}}};
}

}  // namespace

SolverPass::SolverPass(gpu::Device& device)
    : leaves_(makeDensities(device, true)),
      nodes_(makeDensities(device, false)),
      product_(device, gpu::ComputePipelineOptions{.name = "product",
                                                   .shader = shaders::boundary_product_comp,
                                                   .bindings = slots(9, {4, 5}),
                                                   .pushConstantBytes = sizeof(ProductRange)}),
      dots_(device, gpu::ComputePipelineOptions{.name = "inner products",
                                                .shader = shaders::boundary_solver_dots_comp,
                                                .bindings = slots(6),
                                                .pushConstantBytes = sizeof(DotRange)}),
      step_(device, gpu::ComputePipelineOptions{.name = "step of the solver",
                                                .shader = shaders::boundary_solver_step_comp,
                                                .bindings = slots(4),
                                                .pushConstantBytes = sizeof(Step)}),
      finish_(device, gpu::ComputePipelineOptions{.name = "solution",
                                                  .shader = shaders::boundary_solver_finish_comp,
                                                  .bindings = slots(3),
                                                  .pushConstantBytes = sizeof(FinishRange)}) {}

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
  commands.bind(finish_);
  commands.bindResources({Binding::write(0, clusters.fluences), Binding::read(1, solver.basis),
                          Binding::read(2, solver.states)});
  commands.pushConstants(FinishRange{clusters.count, order.solution});
  commands.dispatchLinear(clusters.count);
  commands.endPass();
}

void SolverPass::orthogonalise(gpu::CommandList& commands, const Order& order, std::uint32_t step,
                               Clusters& clusters, gpu::Buffer& product, Solver& solver) const {
  commands.bind(dots_);
  commands.bindResources({Binding::read(0, clusters.clusters), Binding::read(1, product),
                          Binding::read(2, solver.basis), Binding::read(3, clusters.sources),
                          Binding::write(4, solver.sums), Binding::read(5, solver.states)});
  commands.pushConstants(DotRange{clusters.count, step, order.solution});
  commands.dispatchLinear(clusters.count);
  commands.bind(step_);
  commands.bindResources({Binding::read(0, product), Binding::write(1, solver.basis),
                          Binding::read(2, solver.sums), Binding::write(3, solver.states)});
  commands.pushConstants(Step{clusters.count, step, order.tolerance, order.solution});
  commands.dispatchLinear(clusters.count);
}

// The operator on the last vector of the basis.
void SolverPass::multiply(gpu::CommandList& commands, const Order& order, std::uint32_t step,
                          SceneTables& tables, Clusters& clusters, Solver& solver) const {
  const std::uint32_t firstFluence = (step - 1) * clusters.count;
  forEachHeight(clusters.firstOfHeight, [&](std::size_t height, const NodeRange& range) {
    commands.bind(height == 0 ? leaves_ : nodes_);
    commands.bindResources({Binding::read(0, clusters.links), Binding::read(1, clusters.byHeight),
                            Binding::write(2, solver.densities),
                            Binding::read(3, clusters.clusters), Binding::read(4, clusters.ranges),
                            Binding::read(5, solver.basis), Binding::read(6, solver.states),
                            Binding::read(7, tables.objects), Binding::read(8, tables.media),
                            Binding::read(9, clusters.nodes)});
    commands.pushConstants(
        DensityRange{height == 0 ? firstFluence : range.first, range.count, step, order.solution});
    commands.dispatchLinear(range.count);
  });
  commands.bind(product_);
  commands.bindResources({Binding::read(0, tables.objects), Binding::read(1, tables.media),
                          Binding::read(2, clusters.ranges), Binding::read(3, clusters.clusters),
                          Binding::texels(4, clusters.nodes), Binding::texels(5, solver.densities),
                          Binding::read(6, solver.basis), Binding::write(7, solver.products),
                          Binding::read(8, solver.states)});
  commands.pushConstants(
      ProductRange{clusters.count, order.openingAngle, firstFluence, step, order.solution});
  commands.dispatchLinear(clusters.count);
}

}  // namespace opaline::passes
