#include "passes/scatter/surfel_sum_pass.h"

#include <algorithm>
#include <string>
#include <vector>

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "passes/seen_parts.h"

namespace opaline::passes {

namespace {

// Surfels summed by one invocation. Mesa's software device ends loops after 65,535 rounds.
constexpr std::uint32_t surfelsPerDispatch = 8192;

template <typename Dispatch>
void forEachRange(std::uint32_t surfels, const Dispatch& dispatch) {
  std::uint32_t first = 0;
  do {
    const std::uint32_t end = first + std::min(surfelsPerDispatch, surfels - first);
    dispatch(first, end);
    first = end;
  } while (first < surfels);
}

}  // namespace

SurfelSumPass::SurfelSumPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      dipole_(makePipelines(device, ScatterTransport::Dipole)),
      betterDipole_(makePipelines(device, ScatterTransport::BetterDipole)) {}

SurfelSumPass::Pipelines SurfelSumPass::makePipelines(gpu::Device& device,
                                                      ScatterTransport transport) {
  const auto overVertices = [&](std::uint32_t estimated, std::uint32_t coarse) {
    return gpu::Compute<shaders::ScatterTreeVertices>(
        device, "tree over vertices",
        {.transport = transport, .estimated = estimated, .withCoarse = coarse, .rough = 0});
  };
  const auto overFragments = [&](std::uint32_t estimated, std::uint32_t coarse) {
    return gpu::Compute<shaders::ScatterTree>(
        device, "tree over fragments",
        {.transport = transport, .estimated = estimated, .withCoarse = coarse});
  };
  return {{device,
           "rough sum over vertices",
           {.transport = transport, .estimated = 1, .withCoarse = 0, .rough = 1}},
          {overVertices(0, 0), {overVertices(1, 0), overVertices(1, 1)}},
          {overFragments(0, 0), {overFragments(1, 0), overFragments(1, 1)}},
          {device, "all surfels over vertices", {.transport = transport}},
          {device, "all surfels over fragments", {.transport = transport}}};
}

void SurfelSumPass::treeOverPlaces(gpu::CommandList& commands, const Order& order,
                                   const OverPlaces& over) const {
  const Pipelines& made = pipelines(order.transport);
  const auto& treeVertices = made.treeVertices.of(order.estimate, over.surfels.coarse);
  for (const auto* pipeline : {&made.roughVertices, &treeVertices}) {
    if (pipeline == &made.roughVertices && !order.estimate) continue;
    if (pipeline == &treeVertices && order.site == ScatterSite::Fragments) break;
    commands.beginPass(pipeline == &made.roughVertices ? "estimate" : "scatter");
    commands.bind(
        *pipeline,
        {.positions = over.places.positions,
         .objectOf = over.places.objectOf,
         .exitances = over.places.exitances,
         .objects = over.tables.objects,
         .media = over.tables.media,
         .nodes = over.surfels.nodes,
         .sources = over.surfels.sources,
         .order = over.places.order},
        {.vertexCount = over.places.count, .tolerance = order.tolerance, .site = order.site});
    commands.dispatchLinear(over.places.count, roundsOfWalk);
    commands.endPass();
  }
}

void SurfelSumPass::treeOverFragments(gpu::CommandList& commands, const Order& order,
                                      const Fragments& over) const {
  const SeenSurfaces& seen = over.seen;
  commands.beginPass("scatter");
  dispatchAsked(commands, seen.surfaces, over.asked,
                pipelines(order.transport).treeFragments.of(order.estimate, over.surfels.coarse),
                {.listedPlaces = listedPlaces(seen, nearest_),
                 .exitances = seen.surfaces.light,
                 .meshExitances = over.exitance.vertices,
                 .objects = over.tables.objects,
                 .media = over.tables.media,
                 .nodes = over.surfels.nodes,
                 .sources = over.surfels.sources,
                 .asked = seen.surfaces.asked,
                 .askedCount = seen.surfaces.countsOf(over.asked)},
                {.first = 0, .tolerance = order.tolerance});
  commands.endPass();
}

void SurfelSumPass::allOverPlaces(gpu::CommandList& commands, const Order& order,
                                  const OverPlaces& over) const {
  commands.beginPass("scatter");
  forEachRange(over.surfels.count, [&](std::uint32_t first, std::uint32_t end) {
    commands.bind(pipelines(order.transport).allVertices,
                  {.positions = over.places.positions,
                   .objectOf = over.places.objectOf,
                   .exitances = over.places.exitances,
                   .objects = over.tables.objects,
                   .media = over.tables.media,
                   .sources = over.surfels.sources},
                  {.vertexCount = over.places.count,
                   .firstSurfel = first,
                   .endSurfel = end,
                   .site = order.site});
    commands.dispatchLinear(over.places.count, surfelsPerDispatch);
  });
  commands.endPass();
}

void SurfelSumPass::allOverFragments(gpu::CommandList& commands, const Order& order,
                                     const Fragments& over) const {
  const SeenSurfaces& seen = over.seen;
  commands.beginPass("scatter");
  forEachRange(over.surfels.count, [&](std::uint32_t firstSurfel, std::uint32_t endSurfel) {
    dispatchAsked(commands, seen.surfaces, over.asked, pipelines(order.transport).allFragments,
                  {.listedPlaces = listedPlaces(seen, nearest_),
                   .exitances = seen.surfaces.light,
                   .objects = over.tables.objects,
                   .media = over.tables.media,
                   .sources = over.surfels.sources,
                   .asked = seen.surfaces.asked,
                   .askedCount = seen.surfaces.countsOf(over.asked)},
                  {.first = 0, .firstSurfel = firstSurfel, .endSurfel = endSurfel});
  });
  commands.endPass();
}

}  // namespace opaline::passes
