#include "passes/boundary/ray_pass.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include "gpu/device.h"
#include "gpu/transfer.h"
#include "passes/fitted_tree.h"
#include "passes/mechanics.h"
#include "shaders/shared/rays.h"

namespace opaline::passes {

namespace {

gpu::Buffer makeRoomForBoxes(gpu::Device& device, std::uint32_t nodes) {
  static_assert(sizeof(shared::RayUnits) == 2 * sizeof(shared::RayBox));
  return makeRoom<shared::RayBox>(device, "boxes for rays", std::size_t{nodes} + 2);
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

// Sets only the corners; frames write the other members of a RayPiece.
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
  hierarchy.boxes = makeRoomForBoxes(device, surfels.tree.nodeCount);
  return hierarchy;
}

RayHierarchy RayPass::makeHierarchy(gpu::Device& device, const Surfels& surfels,
                                    const surfels::SurfelDivision& made,
                                    const core::RestSurface& rest,
                                    std::span<const std::uint32_t> firstObjectOfBody) {
  if (!device.hasRayQueries()) return makeBoxes(device, surfels);
  RayHierarchy hierarchy;
  hierarchy.corners = gpu::makeBuffer(device, "pieces for rays", piecesAt(made, rest),
                                      roomUsage | gpu::AccelerationStructure::cornersUsage);
  hierarchy.boxes = makeRoomForBoxes(device, surfels.tree.nodeCount);
  std::vector<std::uint32_t> firstPiece;
  for (const std::uint32_t surfel : made.firstOfObject)
    firstPiece.push_back(surfel * made.piecesPerSurfel);
  hierarchy.structure = gpu::AccelerationStructure(device, "surface for rays", hierarchy.corners,
                                                   firstPiece, firstObjectOfBody);
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
  const std::uint32_t leaves = surfels.tree.leafCount;
  commands.bind(leaves_,
                {.links = surfels.tree.links,
                 .leafNodes = surfels.tree.leafNodes,
                 .positions = mesh.positions,
                 .pieces = surfels.pieces,
                 .rayPieces = hierarchy.corners,
                 .boxes = hierarchy.boxes,
                 .bounds = mesh.bounds},
                {.leafCount = leaves, .piecesPerSurfel = surfels.piecesPerSurfel});
  commands.dispatchLinear(leaves);
}

void RayPass::recordNodes(gpu::CommandList& commands, Surfels& surfels,
                          RayHierarchy& hierarchy) const {
  fitInnerNodes(commands, surfels.tree, [&](std::uint32_t first, std::uint32_t count) {
    commands.bind(nodes_, {.treeletOrder = treeletOrder(surfels.tree), .boxes = hierarchy.boxes},
                  {.firstTreelet = first, .treeletCount = count});
  });
}

}  // namespace opaline::passes
