#include "passes/boundary/ray_pass.h"

#include <cstddef>
#include <cstdint>

#include "gpu/device.h"
#include "shaders/shaders.h"
#include "shaders/shared/rays.h"

namespace opaline::passes {

namespace {

using gpu::Binding;
using gpu::BindingType;

struct NodeRange {
  std::uint32_t first;
  std::uint32_t count;
  std::uint32_t piecesPerSurfel;
};

template <typename T>
gpu::Buffer makeRoom(gpu::Device& device, const char* name, std::size_t count) {
  return {device,
          {.name = name,
           .bytes = count * sizeof(T),
           .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT}};
}

}  // namespace

RayPass::RayPass(gpu::Device& device)
    : leaves_(device,
              gpu::ComputePipelineOptions{
                  .name = "leaves for rays",
                  .shader = shaders::boundary_ray_leaves_comp,
                  .bindings = {{0, BindingType::StorageBuffer},
                               {1, BindingType::StorageBuffer},
                               {2, BindingType::StorageBuffer},
                               {3, BindingType::StorageBuffer},
                               {4, BindingType::StorageBuffer},
                               {5, BindingType::StorageBuffer}},
                  .pushConstantBytes = sizeof(NodeRange),
              }),
      nodes_(device, gpu::ComputePipelineOptions{
                         .name = "nodes for rays",
                         .shader = shaders::boundary_ray_nodes_comp,
                         .bindings = {{0, BindingType::StorageBuffer},
                                      {1, BindingType::StorageBuffer},
                                      {2, BindingType::StorageBuffer}},
                         .pushConstantBytes = sizeof(NodeRange),
                     }) {}

RayHierarchy RayPass::makeHierarchy(gpu::Device& device, const Surfels& surfels) {
  const std::size_t pieces = std::size_t{surfels.count} * surfels.piecesPerSurfel;
  const std::size_t nodes = surfels.firstOfHeight.empty() ? 0 : surfels.firstOfHeight.back();
  RayHierarchy hierarchy;
  hierarchy.corners =
      makeRoom<shared::RayPiece>(device, "pieces for rays", pieces > 0 ? pieces : 1);
  hierarchy.boxes = makeRoom<shared::RayBox>(device, "boxes for rays", nodes > 0 ? nodes : 1);
  return hierarchy;
}

void RayPass::record(gpu::CommandList& commands, DeformedMesh& mesh, Surfels& surfels,
                     RayHierarchy& hierarchy) const {
  const auto range = [&](std::size_t height) {
    const std::uint32_t first = surfels.firstOfHeight[height];
    return NodeRange{first, surfels.firstOfHeight[height + 1] - first, surfels.piecesPerSurfel};
  };
  commands.beginPass("rays");
  commands.bind(leaves_);
  commands.bindResources({Binding::read(0, surfels.links), Binding::read(1, surfels.byHeight),
                          Binding::read(2, mesh.positions), Binding::read(3, surfels.pieces),
                          Binding::write(4, hierarchy.corners),
                          Binding::write(5, hierarchy.boxes)});
  commands.pushConstants(range(0));
  commands.dispatchLinear(range(0).count);
  commands.bind(nodes_);
  for (std::size_t height = 1; height + 1 < surfels.firstOfHeight.size(); ++height) {
    commands.bindResources({Binding::read(0, surfels.links), Binding::read(1, surfels.byHeight),
                            Binding::write(2, hierarchy.boxes)});
    commands.pushConstants(range(height));
    commands.dispatchLinear(range(height).count);
  }
  commands.endPass();
}

}  // namespace opaline::passes
