#include "passes/shade/shade_pass.h"

#include "gpu/device.h"
#include "passes/seen_parts.h"

namespace opaline::passes {

ShadePass::ShadePass(gpu::Device& device)
    : nearest_(device, gpu::Filter::Nearest),
      linear_(device, gpu::Filter::Linear),
      shade_{{device, "shade", {.withPaint = 0, .withOwnSurfaces = 0}},
             {device, "shade", {.withPaint = 1, .withOwnSurfaces = 0}}},
      shadeOwnSurfaces_{{device, "shade", {.withPaint = 0, .withOwnSurfaces = 1}},
                        {device, "shade", {.withPaint = 1, .withOwnSurfaces = 1}}},
      opaque_(device, "shade opaque"),
      sum_(device, "sum of surfaces") {}

gpu::GpuImage ShadePass::makeRadiance(gpu::Device& device, std::uint32_t width,
                                      std::uint32_t height) {
  return {device,
          {.name = "radiance",
           .width = width,
           .height = height,
           .format = VK_FORMAT_R32G32B32A32_SFLOAT,
           .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                    VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
           .lent = true}};
}

void ShadePass::record(gpu::CommandList& commands, const Inputs& inputs,
                       const SeenSurfaces& seen) const {
  VisibleSurfaces& surfaces = seen.surfaces;
  commands.beginPass("shade");
  const auto& shade = inputs.tables.surfaces.any ? shadeOwnSurfaces_ : shade_;
  dispatchWhole(
      commands, surfaces.counts, shade.of(inputs.tables.paint.any),
      {.listedPlaces = listedPlaces(seen, nearest_),
       .meshExitances = inputs.exitance.vertices,
       .light = surfaces.light,
       .objects = inputs.tables.objects,
       .media = inputs.tables.media,
       .shadowMaps = {inputs.shadows.depth, nearest_},
       .skyReflection = {inputs.sky.reflected, linear_},
       .specularAlbedo = inputs.tables.specularAlbedo,
       .paint = surfaces.paint,
       .materials = surfaces.materials,
       .glossySky = {inputs.sky.glossy ? inputs.sky.glossy : inputs.sky.reflected, linear_},
       .meshOrigins = inputs.exitance.origins,
       .origins = surfaces.origins,
       .skyShares = surfaces.skyShares},
      {.atFragments = inputs.atFragments,
       .alpha = inputs.roughness * inputs.roughness,
       .specular = inputs.specular,
       .skyIsMirrored = inputs.mirrorsSky,
       .bodiesAreMirrored = inputs.mirrorsBodies,
       .leavesSmooth = inputs.leavesSmooth,
       .byOrigin = inputs.byOrigin,
       .seesThrough = inputs.seesThrough});
  commands.endPass();
}

void ShadePass::recordOpaque(gpu::CommandList& commands, const Inputs& inputs, OpaqueTables& opaque,
                             const SeenSurfaces& seen) const {
  VisibleSurfaces& surfaces = seen.surfaces;
  commands.beginPass("shade");
  dispatchWhole(commands, surfaces.counts, opaque_,
                {.listedPlaces = listedPlaces(seen, nearest_),
                 .meshExitances = inputs.exitance.vertices,
                 .light = surfaces.light,
                 .objects = inputs.tables.objects,
                 .materials = surfaces.materials,
                 .shadowMaps = {inputs.shadows.depth, nearest_},
                 .glossySky = {inputs.sky.glossy, linear_},
                 .gloss = opaque.gloss},
                {.atFragments = inputs.atFragments,
                 .specular = inputs.specular,
                 .vertexCount = seen.mesh.vertexCount});
  commands.endPass();
}

void ShadePass::sumUp(gpu::CommandList& commands, const SeenSurfaces& seen,
                      gpu::GpuImage& radiance) const {
  VisibleSurfaces& surfaces = seen.surfaces;
  commands.beginPass("shade");
  dispatchWhole(commands, surfaces.counts, sum_,
                {.seenList = surfaces.list,
                 .seenCount = surfaces.counts,
                 .light = surfaces.light,
                 .radiance = radiance});
  commands.endPass();
}

}  // namespace opaline::passes
