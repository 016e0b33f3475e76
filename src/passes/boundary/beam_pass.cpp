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

// The kinds of trees: of sources of fluence and, if light is followed to its second collision, of
// light that scatters once.
std::uint32_t kindsOf(const SceneTables& tables) {
  return tables.followsLight ? 2 : 1;
}

// Whether a body has more nodes than lists have room for.
bool areInParts(const Clusters& clusters) {
  return clusters.mostNodesOfBody > clusters.roomOfBeamList;
}

// Whether coefficients can be kept. They cannot if lists are made in parts, or are too many for
// each tile to sum the lengths of all lists before its own. Behind linings they would not be exact
// enough.
bool canKeep(const Clusters& clusters) {
  constexpr std::uint32_t mostGroups = 1024;
  return !clusters.haveLinings && !areInParts(clusters) && clusters.groupCount <= mostGroups;
}

// Where loops end early, an invocation has no more paths than can be followed in any body.
std::uint32_t sharersOf(const gpu::Device& device) {
  constexpr std::uint32_t mostPaths = 6;
  return device.workGroups().loopsEnd ? shared::pathsOfBeam / mostPaths : shared::pathsOfBeam;
}

}  // namespace

struct BeamPass::Spreading {
  SceneTables& tables;
  Clusters& clusters;
  Beams& beams;
  float openingAngle;
  bool ofEverywhere;
  std::uint32_t roomOfKept;  // entries of the lists of each kind

  std::uint32_t kinds() const { return kindsOf(tables); }
  // See lib/beam_trees.glsl.
  Trees ofShape() const { return {0, kinds()}; }
  Trees ofLights() const { return {kinds(), kinds() * beams.lights}; }
  Trees all() const { return {0, kinds() * (1 + beams.lights)}; }
  std::uint32_t firstTree(std::uint32_t kind) const { return kinds() + kind * beams.lights; }
  std::uint32_t firstListed(std::uint32_t kind) const {
    return ofEverywhere ? kind : firstTree(kind);
  }
  shaders::BeamTile tile() const {
    return {.objects = tables.objects,
            .media = tables.media,
            .points = beams.points,
            .strengths = beams.strengths,
            .beamNodes = clusters.beamNodes,
            .tiles = clusters.tiles,
            .clusterTexels = clusters.clusters,
            .clusters = clusters.clusters,
            .lists = clusters.beamLists,
            .objectOfNode = clusters.objectOfNode};
  }
  // Push constants of shaders with lib/beam_tile.glsl.
  template <typename Shader>
  typename Shader::Push push(std::uint32_t kind, std::uint32_t lit, const Part& part) const {
    return {.tileCount = clusters.tileCount,
            .openingAngle = openingAngle,
            .adds = part.adds,
            .isFirst = part.isFirst,
            .lights = beams.lights,
            .clusterCount = clusters.count,
            .room = clusters.roomOfBeamList,
            .firstTree = lit,
            .firstListed = firstListed(kind),
            .nodeCount = clusters.tree.nodeCount,
            .groupCount = clusters.groupCount,
            .kindOfBeams = kind,
            .roomOfKept = roomOfKept};
  }
  std::uint32_t rounds() const {
    return beams.lights * shared::maxPoints * (clusters.roomOfBeamList / groupSize + 1);
  }
};

VariantsOfTwo<shaders::BoundaryBeams> BeamPass::makeTrace(gpu::Device& device, bool withPaint) {
  const auto make = [&](bool withLinings,
                        bool withThinParts) -> gpu::Compute<shaders::BoundaryBeams> {
    return {device,
            "points of light",
            {.withPaint = withPaint, .withLinings = withLinings, .withThinParts = withThinParts}};
  };
  return {{make(false, false), make(false, true)}, {make(true, false), make(true, true)}};
}

BeamPass::BeamPass(gpu::Device& device)
    : trace_{makeTrace(device, false), makeTrace(device, true)},
      sharers_(sharersOf(device)),
      followOn_{{device, "second collisions", {.withLinings = 0, .sharers = sharers_}},
                {device, "second collisions", {.withLinings = 1, .sharers = sharers_}}},
      addMirrored_(device, "mirrored light", {.addsUp = 1}),
      takeMirrored_(device, "mirrored light", {.addsUp = 0}),
      addGuided_(device, "guided light", {.addsUp = 1}),
      takeGuided_(device, "guided light", {.addsUp = 0}),
      leaves_(device, "leaves of points", {.ofLeaves = 1}),
      nodes_(device, "nodes of points", {.ofLeaves = 0}),
      acting_(device, "points that act on groups"),
      source_{{device, "sources of fluence", {.withSeveralMedia = 0}},
              {device, "sources of fluence", {.withSeveralMedia = 1}}},
      singleForward_{
          {device, "light that scatters once", {.scattersEvenly = 0, .withSeveralMedia = 0}},
          {device, "light that scatters once", {.scattersEvenly = 0, .withSeveralMedia = 1}}},
      singleEven_(device, "light that scatters once", {.scattersEvenly = 1, .withSeveralMedia = 0}),
      sourceCoefficients_{{device, "coefficients of fluence", {.withSeveralMedia = 0}},
                          {device, "coefficients of fluence", {.withSeveralMedia = 1}}},
      singleForwardCoefficients_{
          {device, "coefficients of single", {.scattersEvenly = 0, .withSeveralMedia = 0}},
          {device, "coefficients of single", {.scattersEvenly = 0, .withSeveralMedia = 1}}},
      singleEvenCoefficients_(device, "coefficients of single",
                              {.scattersEvenly = 1, .withSeveralMedia = 0}) {}

void BeamPass::makeCoefficients(gpu::Device& device, Clusters& clusters) {
  constexpr std::size_t mostBytesOfAll = std::size_t{64} << 20U;
  const std::size_t tiles = std::size_t{shared::kindsOfBeams} * clusters.tileCount;
  const std::size_t ofEntry = shared::texelsOfPoints * sizeof(shared::vec4);
  const std::size_t bytes =
      canKeep(clusters) ? std::min(mostBytesOfAll, mostBytes(device.limits())) : 0;
  const std::size_t room = std::min(bytes / ofEntry, tiles * clusters.tree.nodeCount);
  clusters.roomOfKept = static_cast<std::uint32_t>(room);
  clusters.beamCoefficients = makeRoom<shared::vec4>(device, "coefficients of points of light",
                                                     room * shared::texelsOfPoints);
  clusters.keptBeams =
      makeRoom<std::uint32_t>(device, "kept lists of points of light",
                              room > 0 ? tiles * shared::countsOfKept + 2 * room : 0);
}

void BeamPass::recordLights(gpu::CommandList& commands, const Inputs& inputs, const Wanted& wanted,
                            Clusters& clusters) const {
  commands.fill({clusters.peaks}, 0);
  clearGuided(commands, inputs.tables, clusters);
  const std::uint32_t atOnce = clusters.fromLights.room;
  for (std::uint32_t first = 0; first < clusters.lights; first += atOnce) {
    const bool isLast = first + atOnce >= clusters.lights;
    clusters.fromLights.lights = std::min(atOnce, clusters.lights - first);
    commands.beginPass("rays");
    trace(commands, inputs, {first, wanted.bounces}, clusters, clusters.fromLights);
    if (wanted.bounces) bringMirrored(commands, first, isLast, clusters);
    commands.endPass();
    commands.beginPass("sources");
    spreadLights(commands, inputs, clusters, first > 0);
    if (!isLast) {
      takeGuided(commands, inputs.tables, {.ofLights = true, .ofEverywhere = false}, clusters);
      clearGuided(commands, inputs.tables, clusters);
    }
    commands.endPass();
  }
  if (wanted.sky || wanted.bounces) {
    commands.beginPass("rays");
    trace(commands, inputs, {clusters.lights, false}, clusters, clusters.fromEverywhere);
    commands.endPass();
  }
  commands.beginPass("sources");
  if (wanted.sky)
    spreadEverywhere(commands, inputs, clusters, clusters.lights > 0, wanted.isNew);
  else if (clusters.lights == 0)
    commands.fill({clusters.sources, clusters.latest}, 0);
  takeGuided(commands, inputs.tables, {.ofLights = clusters.lights > 0, .ofEverywhere = wanted.sky},
             clusters);
  commands.endPass();
}

void BeamPass::recordAgain(gpu::CommandList& commands, const Inputs& inputs, bool isNew,
                           Clusters& clusters) const {
  commands.beginPass("sources");
  spreadEverywhere(commands, inputs, clusters, false, isNew);
  commands.endPass();
}

void BeamPass::trace(gpu::CommandList& commands, const Inputs& inputs, const Beam& beam,
                     Clusters& clusters, Beams& beams) const {
  const bool thinParts = beam.entersAgain && inputs.tables.haveThinParts;
  commands.bind(trace_.of(inputs.tables.paint.any, clusters.haveLinings, thinParts),
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
                 .collisions = beams.collisions,
                 .strongest = beams.strongest,
                 .withheld = clusters.withheld},
                {.clusterCount = clusters.count,
                 .firstLight = beam.firstLight,
                 .lights = beams.lights,
                 .piecesPerSurfel = inputs.surfels.piecesPerSurfel,
                 .nodeCount = inputs.surfels.tree.nodeCount,
                 .mirrors = beam.entersAgain});
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
                 .collisions = beams.collisions,
                 .guidedLight = beams.guided},
                {.clusterCount = clusters.count,
                 .firstLight = beam.firstLight,
                 .lights = beams.lights,
                 .piecesPerSurfel = inputs.surfels.piecesPerSurfel,
                 .comesFromEverywhere = beam.firstLight == clusters.lights});
  // Most paths end before they meet the surface.
  commands.dispatchLinear(beams.lights * clusters.count * sharers_,
                          shared::pathsOfBeam / sharers_ * roundsOfWalk);
}

// ReentryPass takes what the last lights bring.
void BeamPass::bringMirrored(gpu::CommandList& commands, std::uint32_t firstLight, bool isLast,
                             Clusters& clusters) const {
  const std::uint32_t lights = clusters.fromLights.lights;
  const auto dispatch = [&](const auto& pipeline, std::uint32_t count) {
    commands.bind(pipeline,
                  {.mirrored = clusters.mirrored,
                   .peaks = clusters.peaks,
                   .sums = clusters.sums,
                   .arrived = clusters.arrived},
                  {.clusterCount = clusters.count,
                   .firstLight = firstLight,
                   .lights = lights,
                   .adds = firstLight > 0});
    commands.dispatchLinear(count);
  };
  dispatch(addMirrored_, clusters.count * lights);
  if (!isLast) dispatch(takeMirrored_, clusters.count);
}

void BeamPass::clearGuided(gpu::CommandList& commands, const SceneTables& tables,
                           Clusters& clusters) {
  if (!tables.followsLight) return;
  commands.fill(
      {clusters.fromLights.strongest, clusters.fromEverywhere.strongest, clusters.guidedSums}, 0);
}

void BeamPass::takeGuided(gpu::CommandList& commands, const SceneTables& tables, const GuidedOf& of,
                          Clusters& clusters) const {
  if (!tables.followsLight || !(of.ofLights || of.ofEverywhere)) return;
  const std::uint32_t lights = of.ofLights ? clusters.fromLights.lights : 0;
  const auto dispatch = [&](const auto& pipeline, std::uint32_t count) {
    commands.bind(
        pipeline,
        {.clusterNodes = clusters.nodes,
         .ranges = clusters.ranges,
         .clusters = clusters.clusters,
         .around = clusters.around,
         .strengths = clusters.fromLights.strengths,
         .strongest = clusters.fromLights.strongest,
         .guided = clusters.fromLights.guided,
         .sums = clusters.guidedSums,
         .latest = clusters.latest,
         .strongestOfEverywhere = clusters.fromEverywhere.strongest,
         .strengthsOfEverywhere = clusters.fromEverywhere.strengths,
         .guidedOfEverywhere = clusters.fromEverywhere.guided},
        {.clusterCount = clusters.count, .lights = lights, .withEverywhere = of.ofEverywhere});
    commands.dispatchLinear(count);
  };
  const std::uint32_t beams = lights + (of.ofEverywhere ? 1 : 0);
  dispatch(addGuided_, beams * clusters.count * shared::pathsOfBeam);
  dispatch(takeGuided_, clusters.count);
}

void BeamPass::spreadLights(gpu::CommandList& commands, const Inputs& inputs, Clusters& clusters,
                            bool adds) const {
  const Spreading of{.tables = inputs.tables,
                     .clusters = clusters,
                     .beams = clusters.fromLights,
                     .openingAngle = inputs.openingAngle,
                     .ofEverywhere = false,
                     .roomOfKept = 0};
  fitNodes(commands, of.ofLights(), of);
  // Takes each body's nodes in parts for which lists have room.
  const std::uint32_t room = clusters.roomOfBeamList;
  for (std::uint32_t from = 0; from < clusters.mostNodesOfBody; from += room) {
    listActing(commands, from, of.ofLights(), of);
    sumUp(commands, {.isFirst = from == 0, .adds = adds || from > 0}, of);
  }
}

// Which nodes act on which, and by what coefficients, depends on the shape alone. So it is found
// once, unless lists are made in parts.
void BeamPass::spreadEverywhere(gpu::CommandList& commands, const Inputs& inputs,
                                Clusters& clusters, bool adds, bool isNew) const {
  const std::uint32_t room = clusters.roomOfBeamList;
  const Spreading of{
      .tables = inputs.tables,
      .clusters = clusters,
      .beams = clusters.fromEverywhere,
      .openingAngle = inputs.openingAngleOfEverywhere,
      .ofEverywhere = true,
      .roomOfKept = inputs.keepsCoefficients ? clusters.roomOfKept / kindsOf(inputs.tables) : 0};
  fitNodes(commands, isNew ? of.all() : of.ofLights(), of);
  for (std::uint32_t from = 0; from < clusters.mostNodesOfBody; from += room) {
    if (isNew || areInParts(clusters)) listActing(commands, from, of.ofShape(), of);
    if (isNew && of.roomOfKept > 0) findCoefficients(commands, of);
    sumUp(commands, {.isFirst = from == 0, .adds = adds || from > 0}, of);
  }
}

// Sums fluence and, if light is followed to its second collision, light that scatters once.
void BeamPass::sumUp(gpu::CommandList& commands, const Part& part, const Spreading& of) const {
  const bool several = of.clusters.haveSeveralMedia;
  sum(commands, source_.of(several), of.clusters.sources, part, of);
  if (!of.tables.followsLight) return;
  const bool evenly = of.tables.scattersEvenly && !several;
  sum(commands, evenly ? singleEven_ : singleForward_.of(several), of.clusters.latest, part, of);
}

template <typename Shader>
void BeamPass::sum(gpu::CommandList& commands, const gpu::Compute<Shader>& pipeline,
                   gpu::Buffer& sums, const Part& part, const Spreading& of) const {
  constexpr std::uint32_t kind = std::is_same_v<Shader, shaders::BoundarySingle> ? 1 : 0;
  Clusters& clusters = of.clusters;
  commands.bind(pipeline,
                {.beamTile = of.tile(),
                 .ranges = clusters.ranges,
                 .sums = sums,
                 .coefficients = clusters.beamCoefficients,
                 .kept = clusters.keptBeams},
                of.push<Shader>(kind, of.firstTree(kind), part));
  commands.dispatchGroups(clusters.tileCount, of.rounds());
}

void BeamPass::findCoefficients(gpu::CommandList& commands, const Spreading& of) const {
  const bool several = of.clusters.haveSeveralMedia;
  findCoefficients(commands, sourceCoefficients_.of(several), of);
  if (!of.tables.followsLight) return;
  const bool evenly = of.tables.scattersEvenly && !several;
  findCoefficients(commands,
                   evenly ? singleEvenCoefficients_ : singleForwardCoefficients_.of(several), of);
}

template <typename Shader>
void BeamPass::findCoefficients(gpu::CommandList& commands, const gpu::Compute<Shader>& pipeline,
                                const Spreading& of) const {
  constexpr std::uint32_t kind =
      std::is_same_v<Shader, shaders::BoundarySingleCoefficients> ? 1 : 0;
  Clusters& clusters = of.clusters;
  commands.bind(pipeline,
                {.beamTile = of.tile(),
                 .coefficients = clusters.beamCoefficients,
                 .kept = clusters.keptBeams},
                of.push<Shader>(kind, of.firstListed(kind), {.isFirst = false, .adds = false}));
  commands.dispatchGroups(clusters.tileCount, of.rounds());
}

void BeamPass::listActing(gpu::CommandList& commands, std::uint32_t firstNode, const Trees& trees,
                          const Spreading& of) const {
  Clusters& clusters = of.clusters;
  const std::uint32_t room = clusters.roomOfBeamList;
  commands.bind(acting_,
                {.objects = of.tables.objects,
                 .media = of.tables.media,
                 .beamNodes = clusters.beamNodes,
                 .groups = clusters.groups,
                 .clusterTexels = clusters.clusters,
                 .lists = clusters.beamLists},
                {.groupCount = clusters.groupCount,
                 .openingAngle = of.openingAngle,
                 .firstTree = trees.first,
                 .trees = trees.count,
                 .kinds = of.kinds(),
                 .lights = of.beams.lights,
                 .nodeCount = clusters.tree.nodeCount,
                 .room = room,
                 .firstNode = firstNode,
                 .endNode = firstNode + room});
  commands.dispatchGroups(trees.count * clusters.groupCount, 2 * (room / groupSize + roundsOfWalk));
}

void BeamPass::fitNodes(gpu::CommandList& commands, const Trees& trees, const Spreading& of) const {
  Clusters& clusters = of.clusters;
  const auto bind = [&](const auto& pipeline, std::uint32_t firstTreelet, std::uint32_t count) {
    commands.bind(pipeline,
                  {.treeletOrder = treeletOrder(clusters.tree),
                   .objects = of.tables.objects,
                   .media = of.tables.media,
                   .points = of.beams.points,
                   .strengths = of.beams.strengths,
                   .ranges = clusters.ranges,
                   .clusters = clusters.clusters,
                   .nodes = clusters.beamNodes},
                  {.firstTreelet = firstTreelet,
                   .count = count,
                   .firstTree = trees.first,
                   .trees = trees.count,
                   .kinds = of.kinds(),
                   .lights = of.beams.lights,
                   .clusterCount = clusters.count,
                   .nodeCount = clusters.tree.nodeCount});
  };
  bind(leaves_, 0, clusters.count);
  commands.dispatchGroups(shared::groupsOfNodes(trees.count * clusters.count));
  fitInnerNodes(
      commands, clusters.tree,
      [&](std::uint32_t firstTreelet, std::uint32_t count) { bind(nodes_, firstTreelet, count); },
      trees.count);
}

}  // namespace opaline::passes
