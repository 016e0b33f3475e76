#include "passes/boundary/beam_pass.h"

#include <algorithm>
#include <cstddef>
#include <type_traits>

#include "gpu/device.h"
#include "passes/fitted_tree.h"
#include "passes/mechanics.h"
#include "shaders/shared/boundary.h"

namespace opaline::passes {

namespace {

// A channel of a point of second collisions each.
constexpr std::uint32_t pathsOfBeam = 3 * shared::maxSecondPoints;

// For each light that of sources of fluence, and that of light that scatters once where some is
// followed that far.
std::uint32_t treesOf(const SceneTables& tables, const Beams& beams) {
  return beams.lights * (tables.followsLight ? 2 : 1);
}

}  // namespace

Variants<shaders::BoundaryBeams> BeamPass::makeTrace(gpu::Device& device, bool withPaint) {
  const auto make = [&](bool withLinings) -> gpu::Compute<shaders::BoundaryBeams> {
    return {device, "points of light", {.withPaint = withPaint, .withLinings = withLinings}};
  };
  return {make(false), make(true)};
}

BeamPass::BeamPass(gpu::Device& device)
    : trace_{makeTrace(device, false), makeTrace(device, true)},
      sharers_(device.workGroups().lanes > 1 ? pathsOfBeam : 1),
      followOn_{{device, "second collisions", {.withLinings = 0, .sharers = sharers_}},
                {device, "second collisions", {.withLinings = 1, .sharers = sharers_}}},
      addMirrored_(device, "mirrored light", {.addsUp = 1}),
      takeMirrored_(device, "mirrored light", {.addsUp = 0}),
      leaves_(device, "leaves of points", {.ofLeaves = 1}),
      nodes_(device, "nodes of points", {.ofLeaves = 0}),
      acting_(device, "points that act on groups"),
      source_{{device, "sources of fluence", {.withSeveralMedia = 0}},
              {device, "sources of fluence", {.withSeveralMedia = 1}}},
      singleForward_{
          {device, "light that scatters once", {.scattersEvenly = 0, .withSeveralMedia = 0}},
          {device, "light that scatters once", {.scattersEvenly = 0, .withSeveralMedia = 1}}},
      singleEven_(device, "light that scatters once", {.scattersEvenly = 1, .withSeveralMedia = 0}),
      reentry_{{device, "light that enters again", {.withPaint = 0}},
               {device, "light that enters again", {.withPaint = 1}}} {}

void BeamPass::recordLights(gpu::CommandList& commands, const Inputs& inputs, const Wanted& wanted,
                            Clusters& clusters) const {
  if (wanted.bounces && clusters.lights == 0) commands.fill({clusters.arrived}, 0);
  const std::uint32_t atOnce = clusters.fromLights.room;
  for (std::uint32_t first = 0; first < clusters.lights; first += atOnce) {
    clusters.fromLights.lights = std::min(atOnce, clusters.lights - first);
    commands.beginPass("rays");
    trace(commands, inputs, {first, wanted.bounces}, clusters, clusters.fromLights);
    if (wanted.bounces) bringMirrored(commands, first, clusters);
    commands.endPass();
    commands.beginPass("sources");
    spread(commands, inputs, clusters, clusters.fromLights, first > 0);
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
    Inputs ofSky = inputs;
    ofSky.openingAngle = inputs.openingAngleOfSky;
    spread(commands, ofSky, clusters, clusters.fromEverywhere, clusters.lights > 0);
  } else {
    commands.fill({clusters.sources, clusters.latest}, 0);
  }
  commands.endPass();
}

void BeamPass::recordReentry(gpu::CommandList& commands, const Inputs& inputs, Clusters& clusters,
                             bool isFirst) const {
  commands.beginPass("sources");
  commands.bind(
      reentry_.of(inputs.tables.paint.any),
      {.objects = inputs.tables.objects,
       .media = inputs.tables.media,
       .ranges = clusters.ranges,
       .clusters = clusters.clusters,
       .meetings = clusters.meetings,
       .latest = clusters.latest,
       .enteredBefore = clusters.enteredBefore,
       .arrived = clusters.arrived,
       .strengths = clusters.fromEverywhere.strengths,
       .entered = clusters.entered,
       .clusterPaints = inputs.tables.paint.clusters},
      {.clusterCount = clusters.count, .raysOutwards = clusters.raysOutwards, .isFirst = isFirst});
  commands.dispatchLinear(clusters.count);
  spread(commands, inputs, clusters, clusters.fromEverywhere, false);
  commands.endPass();
}

void BeamPass::trace(gpu::CommandList& commands, const Inputs& inputs, const Beam& beam,
                     Clusters& clusters, Beams& beams) const {
  commands.bind(trace_.of(inputs.tables.paint.any, clusters.haveLinings),
                {.frame = inputs.frame.data,
                 .objects = inputs.tables.objects,
                 .media = inputs.tables.media,
                 .pieceCorners = inputs.rays.corners,
                 .rayHierarchy = rays(inputs.rays),
                 .ranges = clusters.ranges,
                 .clusters = clusters.clusters,
                 .entries = clusters.entries,
                 .points = beams.points,
                 .strengths = beams.strengths,
                 .clusterOfSurfel = clusters.clusterOfSurfel,
                 .mirrored = clusters.mirrored,
                 .peaks = clusters.peaks,
                 .entered = clusters.entered,
                 .skyShares = clusters.skyShares,
                 .clusterPaints = inputs.tables.paint.clusters,
                 .opaqueShares = inputs.tables.opaqueShares,
                 .collisions = beams.collisions},
                {.clusterCount = clusters.count,
                 .firstLight = beam.firstLight,
                 .lights = beams.lights,
                 .piecesPerSurfel = inputs.surfels.piecesPerSurfel,
                 .nodeCount = inputs.surfels.tree.nodeCount,
                 .mirrors = beam.mirrors});
  commands.dispatchLinear(beams.lights * clusters.count, shared::maxReflections * roundsOfWalk);
  if (inputs.tables.followsLight) followOn(commands, inputs, beam, clusters, beams);
}

void BeamPass::followOn(gpu::CommandList& commands, const Inputs& inputs, const Beam& beam,
                        Clusters& clusters, Beams& beams) const {
  commands.bind(followOn_.of(clusters.haveLinings),
                {.objects = inputs.tables.objects,
                 .media = inputs.tables.media,
                 .pieceCorners = inputs.rays.corners,
                 .rayHierarchy = rays(inputs.rays),
                 .ranges = clusters.ranges,
                 .clusters = clusters.clusters,
                 .entries = clusters.entries,
                 .points = beams.points,
                 .strengths = beams.strengths,
                 .clusterOfSurfel = clusters.clusterOfSurfel,
                 .opaqueShares = inputs.tables.opaqueShares,
                 .collisions = beams.collisions},
                {.clusterCount = clusters.count,
                 .firstLight = beam.firstLight,
                 .lights = beams.lights,
                 .piecesPerSurfel = inputs.surfels.piecesPerSurfel});
  // Most end before they meet the surface.
  commands.dispatchLinear(beams.lights * clusters.count * sharers_,
                          pathsOfBeam / sharers_ * roundsOfWalk);
}

void BeamPass::bringMirrored(gpu::CommandList& commands, std::uint32_t firstLight,
                             Clusters& clusters) const {
  const std::uint32_t lights = clusters.fromLights.lights;
  for (const auto* pipeline : {&addMirrored_, &takeMirrored_}) {
    commands.bind(*pipeline,
                  {.mirrored = clusters.mirrored,
                   .peaks = clusters.peaks,
                   .sums = clusters.sums,
                   .arrived = clusters.arrived},
                  {.clusterCount = clusters.count,
                   .firstLight = firstLight,
                   .lights = lights,
                   .adds = firstLight > 0});
    commands.dispatchLinear(clusters.count * (pipeline == &addMirrored_ ? lights : 1));
  }
}

// As fluence and, where light is followed to its second collision, as what scatters once.
void BeamPass::spread(gpu::CommandList& commands, const Inputs& inputs, Clusters& clusters,
                      Beams& beams, bool adds) const {
  const bool scattersOnce = inputs.tables.followsLight;
  fitNodes(commands, inputs.tables, clusters, beams);
  // In parts of each body's nodes for which lists have room.
  const std::uint32_t room = clusters.roomOfBeamList;
  for (std::uint32_t from = 0; from < clusters.mostNodesOfBody; from += room) {
    listActing(commands, from, inputs, clusters, beams);
    const Part part{.isFirst = from == 0, .adds = adds || from > 0};
    const bool several = clusters.haveSeveralMedia;
    sum(commands, source_.of(several), clusters.sources, part, inputs, clusters, beams);
    if (!scattersOnce) continue;
    const bool evenly = inputs.tables.scattersEvenly && !several;
    sum(commands, evenly ? singleEven_ : singleForward_.of(several), clusters.latest, part, inputs,
        clusters, beams);
  }
}

template <typename Shader>
void BeamPass::sum(gpu::CommandList& commands, const gpu::Compute<Shader>& pipeline,
                   gpu::Buffer& sums, const Part& part, const Inputs& inputs, Clusters& clusters,
                   Beams& beams) const {
  constexpr bool scattersOnce = std::is_same_v<Shader, shaders::BoundarySingle>;
  const std::uint32_t room = clusters.roomOfBeamList;
  commands.bind(pipeline,
                {.objects = inputs.tables.objects,
                 .media = inputs.tables.media,
                 .points = beams.points,
                 .strengths = beams.strengths,
                 .beamNodes = clusters.beamNodes,
                 .tiles = clusters.tiles,
                 .clusterTexels = clusters.clusters,
                 .ranges = clusters.ranges,
                 .clusters = clusters.clusters,
                 .lists = clusters.beamLists,
                 .sums = sums,
                 .objectOfNode = clusters.objectOfNode},
                {.tileCount = clusters.tileCount,
                 .openingAngle = inputs.openingAngle,
                 .adds = part.adds,
                 .isFirst = part.isFirst,
                 .lights = beams.lights,
                 .clusterCount = clusters.count,
                 .room = room,
                 .firstTree = scattersOnce ? beams.lights : 0,
                 .nodeCount = clusters.tree.nodeCount,
                 .groupCount = clusters.groupCount});
  commands.dispatchGroups(clusters.tileCount,
                          beams.lights * shared::maxPoints * (room / groupSize + 1));
}

void BeamPass::listActing(gpu::CommandList& commands, std::uint32_t firstNode, const Inputs& inputs,
                          Clusters& clusters, const Beams& beams) const {
  const std::uint32_t room = clusters.roomOfBeamList;
  const std::uint32_t trees = treesOf(inputs.tables, beams);
  commands.bind(acting_,
                {.objects = inputs.tables.objects,
                 .media = inputs.tables.media,
                 .beamNodes = clusters.beamNodes,
                 .groups = clusters.groups,
                 .clusterTexels = clusters.clusters,
                 .lists = clusters.beamLists},
                {.groupCount = clusters.groupCount,
                 .openingAngle = inputs.openingAngle,
                 .trees = trees,
                 .lights = beams.lights,
                 .nodeCount = clusters.tree.nodeCount,
                 .room = room,
                 .firstNode = firstNode,
                 .endNode = firstNode + room});
  commands.dispatchGroups(trees * clusters.groupCount, 2 * (room / groupSize + roundsOfWalk));
}

void BeamPass::fitNodes(gpu::CommandList& commands, SceneTables& tables, Clusters& clusters,
                        Beams& beams) const {
  const std::uint32_t trees = treesOf(tables, beams);
  const auto bind = [&](const auto& pipeline, std::uint32_t firstTreelet, std::uint32_t count) {
    commands.bind(pipeline,
                  {.treeletOrder = treeletOrder(clusters.tree),
                   .objects = tables.objects,
                   .media = tables.media,
                   .points = beams.points,
                   .strengths = beams.strengths,
                   .ranges = clusters.ranges,
                   .clusters = clusters.clusters,
                   .nodes = clusters.beamNodes},
                  {.firstTreelet = firstTreelet,
                   .count = count,
                   .trees = trees,
                   .lights = beams.lights,
                   .clusterCount = clusters.count,
                   .nodeCount = clusters.tree.nodeCount});
  };
  bind(leaves_, 0, clusters.count);
  commands.dispatchGroups(shared::groupsOfNodes(trees * clusters.count));
  fitInnerNodes(
      commands, clusters.tree,
      [&](std::uint32_t firstTreelet, std::uint32_t count) { bind(nodes_, firstTreelet, count); },
      trees);
}

}  // namespace opaline::passes
