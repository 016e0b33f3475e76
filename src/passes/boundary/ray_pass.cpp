#include "passes/boundary/ray_pass.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include "gpu/device.h"
#include "gpu/transfer.h"
#include "passes/mechanics.h"
#include "shaders/shared/rays.h"

namespace opaline::passes {

namespace {

std::size_t nodesOf(const Surfels& surfels) {
  return surfels.firstOfHeight.empty() ? 0 : surfels.firstOfHeight.back();
}

glm::vec4 cornerAt(const core::RestSurface& surface, const surfels::Piece& piece,
                   std::size_t corner) {
  const Triangle& triangle = surface.triangles[piece.triangle];
  const auto [v, w] = piece.corners[corner];
  glm::vec4 place{0};
  const float parts[] = {1 - v - w, v, w};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& vertex = surface.positionsMm[triangle[i]];
    place += parts[i] * glm::vec4(vertex[0], vertex[1], vertex[2], 0);
  }
  return place;
}

// Corners only: what else a RayPiece has, frames write.
std::vector<shared::RayPiece> piecesAt(const surfels::SurfelDivision& made,
                                       const core::RestSurface& surface) {
  std::vector<shared::RayPiece> pieces;
  pieces.reserve(made.pieces.size());
  for (const surfels::Piece& piece : made.pieces)
    pieces.push_back(
        {cornerAt(surface, piece, 0), cornerAt(surface, piece, 1), cornerAt(surface, piece, 2)});
  return pieces;
}

}  // namespace

RayPass::RayPass(gpu::Device& device)
    : leaves_(device, "leaves for rays", {.forQueries = device.hasRayQueries()}),
      nodes_(device, "nodes for rays") {}

RayHierarchy RayPass::makeBoxes(gpu::Device& device, const Surfels& surfels) {
  const std::size_t pieces = std::size_t{surfels.count} * surfels.piecesPerSurfel;
  RayHierarchy hierarchy;
  hierarchy.corners = makeRoom<shared::RayPiece>(device, "pieces for rays", pieces);
  hierarchy.boxes = makeRoom<shared::RayBox>(device, "boxes for rays", nodesOf(surfels));
  return hierarchy;
}

RayHierarchy RayPass::makeHierarchy(gpu::Device& device, const Surfels& surfels,
                                    const surfels::SurfelDivision& made,
                                    const core::RestSurface& rest) {
  if (!device.hasRayQueries()) return makeBoxes(device, surfels);
  RayHierarchy hierarchy;
  hierarchy.corners = gpu::makeBuffer(device, "pieces for rays", piecesAt(made, rest),
                                      roomUsage | gpu::AccelerationStructure::cornersUsage);
  hierarchy.boxes = makeRoom<shared::RayBox>(device, "boxes for rays", nodesOf(surfels));
  std::vector<std::uint32_t> firstPiece;
  for (const std::uint32_t surfel : made.firstOfObject)
    firstPiece.push_back(surfel * made.piecesPerSurfel);
  hierarchy.structure =
      gpu::AccelerationStructure(device, "surface for rays", hierarchy.corners, firstPiece);
  return hierarchy;
}

void RayPass::record(gpu::CommandList& commands, DeformedMesh& mesh, Surfels& surfels,
                     RayHierarchy& hierarchy) const {
  commands.beginPass("rays");
  recordPieces(commands, mesh, surfels, hierarchy);
  if (hierarchy.structure)
    commands.build(hierarchy.structure, hierarchy.corners, true);
  else
    recordNodes(commands, surfels, hierarchy);
  commands.endPass();
}

void RayPass::recordBoxes(gpu::CommandList& commands, Surfels& surfels,
                          RayHierarchy& hierarchy) const {
  if (!hierarchy.structure) return;
  commands.beginPass("rays");
  recordNodes(commands, surfels, hierarchy);
  commands.endPass();
}

void RayPass::recordPieces(gpu::CommandList& commands, DeformedMesh& mesh, Surfels& surfels,
                           RayHierarchy& hierarchy) const {
  const NodeRange leaves{surfels.firstOfHeight[0],
                         surfels.firstOfHeight[1] - surfels.firstOfHeight[0]};
  commands.bind(
      leaves_,
      {.links = surfels.links,
       .byHeight = surfels.byHeight,
       .positions = mesh.positions,
       .pieces = surfels.pieces,
       .rayPieces = hierarchy.corners,
       .boxes = hierarchy.boxes},
      {.first = leaves.first, .count = leaves.count, .piecesPerSurfel = surfels.piecesPerSurfel});
  commands.dispatchLinear(leaves.count);
}

void RayPass::recordNodes(gpu::CommandList& commands, Surfels& surfels,
                          RayHierarchy& hierarchy) const {
  forEachHeight(surfels.firstOfHeight, [&](std::size_t height, const NodeRange& range) {
    if (height == 0) return;  // leaves, whose boxes their pieces have made
    commands.bind(
        nodes_, {.links = surfels.links, .byHeight = surfels.byHeight, .boxes = hierarchy.boxes},
        {.first = range.first, .count = range.count, .piecesPerSurfel = surfels.piecesPerSurfel});
    commands.dispatchLinear(range.count);
  });
}

}  // namespace opaline::passes
