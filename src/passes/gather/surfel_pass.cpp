#include "passes/gather/surfel_pass.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "gpu/device.h"
#include "gpu/transfer.h"
#include "passes/fitted_tree.h"
#include "passes/mechanics.h"
#include "shaders/shared/surfels.h"

namespace opaline::passes {

namespace {

static_assert(surfels::Tree::leafBit == shared::leafBit);
static_assert(surfels::Tree::setBit == shared::setBit);
static_assert(surfels::Tree::countShift == shared::leafCountShift);

constexpr VkBufferUsageFlags surfelBuffer = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;

std::vector<shared::SurfelPiece> packPieces(const surfels::SurfelDivision& made,
                                            const core::RestSurface& surface) {
  std::vector<shared::SurfelPiece> packed;
  packed.reserve(made.pieces.size());
  for (const surfels::Piece& piece : made.pieces) {
    const Triangle& triangle = surface.triangles[piece.triangle];
    packed.push_back({.a = triangle[0] | shared::setBit,
                      .b = triangle[1] | shared::setBit,
                      .c = triangle[2] | shared::setBit,
                      .object = surface.objectOfTriangle[piece.triangle] | shared::setBit,
                      .v0 = piece.corners[0][0],
                      .w0 = piece.corners[0][1],
                      .v1 = piece.corners[1][0],
                      .w1 = piece.corners[1][1],
                      .v2 = piece.corners[2][0],
                      .w2 = piece.corners[2][1],
                      .fraction = piece.fraction,
                      .areaMm2 = piece.fraction *
                                 static_cast<float>(surfels::areaMm2(surface, piece.triangle))});
  }
  return packed;
}

// For each piece, its triangle of the mesh.
std::vector<std::uint32_t> trianglesOf(const surfels::SurfelDivision& made,
                                       const surfels::Linings& linings) {
  std::vector<std::uint32_t> triangles;
  triangles.reserve(made.pieces.size());
  for (const surfels::Piece& piece : made.pieces) {
    const bool isLining = piece.triangle >= linings.firstTriangle();
    triangles.push_back(isLining
                            ? linings.triangleOfSolid()[piece.triangle - linings.firstTriangle()]
                            : piece.triangle);
  }
  return triangles;
}

// Where each triangle's pieces begin, then all pieces in the order of their triangles.
std::vector<std::uint32_t> piecesOfTriangles(const surfels::SurfelDivision& made,
                                             const core::RestSurface& surface) {
  const std::size_t offsets = surface.triangles.size() + 1;
  std::vector<std::uint32_t> packed(offsets + made.pieces.size(), 0);
  for (const surfels::Piece& piece : made.pieces) ++packed[piece.triangle + 1];
  const auto list = packed.begin() + static_cast<std::ptrdiff_t>(offsets);
  std::inclusive_scan(packed.begin(), list, packed.begin());
  std::vector<std::uint32_t> next(packed.begin(), list);
  for (std::uint32_t i = 0; i < made.pieces.size(); ++i) list[next[made.pieces[i].triangle]++] = i;
  return packed;
}

std::vector<std::uint32_t> objectsOf(const surfels::SurfelDivision& made,
                                     const core::RestSurface& surface) {
  std::vector<std::uint32_t> objects(made.count());
  for (std::size_t i = 0; i < objects.size(); ++i)
    objects[i] = surface.objectOfTriangle[made.pieces[i * made.piecesPerSurfel].triangle];
  return objects;
}

std::vector<std::uint32_t> inOrder(std::uint32_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  return order;
}

}  // namespace

SurfelPass::SurfelPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      linear_(device, gpu::Filter::Linear),
      gather_{{device, "surfels", {.withNormals = 0}}, {device, "surfels", {.withNormals = 1}}},
      leaves_(device, "leaves of the tree"),
      nodes_(device, "nodes of the tree") {}

Surfels SurfelPass::makeSurfels(gpu::Device& device, const surfels::SurfelDivision& made,
                                const core::RestSurface& surface, bool keepsTriangles,
                                const surfels::Linings& linings) {
  Surfels surfels;
  surfels.count = made.count();
  surfels.piecesPerSurfel = made.piecesPerSurfel;
  surfels.pieces =
      gpu::makeBuffer(device, "pieces of surfels", packPieces(made, surface), roomUsage);
  if (keepsTriangles)
    surfels.triangleOfPiece =
        gpu::makeBuffer(device, "triangles of pieces", trianglesOf(made, linings), surfelBuffer);
  surfels.triangleCount = static_cast<std::uint32_t>(surface.triangles.size());
  surfels.piecesOfTriangles = gpu::makeBuffer(device, "pieces of triangles",
                                              piecesOfTriangles(made, surface), surfelBuffer);
  surfels.tree = makeFittedTree(device, made.tree);
  surfels.vertexOrder =
      gpu::makeBuffer(device, "order of vertices", made.vertexOrder, surfelBuffer);
  surfels.sources = makeRoom<shared::Source>(device, "sources",
                                             std::size_t{shared::sourcesPerSurfel} * surfels.count);
  surfels.normals = makeRoom<shared::vec4>(device, "normals of surfels", surfels.count);
  surfels.skyShares = makeRoom<shared::vec4>(device, "share of the sky of surfels", surfels.count);
  surfels.places = makeRoom<shared::vec4>(device, "places of surfels", surfels.count);
  surfels.objectOf =
      gpu::makeBuffer(device, "objects of surfels", objectsOf(made, surface), surfelBuffer);
  surfels.order = gpu::makeBuffer(device, "order of surfels", inOrder(surfels.count), surfelBuffer);
  makeRoomForLights(device, 0, surfels);
  surfels.nodes = makeRoom<shared::TreeNode>(device, "tree", made.tree.links.size());
  surfels.boxes = makeRoom<shared::NodeBox>(device, "boxes of the tree", made.tree.links.size());
  return surfels;
}

void SurfelPass::makeRoomForLights(gpu::Device& device, std::uint32_t lights, Surfels& surfels) {
  const std::size_t words = std::size_t{lights} * surfels.piecesPerSurfel * surfels.count;
  surfels.visibilities = {};  // freed before memory for the next is allocated
  surfels.visibilities =
      gpu::Buffer(device, {.name = "visibility on surfels",
                           .bytes = std::max<std::size_t>(words, 1) * sizeof(std::uint32_t),
                           .usage = surfelBuffer});
  surfels.lights = lights;
}

void SurfelPass::gather(gpu::CommandList& commands, const Inputs& inputs, Surfels& surfels) const {
  commands.beginPass("gather");
  commands.bind(gather_.of(inputs.tables.surfaces.anyNormals),
                {.frame = inputs.frame.data,
                 .positions = inputs.mesh.positions,
                 .normals = inputs.mesh.normals,
                 .pieces = surfels.pieces,
                 .objects = inputs.tables.objects,
                 .media = inputs.tables.media,
                 .shadowMaps = {inputs.shadows.depth, nearest_},
                 .skyIrradiance = {inputs.sky.irradiance, linear_},
                 .sources = surfels.sources,
                 .surfelNormals = surfels.normals,
                 .places = surfels.places,
                 .visibilities = surfels.visibilities,
                 .skyShares = surfels.skyShares,
                 .tilts = inputs.tables.surfaces.tilts},
                {.surfelCount = surfels.count,
                 .piecesPerSurfel = surfels.piecesPerSurfel,
                 .keepsVisibility = inputs.keepsVisibility,
                 .takesSky = inputs.takesSky});
  commands.dispatchLinear(surfels.count);
  commands.endPass();
}

void SurfelPass::fitTree(gpu::CommandList& commands, Surfels& surfels) const {
  commands.beginPass("tree");
  commands.bind(leaves_,
                {.links = surfels.tree.links,
                 .leafNodes = surfels.tree.leafNodes,
                 .sources = surfels.sources,
                 .nodes = surfels.nodes,
                 .boxes = surfels.boxes},
                {.leafCount = surfels.tree.leafCount});
  commands.dispatchLinear(surfels.tree.leafCount);
  fitInnerNodes(commands, surfels.tree, [&](std::uint32_t first, std::uint32_t count) {
    commands.bind(nodes_,
                  {.treeletOrder = treeletOrder(surfels.tree),
                   .nodes = surfels.nodes,
                   .boxes = surfels.boxes},
                  {.firstTreelet = first, .treeletCount = count});
  });
  commands.endPass();
}

}  // namespace opaline::passes
