#include "paper/pattern_pass.h"

#include "gpu/device.h"
#include "shaders/shared/medium.h"

namespace opaline::paper {

namespace {

// The pattern of one medium.
gpu::Uniform patternOf(passes::SceneTables& tables, std::uint32_t medium) {
  return {tables.pattern, medium * tables.patternStride,
          shared::maxPatternEntries * sizeof(shared::PatternEntry)};
}

}  // namespace

PatternPass::PatternPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      linear_(device, gpu::Filter::Linear),
      dipole_(makePipelines(device, passes::ScatterTransport::Dipole)),
      betterDipole_(makePipelines(device, passes::ScatterTransport::BetterDipole)) {}

PatternPass::Pipelines PatternPass::makePipelines(gpu::Device& device,
                                                  passes::ScatterTransport transport) {
  return {{device,
           "pattern over fragments",
           {.colorFormats = {VK_FORMAT_R32G32B32A32_SFLOAT}},
           {.transport = transport}},
          {device, "pattern over vertices", {.transport = transport, .withNearBlock = 0}},
          {device, "pattern over vertices", {.transport = transport, .withNearBlock = 1}}};
}

void PatternPass::overVertices(gpu::CommandList& commands, passes::ScatterTransport transport,
                               VertexPart part, passes::SceneTables& tables,
                               passes::DiffusionSources& sources, passes::DeformedMesh& mesh,
                               passes::Exitance& exitance) const {
  const Pipelines& made = pipelines(transport);
  commands.beginPass("scatter");
  for (std::uint32_t medium = 0; medium < tables.mediumCount; ++medium) {
    commands.bind(part == VertexPart::Everything ? made.patternVertices : made.patternFar,
                  {.positions = mesh.positions,
                   .corners = mesh.vertexCorners,
                   .exitances = exitance.vertices,
                   .objects = tables.objects,
                   .media = tables.media,
                   .pattern = patternOf(tables, medium),
                   .nearPosition = {sources.nearPosition, linear_},
                   .nearFlux = {sources.nearFlux, linear_},
                   .farPosition = {sources.farPosition, linear_},
                   .farFlux = {sources.farFlux, linear_},
                   .charts = sources.charts,
                   .farPlaces = sources.farPlaces},
                  {.vertexCount = mesh.vertexCount, .medium = medium});
    commands.dispatchLinear(mesh.vertexCount, shared::maxPatternEntries);
  }
  commands.endPass();
}

void PatternPass::overFragments(gpu::CommandList& commands, passes::ScatterTransport transport,
                                passes::SceneTables& tables, passes::DiffusionSources& sources,
                                passes::VisibleSurface& surface, passes::Exitance& exitance) const {
  commands.beginPass("scatter");
  for (std::uint32_t medium = 0; medium < tables.mediumCount; ++medium) {
    commands.bind(pipelines(transport).patternFragments, {},
                  {.surfacePosition = {surface.position, nearest_},
                   .surfacePlace = {surface.place, nearest_},
                   .farExitance = {surface.exitance, nearest_},
                   .objects = tables.objects,
                   .media = tables.media,
                   .pattern = patternOf(tables, medium),
                   .nearPosition = {sources.nearPosition, linear_},
                   .nearFlux = {sources.nearFlux, linear_}},
                  {.medium = medium});
    commands.beginRendering({{.image = &exitance.image, .clear = medium == 0}});
    commands.drawEverywhere(shared::maxPatternEntries);
    commands.endRendering();
  }
  commands.endPass();
}

}  // namespace opaline::paper
