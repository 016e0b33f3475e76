#include "passes/deform/deform_pass.h"

#include <cstdint>

#include "gpu/device.h"
#include "passes/mechanics.h"

namespace opaline::passes {

DeformPass::DeformPass(gpu::Device& device)
    : replace_(device, "given positions"),
      vertices_(device, "deform vertices"),
      normals_(device, "deform normals") {}

void DeformPass::replace(gpu::CommandList& commands, gpu::Buffer& given, std::uint32_t offset,
                         std::uint32_t stride, std::uint32_t first, std::uint32_t count,
                         const Vec3& originMm, Motion& motion) const {
  commands.bind(replace_, {.given = given, .replaced = motion.replaced},
                {.offset = offset,
                 .stride = stride,
                 .first = first,
                 .count = count,
                 .origin = shared::vec4(originMm[0], originMm[1], originMm[2], 0)});
  commands.dispatchLinear(count);
}

void DeformPass::record(gpu::CommandList& commands, Motion& motion, DeformedMesh& mesh) const {
  constexpr std::uint32_t emptyBounds = 0xffffffffU;
  commands.fill({mesh.bounds}, emptyBounds);
  commands.bind(vertices_, {.frame = motion.frame,
                            .rest = motion.rest,
                            .firstDelta = motion.firstDelta,
                            .deltas = motion.deltas,
                            .weights = motion.weights,
                            .firstInfluence = motion.firstInfluence,
                            .influences = motion.influences,
                            .rows = motion.matrices,
                            .motions = motion.objects,
                            .replaced = motion.replaced,
                            .positions = mesh.positions,
                            .normals = mesh.normals,
                            .bounds = mesh.bounds});
  commands.dispatchLinear(mesh.vertexCount);
  if (!motion.normalsFromMesh) return;
  commands.bind(normals_,
                {.rest = motion.rest,
                 .motions = motion.objects,
                 .edgeRange = motion.edgeRange,
                 .edges = motion.edges,
                 .positions = mesh.positions,
                 .normals = mesh.normals},
                {.vertexCount = mesh.vertexCount});
  commands.dispatchLinear(mesh.vertexCount);
}

}  // namespace opaline::passes
