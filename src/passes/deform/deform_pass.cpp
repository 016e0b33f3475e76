#include "passes/deform/deform_pass.h"

#include <cstdint>

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "shaders/shaders.h"

namespace opaline::passes {

namespace {

using gpu::Binding;

std::vector<gpu::BindingSlot> uniformAndStorageSlots(std::uint32_t count) {
  std::vector<gpu::BindingSlot> made = slots(count);
  made.front().type = gpu::BindingType::UniformBuffer;
  return made;
}

struct ReplaceConstants {
  std::uint32_t offset;
  std::uint32_t stride;
  std::uint32_t first;
  std::uint32_t count;
};

}  // namespace

DeformPass::DeformPass(gpu::Device& device)
    : replace_(device, gpu::ComputePipelineOptions{.name = "given positions",
                                                   .shader = shaders::deform_replace_comp,
                                                   .bindings = slots(2),
                                                   .pushConstantBytes = sizeof(ReplaceConstants)}),
      vertices_(device, gpu::ComputePipelineOptions{.name = "deform vertices",
                                                    .shader = shaders::deform_vertices_comp,
                                                    .bindings = uniformAndStorageSlots(13)}),
      normals_(device, gpu::ComputePipelineOptions{.name = "deform normals",
                                                   .shader = shaders::deform_normals_comp,
                                                   .bindings = slots(6),
                                                   .pushConstantBytes = sizeof(std::uint32_t)}) {}

void DeformPass::replace(gpu::CommandList& commands, gpu::Buffer& given, std::uint32_t offset,
                         std::uint32_t stride, std::uint32_t first, std::uint32_t count,
                         Motion& motion) const {
  commands.bind(replace_);
  commands.bindResources({Binding::read(0, given), Binding::write(1, motion.replaced)});
  commands.pushConstants(ReplaceConstants{offset, stride, first, count});
  commands.dispatchLinear(count);
}

void DeformPass::record(gpu::CommandList& commands, Motion& motion, DeformedMesh& mesh) const {
  constexpr std::uint32_t emptyBounds = 0xffffffffU;
  commands.fill(mesh.bounds, emptyBounds);
  commands.bind(vertices_);
  commands.bindResources({Binding::uniform(0, motion.frame), Binding::read(1, motion.rest),
                          Binding::read(2, motion.firstDelta), Binding::read(3, motion.deltas),
                          Binding::read(4, motion.weights), Binding::read(5, motion.firstInfluence),
                          Binding::read(6, motion.influences), Binding::read(7, motion.matrices),
                          Binding::read(8, motion.objects), Binding::read(9, motion.replaced),
                          Binding::write(10, mesh.positions), Binding::write(11, mesh.normals),
                          Binding::write(12, mesh.bounds)});
  commands.dispatchLinear(mesh.vertexCount);
  if (!motion.normalsFromMesh) return;
  commands.bind(normals_);
  commands.bindResources({Binding::read(0, motion.rest), Binding::read(1, motion.objects),
                          Binding::read(2, motion.edgeRange), Binding::read(3, motion.edges),
                          Binding::read(4, mesh.positions), Binding::write(5, mesh.normals)});
  commands.pushConstants(mesh.vertexCount);
  commands.dispatchLinear(mesh.vertexCount);
}

}  // namespace opaline::passes
