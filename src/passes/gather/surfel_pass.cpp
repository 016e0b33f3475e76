#include "passes/gather/surfel_pass.h"

#include <cstddef>
#include <numeric>
#include <vector>

#include "gpu/device.h"
#include "gpu/transfer.h"
#include "passes/mechanics.h"
#include "shaders/shaders.h"
#include "shaders/shared/mesh.h"
#include "shaders/shared/surfels.h"

namespace opaline::passes {

namespace {

using gpu::Binding;
using gpu::BindingType;

static_assert(surfels::Tree::leafBit == shared::leafBit);
static_assert(surfels::Tree::setBit == shared::setBit);
static_assert(surfels::Tree::countShift == shared::leafCountShift);

constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;

struct SurfelCounts {
  std::uint32_t surfels;
  std::uint32_t piecesPerSurfel;
};

std::vector<shared::SurfelPiece> packPieces(const surfels::SurfelDivision& made,
                                            const core::RestSurface& surface) {
  std::vector<shared::SurfelPiece> packed;
  packed.reserve(made.pieces.size());
  for (const surfels::Piece& piece : made.pieces) {
    const Triangle& triangle = surface.triangles[piece.triangle];
    packed.push_back({.a = triangle[0],
                      .b = triangle[1],
                      .c = triangle[2],
                      .object = surface.objectOfTriangle[piece.triangle],
                      .v0 = piece.corners[0][0],
                      .w0 = piece.corners[0][1],
                      .v1 = piece.corners[1][0],
                      .w1 = piece.corners[1][1],
                      .v2 = piece.corners[2][0],
                      .w2 = piece.corners[2][1],
                      .fraction = piece.fraction});
  }
  return packed;
}

std::vector<shared::AtlasCorner> cornersOf(const surfels::SurfelDivision& made,
                                           const core::RestSurface& surface) {
  std::vector<shared::AtlasCorner> corners(made.count());
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners[i].object = surface.objectOfTriangle[made.pieces[i * made.piecesPerSurfel].triangle];
  return corners;
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
      gather_(device,
              gpu::ComputePipelineOptions{
                  .name = "surfels",
                  .shader = shaders::gather_surfels_comp,
                  .bindings = {{0, BindingType::UniformBuffer},
                               {1, BindingType::StorageBuffer},
                               {2, BindingType::StorageBuffer},
                               {3, BindingType::StorageBuffer},
                               {4, BindingType::StorageBuffer},
                               {5, BindingType::StorageBuffer},
                               {6, BindingType::SampledImage},
                               {7, BindingType::SampledImage},
                               {8, BindingType::StorageBuffer},
                               {9, BindingType::StorageBuffer},
                               {10, BindingType::StorageBuffer}},
                  .pushConstantBytes = sizeof(SurfelCounts),
              }),
      leaves_(device,
              gpu::ComputePipelineOptions{
                  .name = "leaves of the tree",
                  .shader = shaders::gather_tree_leaves_comp,
                  .bindings = slots(5),
                  .pushConstantBytes = sizeof(NodeRange),
              }),
      nodes_(device, gpu::ComputePipelineOptions{
                         .name = "nodes of the tree",
                         .shader = shaders::gather_tree_nodes_comp,
                         .bindings = slots(4),
                         .pushConstantBytes = sizeof(NodeRange),
                     }) {}

Surfels SurfelPass::makeSurfels(gpu::Device& device, const surfels::SurfelDivision& made,
                                const core::RestSurface& surface) {
  Surfels surfels;
  surfels.count = made.count();
  surfels.piecesPerSurfel = made.piecesPerSurfel;
  surfels.firstOfHeight = made.tree.firstOfHeight;
  surfels.pieces = gpu::makeBuffer(device, "pieces of surfels", packPieces(made, surface), storage);
  surfels.links = gpu::makeBuffer(device, "links of the tree", made.tree.links, storage);
  surfels.byHeight = gpu::makeBuffer(device, "nodes by height", made.tree.byHeight, storage);
  surfels.vertexOrder = gpu::makeBuffer(device, "order of vertices", made.vertexOrder, storage);
  surfels.sources = makeRoom<shared::Source>(device, "sources",
                                             std::size_t{shared::sourcesPerSurfel} * surfels.count);
  surfels.normals = makeRoom<shared::vec4>(device, "normals of surfels", surfels.count);
  surfels.places = makeRoom<shared::vec4>(device, "places of surfels", surfels.count);
  surfels.corners =
      gpu::makeBuffer(device, "objects of surfels", cornersOf(made, surface), storage);
  surfels.order = gpu::makeBuffer(device, "order of surfels", inOrder(surfels.count), storage);
  surfels.nodes = makeRoom<shared::TreeNode>(device, "tree", made.tree.links.size());
  surfels.boxes = makeRoom<shared::NodeBox>(device, "boxes of the tree", made.tree.links.size());
  return surfels;
}

void SurfelPass::record(gpu::CommandList& commands, const Inputs& inputs, Surfels& surfels) const {
  commands.beginPass("gather");
  gather(commands, inputs, surfels);
  commands.endPass();
  commands.beginPass("tree");
  fitTree(commands, surfels);
  commands.endPass();
}

void SurfelPass::gather(gpu::CommandList& commands, const Inputs& inputs, Surfels& surfels) const {
  commands.bind(gather_);
  commands.bindResources(
      {Binding::uniform(0, inputs.frame.data), Binding::read(1, inputs.mesh.positions),
       Binding::read(2, inputs.mesh.normals), Binding::read(3, surfels.pieces),
       Binding::read(4, inputs.tables.objects), Binding::read(5, inputs.tables.media),
       Binding::sampled(6, inputs.shadows.depth, nearest_),
       Binding::sampled(7, inputs.tables.ambientCubes, linear_), Binding::write(8, surfels.sources),
       Binding::write(9, surfels.normals), Binding::write(10, surfels.places)});
  commands.pushConstants(SurfelCounts{surfels.count, surfels.piecesPerSurfel});
  commands.dispatchLinear(surfels.count);
}

void SurfelPass::fitTree(gpu::CommandList& commands, Surfels& surfels) const {
  forEachHeight(surfels.firstOfHeight, [&](std::size_t height, const NodeRange& range) {
    commands.bind(height == 0 ? leaves_ : nodes_);
    if (height == 0)
      commands.bindResources({Binding::read(0, surfels.links), Binding::read(1, surfels.byHeight),
                              Binding::read(2, surfels.sources), Binding::write(3, surfels.nodes),
                              Binding::write(4, surfels.boxes)});
    else
      commands.bindResources({Binding::read(0, surfels.links), Binding::read(1, surfels.byHeight),
                              Binding::write(2, surfels.nodes), Binding::write(3, surfels.boxes)});
    commands.pushConstants(range);
    commands.dispatchLinear(range.count);
  });
}

}  // namespace opaline::passes
