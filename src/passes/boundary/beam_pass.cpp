#include "passes/boundary/beam_pass.h"

#include <cstddef>

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "shaders/shaders.h"
#include "shaders/shared/boundary.h"

namespace opaline::passes {

namespace {

using gpu::Binding;
using gpu::BindingType;

struct BeamChoice {
  std::uint32_t clusters;
  std::uint32_t beam;
  std::uint32_t piecesPerSurfel;
  std::uint32_t surfelNodes;
  std::uint32_t mirrors;
};

struct PointNodes {
  NodeRange range;
  std::uint32_t scattersOnce;
};

struct Sum {
  std::uint32_t clusters;
  float openingAngle;
  std::uint32_t adds;
  std::uint32_t firstNode;
  std::uint32_t endNode;
};

// Mesa's software device ends the loops of an invocation after 65,535 rounds in all, without a
// word. As many nodes as have fewer points, and no dispatch is long.
constexpr std::uint32_t nodesPerDispatch = 65535 / (shared::maxPoints + 5);

struct ExitanceConstants {
  std::uint32_t clusters;
  std::uint32_t adds;
};

struct ReentryCounts {
  std::uint32_t clusters;
  std::uint32_t raysOutwards;
  std::uint32_t isFirst;
};

gpu::Pipeline makeNodes(gpu::Device& device, bool leaves) {
  return {device,
          gpu::ComputePipelineOptions{.name = leaves ? "leaves of points" : "nodes of points",
                                      .shader = shaders::boundary_beam_nodes_comp,
                                      .bindings = slots(9, {2}),
                                      .pushConstantBytes = sizeof(PointNodes),
                                      .specialization = {leaves ? 1U : 0U}}};
}

gpu::Pipeline makeMirrored(gpu::Device& device, bool addsUp) {
  return {device, gpu::ComputePipelineOptions{.name = "mirrored light",
                                              .shader = shaders::boundary_mirrored_comp,
                                              .bindings = slots(4),
                                              .pushConstantBytes = sizeof(std::uint32_t),
                                              .specialization = {addsUp ? 1U : 0U}}};
}

gpu::Pipeline makeSum(gpu::Device& device, const char* name, gpu::Spirv shader) {
  return {device, gpu::ComputePipelineOptions{.name = name,
                                              .shader = shader,
                                              .bindings = slots(8, {2, 4}),
                                              .pushConstantBytes = sizeof(Sum)}};
}

}  // namespace

BeamPass::BeamPass(gpu::Device& device)
    : trace_(device,
             gpu::ComputePipelineOptions{
                 .name = "points of light",
                 .shader = device.hasRayQueries() ? shaders::boundary_beams_ray_queries_comp
                                                  : shaders::boundary_beams_comp,
                 .bindings = {{0, BindingType::UniformBuffer},
                              {1, BindingType::StorageBuffer},
                              {2, BindingType::StorageBuffer},
                              {3, BindingType::TexelBuffer},
                              raysSlot(device, 4),
                              {5, BindingType::StorageBuffer},
                              {6, BindingType::StorageBuffer},
                              {7, BindingType::StorageBuffer},
                              {8, BindingType::StorageBuffer},
                              {9, BindingType::StorageBuffer},
                              {10, BindingType::StorageBuffer},
                              {11, BindingType::StorageBuffer},
                              {12, BindingType::StorageBuffer}},
                 .pushConstantBytes = sizeof(BeamChoice),
             }),
      addMirrored_(makeMirrored(device, true)),
      takeMirrored_(makeMirrored(device, false)),
      leaves_(makeNodes(device, true)),
      nodes_(makeNodes(device, false)),
      source_(makeSum(device, "sources of fluence", shaders::boundary_source_comp)),
      single_(makeSum(device, "light that scatters once", shaders::boundary_single_comp)),
      reentry_(device, gpu::ComputePipelineOptions{.name = "light that enters again",
                                                   .shader = shaders::boundary_reentry_comp,
                                                   .bindings = slots(5),
                                                   .pushConstantBytes = sizeof(ReentryCounts)}),
      exitance_(device,
                gpu::ComputePipelineOptions{.name = "exitance of clusters",
                                            .shader = shaders::boundary_exitance_comp,
                                            .bindings = slots(6),
                                            .pushConstantBytes = sizeof(ExitanceConstants)}) {}

void BeamPass::recordLights(gpu::CommandList& commands, const Inputs& inputs, const Wanted& wanted,
                            Clusters& clusters) const {
  if (wanted.bounces) {
    commands.fill(clusters.sums, 0);
    commands.fill(clusters.arrived, 0);
  }
  for (std::uint32_t light = 0; light < clusters.lights; ++light) {
    commands.beginPass("rays");
    if (wanted.bounces) commands.fill(clusters.peak, 0);
    trace(commands, inputs, {light, wanted.bounces}, clusters, clusters.fromLight);
    if (wanted.bounces) bringMirrored(commands, clusters);
    commands.endPass();
    commands.beginPass("sources");
    spread(commands, inputs, clusters, clusters.fromLight, light > 0);
    commands.endPass();
  }
  if (wanted.sky || wanted.bounces) {
    commands.beginPass("rays");
    trace(commands, inputs, {clusters.lights, false}, clusters, clusters.fromEverywhere);
    commands.endPass();
  }
  if (!wanted.sky && clusters.lights > 0) return;
  commands.beginPass("sources");
  if (wanted.sky) {
    spread(commands, inputs, clusters, clusters.fromEverywhere, clusters.lights > 0);
  } else {
    commands.fill(clusters.sources, 0);
    commands.fill(clusters.latest, 0);
  }
  commands.endPass();
}

void BeamPass::recordReentry(gpu::CommandList& commands, const Inputs& inputs, Clusters& clusters,
                             bool isFirst) const {
  commands.beginPass("sources");
  commands.bind(reentry_);
  commands.bindResources({Binding::read(0, clusters.clusters), Binding::read(1, clusters.meetings),
                          Binding::read(2, clusters.latest),
                          Binding::write(3, clusters.fromEverywhere.strengths),
                          Binding::read(4, clusters.arrived)});
  commands.pushConstants(ReentryCounts{clusters.count, clusters.raysOutwards, isFirst ? 1U : 0U});
  commands.dispatchLinear(clusters.count);
  spread(commands, inputs, clusters, clusters.fromEverywhere, false);
  commands.endPass();
}

void BeamPass::recordExitance(gpu::CommandList& commands, SceneTables& tables, Clusters& clusters,
                              bool adds) const {
  commands.beginPass("solve");
  commands.bind(exitance_);
  commands.bindResources({Binding::read(0, tables.objects), Binding::read(1, tables.media),
                          Binding::read(2, clusters.ranges), Binding::read(3, clusters.fluences),
                          Binding::write(4, clusters.latest),
                          Binding::write(5, clusters.exitances)});
  commands.pushConstants(ExitanceConstants{clusters.count, adds ? 1U : 0U});
  commands.dispatchLinear(clusters.count);
  commands.endPass();
}

void BeamPass::trace(gpu::CommandList& commands, const Inputs& inputs, const Beam& beam,
                     Clusters& clusters, Beams& beams) const {
  commands.bind(trace_);
  commands.bindResources(
      {Binding::uniform(0, inputs.frame.data), Binding::read(1, inputs.tables.objects),
       Binding::read(2, inputs.tables.media), Binding::texels(3, inputs.rays.corners),
       rays(4, inputs.rays), Binding::read(5, clusters.ranges), Binding::read(6, clusters.clusters),
       Binding::read(7, clusters.entries), Binding::write(8, beams.points),
       Binding::write(9, beams.strengths), Binding::read(10, clusters.clusterOfSurfel),
       Binding::write(11, clusters.mirrored), Binding::write(12, clusters.peak)});
  commands.pushConstants(BeamChoice{clusters.count, beam.index, inputs.surfels.piecesPerSurfel,
                                    clusters.surfelNodes, beam.mirrors ? 1U : 0U});
  commands.dispatchLinear(clusters.count);
}

void BeamPass::bringMirrored(gpu::CommandList& commands, Clusters& clusters) const {
  for (const gpu::Pipeline* pipeline : {&addMirrored_, &takeMirrored_}) {
    commands.bind(*pipeline);
    commands.bindResources({Binding::read(0, clusters.mirrored), Binding::read(1, clusters.peak),
                            Binding::write(2, clusters.sums), Binding::write(3, clusters.arrived)});
    commands.pushConstants(clusters.count);
    commands.dispatchLinear(clusters.count);
  }
}

void BeamPass::spread(gpu::CommandList& commands, const Inputs& inputs, Clusters& clusters,
                      Beams& beams, bool adds) const {
  SceneTables& tables = inputs.tables;
  for (const bool scattersOnce : {false, true}) {
    if (scattersOnce && !tables.followsLight) {
      if (!adds) commands.fill(clusters.latest, 0);
      return;
    }
    fitNodes(commands, tables, clusters, beams, scattersOnce);
    commands.bind(scattersOnce ? single_ : source_);
    const std::uint32_t nodes = clusters.firstOfHeight.back();
    for (std::uint32_t from = 0; from < nodes; from += nodesPerDispatch) {
      // Bound each time, so that each adds to what the one before has written.
      commands.bindResources(
          {Binding::read(0, tables.objects), Binding::read(1, tables.media),
           Binding::texels(2, beams.points), Binding::read(3, beams.strengths),
           Binding::texels(4, clusters.beamNodes), Binding::read(5, clusters.ranges),
           Binding::read(6, clusters.clusters),
           Binding::write(7, scattersOnce ? clusters.latest : clusters.sources)});
      const bool more = adds || from > 0;
      commands.pushConstants(
          Sum{clusters.count, inputs.openingAngle, more ? 1U : 0U, from, from + nodesPerDispatch});
      commands.dispatchLinear(clusters.count);
    }
  }
}

void BeamPass::fitNodes(gpu::CommandList& commands, SceneTables& tables, Clusters& clusters,
                        Beams& beams, bool scattersOnce) const {
  forEachHeight(clusters.firstOfHeight, [&](std::size_t height, const NodeRange& range) {
    commands.bind(height == 0 ? leaves_ : nodes_);
    commands.bindResources({Binding::read(0, tables.objects), Binding::read(1, tables.media),
                            Binding::texels(2, beams.points), Binding::read(3, beams.strengths),
                            Binding::read(4, clusters.links), Binding::read(5, clusters.byHeight),
                            Binding::read(6, clusters.ranges), Binding::read(7, clusters.clusters),
                            Binding::write(8, clusters.beamNodes)});
    commands.pushConstants(PointNodes{range, scattersOnce ? 1U : 0U});
    commands.dispatchLinear(range.count);
  });
}

}  // namespace opaline::passes
