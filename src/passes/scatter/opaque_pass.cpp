#include "passes/scatter/opaque_pass.h"

#include <cstdint>

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "passes/seen_parts.h"
#include "shaders/shared/boundary.h"

namespace opaline::passes {

OpaquePass::OpaquePass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      cutPieces_(device, "holes of opaque bodies"),
      shares_(device, "shares of opaque clusters"),
      clusters_(device, "opaque clusters"),
      vertices_(device, "opaque vertices"),
      fragments_(device, "opaque fragments"),
      behind_(device, "behind opaque fragments") {}

void OpaquePass::makeShares(gpu::Device& device, DeformedMesh& mesh, Surfels& surfels,
                            Clusters& clusters, OpaqueTables& opaque, bool any,
                            SceneTables& tables) const {
  const std::uint32_t count = any ? clusters.count : 0;
  tables.opaqueShares = makeRoom<shared::OpaqueShare>(device, "shares of opaque clusters", count);
  tables.opaqueExitances = makeRoom<shared::vec4>(device, "exitance of opaque clusters", count);
  if (count == 0) return;
  gpu::CommandList commands(device, "shares of opaque clusters");
  commands.begin();
  recordShares(commands, mesh, surfels, clusters, opaque, tables);
  commands.submit();
}

void OpaquePass::recordShares(gpu::CommandList& commands, DeformedMesh& mesh, Surfels& surfels,
                              Clusters& clusters, OpaqueTables& opaque, SceneTables& tables) const {
  commands.beginPass("opaque");
  commands.bind(shares_,
                {.surfaceMaterials = surfaceMaterials(opaque),
                 .objects = tables.objects,
                 .media = tables.media,
                 .ranges = clusters.ranges,
                 .pieces = surfels.pieces,
                 .shares = tables.opaqueShares,
                 .objectOf = mesh.objectOf},
                {.clusterCount = clusters.count, .piecesPerSurfel = surfels.piecesPerSurfel});
  commands.dispatchLinear(clusters.count);
  commands.endPass();
}

void OpaquePass::cutOut(gpu::Device& device, Surfels& surfels, OpaqueTables& opaque,
                        SceneTables& tables) const {
  const std::uint32_t pieces = surfels.count * surfels.piecesPerSurfel;
  gpu::CommandList commands(device, "holes of opaque bodies");
  commands.begin();
  commands.bind(cutPieces_,
                {.surfaceMaterials = surfaceMaterials(opaque),
                 .objects = tables.objects,
                 .media = tables.media,
                 .pieces = surfels.pieces},
                {.pieceCount = pieces});
  commands.dispatchLinear(pieces);
  commands.submit();
}

void OpaquePass::overClusters(gpu::CommandList& commands, const Inputs& inputs, From from,
                              int bounces, Clusters& clusters) const {
  commands.beginPass("opaque");
  commands.bind(clusters_,
                {.frame = inputs.frame.data,
                 .shares = inputs.tables.opaqueShares,
                 .opaqueExitances = inputs.tables.opaqueExitances,
                 .ranges = clusters.ranges,
                 .clusters = clusters.clusters,
                 .entries = clusters.entries,
                 .skyShares = clusters.skyShares,
                 .entered = clusters.entered,
                 .latest = clusters.latest,
                 .enteredBefore = clusters.enteredBefore,
                 .irradiances = clusters.exitances,
                 .stillToCome = clusters.power,
                 .objects = inputs.tables.objects,
                 .clusterNodes = clusters.nodes},
                {.clusterCount = clusters.count,
                 .from = static_cast<std::uint32_t>(from),
                 .bounces = static_cast<std::uint32_t>(bounces)});
  commands.dispatchLinear(clusters.count, roundsOfWalk);
  commands.endPass();
}

void OpaquePass::overVertices(gpu::CommandList& commands, const Inputs& inputs, ScatterSite site,
                              const Places& vertices) const {
  commands.beginPass("opaque");
  commands.bind(vertices_.of(inputs.between, inputs.tables),
                {.lightThrough = lightThrough(inputs.between, inputs.tables),
                 .frame = inputs.frame.data,
                 .positions = vertices.positions,
                 .normals = vertices.normals,
                 .objects = inputs.tables.objects,
                 .media = inputs.tables.media,
                 .shadowMaps = {inputs.shadows.depth, nearest_},
                 .objectOf = vertices.objectOf,
                 .irradiances = vertices.exitances},
                {.vertexCount = vertices.count,
                 .sides = inputs.tables.sidesOfVertices(),
                 .site = site,
                 .nodeCount = inputs.between.surfels.tree.nodeCount,
                 .piecesPerSurfel = inputs.between.surfels.piecesPerSurfel});
  commands.dispatchLinear(inputs.tables.sidesOfVertices() * vertices.count,
                          inputs.between.rounds());
  commands.endPass();
}

void OpaquePass::overFragments(gpu::CommandList& commands, const Inputs& inputs,
                               OpaqueTables& opaque, ScatterSite site,
                               const SeenSurfaces& seen) const {
  commands.beginPass("opaque");
  dispatchParts(commands, seen.surfaces, fragments_.of(inputs.between, inputs.tables),
                {.listedPlaces = listedPlaces(seen, nearest_),
                 .lightThrough = lightThrough(inputs.between, inputs.tables),
                 .surfaceMaterials = surfaceMaterials(opaque),
                 .irradiances = seen.surfaces.light,
                 .objects = inputs.tables.objects,
                 .media = inputs.tables.media,
                 .shadowMaps = {inputs.shadows.depth, nearest_},
                 .materials = seen.surfaces.materials},
                {.first = 0,
                 .site = site,
                 .nodeCount = inputs.between.surfels.tree.nodeCount,
                 .piecesPerSurfel = inputs.between.surfels.piecesPerSurfel});
  commands.endPass();
}

void OpaquePass::behindFragments(gpu::CommandList& commands, const Inputs& inputs,
                                 const SeenSurfaces& seen) const {
  Clusters& clusters = inputs.between.clusters;
  commands.beginPass("opaque");
  dispatchParts(commands, seen.surfaces, behind_.of(inputs.between, inputs.tables),
                {.listedPlaces = listedPlaces(seen, nearest_),
                 .lightThrough = lightThrough(inputs.between, inputs.tables),
                 .objects = inputs.tables.objects,
                 .media = inputs.tables.media,
                 .shadowMaps = {inputs.shadows.depth, nearest_},
                 .clusterNodes = clusters.nodes,
                 .exitances = clusters.exitances,
                 .means = clusters.means,
                 .materials = seen.surfaces.materials},
                {.first = 0,
                 .nodeCount = inputs.between.surfels.tree.nodeCount,
                 .piecesPerSurfel = inputs.between.surfels.piecesPerSurfel});
  commands.endPass();
}

}  // namespace opaline::passes
