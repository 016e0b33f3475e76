#include "renderer/frame/frame_resources.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "gpu/device.h"
#include "renderer/frame/frame.h"
#include "renderer/frame/light_views.h"
#include "renderer/scene/scene_tables.h"

namespace opaline {

void makeFrameResources(gpu::Device& device, const Passes& passes, SceneResources& scene,
                        const Lighting& lighting, const RenderOptions& options,
                        FrameResources& made) {
  made.view = passes::FitPass::makeView(device);
  made.tables = makeSceneTables(device, scene, options);
  remakeSky(device, passes, lighting, options, made);
  made.exitance.vertices = gpu::Buffer(
      device, {.name = "exitance of vertices",
               .bytes = std::max<std::size_t>(scene.mesh.vertexCount, 1) * sizeof(shared::vec4),
               .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT});
  if (!made.radiance)
    made.radiance =
        passes::ShadePass::makeRadiance(device, static_cast<std::uint32_t>(options.width),
                                        static_cast<std::uint32_t>(options.height));
  remakeShadows(device, lighting, options, made);
}

void makeRoom(gpu::Device& device, const FramePlan& plan, FrameResources& made) {
  const VkExtent2D picture = made.radiance.extent();
  const auto samples = static_cast<std::uint32_t>(std::max(plan.samples, 1));
  const bool surfaces = !made.surfaces.words || made.surfaces.words.options().layers < samples;
  const bool centres = plan.centre && !made.centres.position;
  if (!surfaces && !centres) return;
  device.waitIdle();
  if (surfaces) {
    made.surfaces = {};  // before memory for the next is taken
    made.surfaces = passes::SurfacePass::makeSurfaces(device, picture, samples);
  }
  if (centres) made.centres = passes::CentresPass::makeCentres(device, picture);
}

void keepOnlyPicture(FrameResources& resources) {
  gpu::GpuImage radiance = std::move(resources.radiance);
  resources = {};
  resources.radiance = std::move(radiance);
}

void remakeTables(gpu::Device& device, const SceneResources& scene, const RenderOptions& options,
                  FrameResources& resources) {
  resources.tables = makeSceneTables(device, scene, options);
  passes::SkyPass::takeEtas(device, resources.tables.etas, resources.sky);
}

void remakeSky(gpu::Device& device, const Passes& passes, const Lighting& lighting,
               const RenderOptions& options, FrameResources& resources) {
  resources.sky = passes.sky.makeSky(device, lighting, options.roughness, resources.tables.etas);
}

void remakeShadows(gpu::Device& device, const Lighting& lighting, const RenderOptions& options,
                   FrameResources& resources) {
  resources.view.shadowViews = shadowViewCount(lighting);
  resources.shadows = passes::ShadowPass::makeMaps(
      device, static_cast<std::uint32_t>(options.shadowSize), resources.view.shadowViews);
}

}  // namespace opaline
