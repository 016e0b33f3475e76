#include "renderer/frame/frame_resources.h"

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
  const auto width = static_cast<std::uint32_t>(options.width);
  const auto height = static_cast<std::uint32_t>(options.height);
  made.view = passes::FitPass::makeView(device);
  made.tables = makeSceneTables(device, scene, options);
  remakeSky(device, passes, lighting, options, made);
  made.surface = passes::SurfacePass::makeSurface(device, width, height);
  made.exitance = passes::SurfacePass::makeExitance(device, width, height, scene.mesh.vertexCount);
  made.reflectedSky = passes::ReflectedSkyPass::makeSky(device, width, height);
  if (!made.radiance) made.radiance = passes::ShadePass::makeRadiance(device, width, height);
  remakeShadows(device, lighting, options, made);
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
