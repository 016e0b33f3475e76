#include "passes/boundary/reentry_pass.h"

#include <cstdint>

namespace opaline::passes {

Variants<shaders::BoundaryReentry> ReentryPass::make(gpu::Device& device, bool withPaint) {
  const auto one = [&](bool withOthers) -> gpu::Compute<shaders::BoundaryReentry> {
    return {device, "light that enters again", {.withPaint = withPaint, .withOthers = withOthers}};
  };
  return {one(false), one(true)};
}

ReentryPass::ReentryPass(gpu::Device& device)
    : reentry_{make(device, false), make(device, true)},
      around_{{device, "light that enters around", {.withPaint = 0}},
              {device, "light that enters around", {.withPaint = 1}}} {}

void ReentryPass::record(gpu::CommandList& commands, SceneTables& tables, bool isFirst,
                         Clusters& clusters) const {
  const bool withOthers{clusters.fromAfar};
  commands.beginPass("sources");
  const std::uint32_t lights = clusters.lights > 0 ? clusters.fromLights.lights : 0;
  commands.bind(reentry_.of(tables.paint.any, withOthers),
                {.objects = tables.objects,
                 .media = tables.media,
                 .ranges = clusters.ranges,
                 .clusters = clusters.clusters,
                 .meetings = clusters.meetings,
                 .latest = clusters.latest,
                 .enteredBefore = clusters.enteredBefore,
                 .arrived = clusters.arrived,
                 .strengths = clusters.fromEverywhere.strengths,
                 .entered = clusters.entered,
                 .clusterPaints = tables.paint.clusters,
                 .fromAfar = withOthers ? clusters.fromAfar : clusters.entered,
                 .peaks = clusters.peaks,
                 .sums = clusters.sums,
                 .enteredInAll = clusters.enteredInAll,
                 .behind = tables.haveThinParts ? clusters.meetingsBehind : clusters.meetings},
                {.clusterCount = clusters.count,
                 .raysOutwards = clusters.raysOutwards,
                 .meetingsBehindRay = tables.haveThinParts ? shared::meetingsBehind : 0,
                 .isFirst = isFirst,
                 .firstLight = clusters.lights - lights,
                 .lights = lights});
  commands.dispatchLinear(clusters.count);
  if (withOthers) recordAround(commands, tables, clusters);
  commands.endPass();
}

void ReentryPass::recordAround(gpu::CommandList& commands, SceneTables& tables,
                               Clusters& clusters) const {
  commands.bind(around_.of(tables.paint.any),
                {.objects = tables.objects,
                 .media = tables.media,
                 .clusterNodes = clusters.nodes,
                 .ranges = clusters.ranges,
                 .clusters = clusters.clusters,
                 .around = clusters.around,
                 .fromAfar = clusters.fromAfar,
                 .entered = clusters.entered,
                 .strengths = clusters.fromEverywhere.strengths,
                 .clusterPaints = tables.paint.clusters},
                {.clusterCount = clusters.count});
  commands.dispatchLinear(clusters.count);
}

}  // namespace opaline::passes
