#include "passes/shade/reflected_sky_pass.h"

#include <algorithm>
#include <cmath>

#include "gpu/device.h"
#include "passes/mechanics.h"
#include "passes/seen_parts.h"

namespace opaline::passes {

namespace {

// Of one sample: a mirror needs one, as antialiasing softens its edges; a wide lobe a few.
std::uint32_t raysOfSample(float alpha) {
  constexpr float raysOfAlpha = 16;
  return static_cast<std::uint32_t>(std::clamp(std::round(raysOfAlpha * alpha), 1.0F, 8.0F));
}

}  // namespace

ReflectedSkyPass::ReflectedSkyPass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      pipeline_(device, "reflected sky", rayShader<shaders::ShadeReflectedSky>(device)) {}

void ReflectedSkyPass::record(gpu::CommandList& commands, const Inputs& inputs,
                              const SeenSurfaces& seen) const {
  const float alpha = inputs.roughness * inputs.roughness;
  const std::uint32_t rays = raysOfSample(alpha);
  commands.beginPass("reflected sky");
  forEachPart(commands, seen.surfaces, [&](std::uint32_t first) {
    commands.bind(pipeline_,
                  {.frame = seen.frame.data,
                   .seenWords = {seen.surfaces.words, nearest_},
                   .seenList = seen.surfaces.list,
                   .seenCount = seen.surfaces.counts,
                   .objects = inputs.tables.objects,
                   .pieceCorners = inputs.rays.corners,
                   .rayHierarchy = passes::rays(inputs.rays),
                   .light = seen.surfaces.light,
                   .meshIndices = seen.mesh.indices,
                   .meshPositions = seen.mesh.positions,
                   .meshNormals = seen.mesh.normals,
                   .meshObjects = seen.mesh.objectOf},
                  {.first = first,
                   .nodeCount = inputs.surfels.firstOfHeight.back(),
                   .piecesPerSurfel = inputs.surfels.piecesPerSurfel,
                   .rays = rays,
                   .raysInAll = rays * inputs.samples,
                   .alpha = alpha});
  });
  commands.endPass();
}

}  // namespace opaline::passes
