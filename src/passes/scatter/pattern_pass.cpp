#include "passes/scatter/pattern_pass.h"

#include "gpu/device.h"
#include "shaders/shaders.h"
#include "shaders/shared/medium.h"

namespace opaline::passes {

namespace {

using gpu::Binding;
using gpu::BindingType;

struct VertexMedium {
  std::uint32_t vertexCount;
  std::uint32_t medium;
};

// The pattern of one medium.
Binding patternOf(SceneTables& tables, std::uint32_t slot, std::uint32_t medium) {
  return Binding::uniform(slot, tables.pattern, medium * tables.patternStride,
                          shared::maxPatternEntries * sizeof(shared::PatternEntry));
}

}  // namespace

PatternPass::PatternPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      linear_(device, gpu::Filter::Linear),
      dipole_(makePipelines(device, ScatterTransport::Dipole)),
      betterDipole_(makePipelines(device, ScatterTransport::BetterDipole)) {}

gpu::Pipeline PatternPass::makeVertexPattern(gpu::Device& device, ScatterTransport transport,
                                             VertexPart part) {
  return {device, gpu::ComputePipelineOptions{
                      .name = "pattern over vertices",
                      .shader = shaders::scatter_pattern_vertices_comp,
                      .bindings = {{1, BindingType::StorageBuffer},
                                   {2, BindingType::StorageBuffer},
                                   {3, BindingType::StorageBuffer},
                                   {4, BindingType::StorageBuffer},
                                   {5, BindingType::StorageBuffer},
                                   {6, BindingType::UniformBuffer},
                                   {7, BindingType::SampledImage},
                                   {8, BindingType::SampledImage},
                                   {9, BindingType::SampledImage},
                                   {10, BindingType::SampledImage},
                                   {11, BindingType::StorageBuffer},
                                   {12, BindingType::StorageBuffer}},
                      .pushConstantBytes = sizeof(VertexMedium),
                      .specialization = {static_cast<std::uint32_t>(transport),
                                         part == VertexPart::Everything ? 1U : 0U},
                  }};
}

PatternPass::Pipelines PatternPass::makePipelines(gpu::Device& device, ScatterTransport transport) {
  const std::vector<std::uint32_t> specialization{static_cast<std::uint32_t>(transport)};
  return {
      gpu::Pipeline(device,
                    gpu::GraphicsPipelineOptions{
                        .name = "pattern over fragments",
                        .vertexShader = shaders::scatter_pattern_vert,
                        .fragmentShader = shaders::scatter_pattern_frag,
                        .bindings = {{1, BindingType::SampledImage},
                                     {2, BindingType::SampledImage},
                                     {3, BindingType::SampledImage},
                                     {4, BindingType::StorageBuffer},
                                     {5, BindingType::StorageBuffer},
                                     {6, BindingType::UniformBuffer},
                                     {7, BindingType::SampledImage},
                                     {8, BindingType::SampledImage}},
                        .pushConstantBytes = sizeof(std::uint32_t),
                        .specialization = specialization,
                        .colorFormats = {VK_FORMAT_R32G32B32A32_SFLOAT},
                    }),
      makeVertexPattern(device, transport, VertexPart::FarSamples),
      makeVertexPattern(device, transport, VertexPart::Everything),
  };
}

void PatternPass::overVertices(gpu::CommandList& commands, ScatterTransport transport,
                               VertexPart part, SceneTables& tables, DiffusionSources& sources,
                               DeformedMesh& mesh, Exitance& exitance) const {
  const Pipelines& made = pipelines(transport);
  commands.beginPass("scatter");
  commands.bind(part == VertexPart::Everything ? made.patternVertices : made.patternFar);
  for (std::uint32_t medium = 0; medium < tables.mediumCount; ++medium) {
    commands.bindResources({Binding::read(1, mesh.positions), Binding::read(2, mesh.vertexCorners),
                            Binding::write(3, exitance.vertices), Binding::read(4, tables.objects),
                            Binding::read(5, tables.media), patternOf(tables, 6, medium),
                            Binding::sampled(7, sources.nearPosition, linear_),
                            Binding::sampled(8, sources.nearFlux, linear_),
                            Binding::sampled(9, sources.farPosition, linear_),
                            Binding::sampled(10, sources.farFlux, linear_),
                            Binding::read(11, sources.charts),
                            Binding::read(12, sources.farPlaces)});
    commands.pushConstants(VertexMedium{mesh.vertexCount, medium});
    commands.dispatchLinear(mesh.vertexCount);
  }
  commands.endPass();
}

void PatternPass::overFragments(gpu::CommandList& commands, ScatterTransport transport,
                                SceneTables& tables, DiffusionSources& sources,
                                VisibleSurface& surface, Exitance& exitance) const {
  commands.beginPass("scatter");
  commands.bind(pipelines(transport).patternFragments);
  for (std::uint32_t medium = 0; medium < tables.mediumCount; ++medium) {
    commands.bindResources({Binding::sampled(1, surface.position, nearest_),
                            Binding::sampled(2, surface.place, nearest_),
                            Binding::sampled(3, surface.exitance, nearest_),
                            Binding::read(4, tables.objects), Binding::read(5, tables.media),
                            patternOf(tables, 6, medium),
                            Binding::sampled(7, sources.nearPosition, linear_),
                            Binding::sampled(8, sources.nearFlux, linear_)});
    commands.beginRendering({{.image = &exitance.image, .clear = medium == 0}});
    commands.pushConstants(medium);
    commands.draw(3);
    commands.endRendering();
  }
  commands.endPass();
}

}  // namespace opaline::passes
