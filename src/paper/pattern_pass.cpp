#include "paper/pattern_pass.h"

#include <bit>
#include <vector>

#include "gpu/device.h"
#include "gpu/transfer.h"
#include "paper/shaders/shared/pattern.h"
#include "passes/seen_parts.h"

namespace opaline::paper {

namespace {

constexpr std::size_t entriesOfMedium = std::size_t{shared::maxPatternEntries} + 1;  // and the head

// Entries from one medium's pattern to the next: a multiple of every device's alignment of uniform
// blocks, which is at most 256 bytes.
constexpr std::size_t stride = (entriesOfMedium + 15) / 16 * 16;

// The pattern of one medium.
gpu::Uniform patternOf(PatternTable& table, std::uint32_t medium) {
  return {table.entries, medium * table.stride, entriesOfMedium * sizeof(shared::PatternEntry)};
}

}  // namespace

PatternTable PatternPass::makeTable(gpu::Device& device, const RestScene& scene,
                                    const PatternLayout& layout, double texelMm,
                                    bssrdf::Model model) {
  std::vector<shared::PatternEntry> entries;
  for (std::size_t i = 0; i < scene.media.size(); ++i) {
    const PatternMask mask = makePatternMask(bssrdf::makeProfiles(model, scene.media[i]),
                                             layout.extentOfMedium[i], texelMm);
    const shared::PatternHead head{.nearSquareMm2 = static_cast<float>(mask.nearSquareMm2),
                                   .farSquareMm2 = static_cast<float>(mask.farSquareMm2),
                                   .nearSamples = mask.nearSamples};
    entries.push_back(std::bit_cast<shared::PatternEntry>(head));
    entries.insert(entries.end(), mask.entries.begin(), mask.entries.end());
    entries.resize((i + 1) * stride);
  }
  return {gpu::makeBuffer(device, "pattern", entries, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT),
          stride * sizeof(shared::PatternEntry)};
}

PatternPass::PatternPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      linear_(device, gpu::Filter::Linear),
      dipole_(makePipelines(device, passes::ScatterTransport::Dipole)),
      betterDipole_(makePipelines(device, passes::ScatterTransport::BetterDipole)) {}

PatternPass::Pipelines PatternPass::makePipelines(gpu::Device& device,
                                                  passes::ScatterTransport transport) {
  return {{device, "pattern over fragments", {.transport = transport}},
          {device, "pattern over vertices", {.transport = transport, .withNearBlock = 0}},
          {device, "pattern over vertices", {.transport = transport, .withNearBlock = 1}}};
}

void PatternPass::overVertices(gpu::CommandList& commands, passes::ScatterTransport transport,
                               bool everything, const Inputs& inputs, FlatScene& flat,
                               passes::DeformedMesh& mesh) const {
  const Pipelines& made = pipelines(transport);
  DiffusionSources& sources = inputs.map.sources;
  commands.beginPass("scatter");
  for (std::uint32_t medium = 0; medium < inputs.tables.mediumCount; ++medium) {
    commands.bind(everything ? made.patternVertices : made.patternFar,
                  {.positions = mesh.positions,
                   .corners = flat.vertexCorners,
                   .exitances = inputs.exitance.vertices,
                   .objects = inputs.tables.objects,
                   .media = inputs.tables.media,
                   .pattern = patternOf(inputs.map.pattern, medium),
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
                                const Inputs& inputs, FlatScene& flat,
                                const passes::SeenSurfaces& seen) const {
  DiffusionSources& sources = inputs.map.sources;
  commands.beginPass("scatter");
  for (std::uint32_t medium = 0; medium < inputs.tables.mediumCount; ++medium)
    passes::dispatchParts(commands, seen.surfaces, pipelines(transport).patternFragments,
                          {.listedPlaces = passes::listedPlaces(seen, nearest_),
                           .meshExitances = inputs.exitance.vertices,
                           .exitances = seen.surfaces.light,
                           .objects = inputs.tables.objects,
                           .media = inputs.tables.media,
                           .pattern = patternOf(inputs.map.pattern, medium),
                           .nearPosition = {sources.nearPosition, linear_},
                           .nearFlux = {sources.nearFlux, linear_},
                           .corners = flat.corners,
                           .cornerIndices = flat.indices,
                           .charts = sources.charts},
                          {.first = 0, .medium = medium});
  commands.endPass();
}

}  // namespace opaline::paper
