#include "passes/boundary/ray_pass.h"

#include <cstddef>
#include <cstdint>

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "shaders/shaders.h"
#include "shaders/shared/rays.h"

namespace opaline::passes {

namespace {

using gpu::Binding;

struct PieceNodes {
  NodeRange range;
  std::uint32_t piecesPerSurfel;
};

}  // namespace

RayPass::RayPass(gpu::Device& device)
    : leaves_(device,
              gpu::ComputePipelineOptions{
                  .name = "leaves for rays",
                  .shader = shaders::boundary_ray_leaves_comp,
                  .bindings = slots(6),
                  .pushConstantBytes = sizeof(PieceNodes),
              }),
      nodes_(device, gpu::ComputePipelineOptions{
                         .name = "nodes for rays",
                         .shader = shaders::boundary_ray_nodes_comp,
                         .bindings = slots(3),
                         .pushConstantBytes = sizeof(PieceNodes),
                     }) {}

RayHierarchy RayPass::makeHierarchy(gpu::Device& device, const Surfels& surfels) {
  const std::size_t pieces = std::size_t{surfels.count} * surfels.piecesPerSurfel;
  const std::size_t nodes = surfels.firstOfHeight.empty() ? 0 : surfels.firstOfHeight.back();
  RayHierarchy hierarchy;
  hierarchy.corners = makeRoom<shared::RayPiece>(device, "pieces for rays", pieces);
  hierarchy.boxes = makeRoom<shared::RayBox>(device, "boxes for rays", nodes);
  return hierarchy;
}

void RayPass::record(gpu::CommandList& commands, DeformedMesh& mesh, Surfels& surfels,
                     RayHierarchy& hierarchy) const {
  commands.beginPass("rays");
  forEachHeight(surfels.firstOfHeight, [&](std::size_t height, const NodeRange& range) {
    commands.bind(height == 0 ? leaves_ : nodes_);
    if (height == 0)
      commands.bindResources({Binding::read(0, surfels.links), Binding::read(1, surfels.byHeight),
                              Binding::read(2, mesh.positions), Binding::read(3, surfels.pieces),
                              Binding::write(4, hierarchy.corners),
                              Binding::write(5, hierarchy.boxes)});
    else
      commands.bindResources({Binding::read(0, surfels.links), Binding::read(1, surfels.byHeight),
                              Binding::write(2, hierarchy.boxes)});
    commands.pushConstants(PieceNodes{range, surfels.piecesPerSurfel});
    commands.dispatchLinear(range.count);
  });
  commands.endPass();
}

}  // namespace opaline::passes
