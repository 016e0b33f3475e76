#include "renderer/frame/frame_resources.h"

#include <cstdint>
#include <optional>
#include <utility>

#include "gpu/device.h"
#include "gpu/transfer.h"
#include "renderer/frame/frame.h"
#include "renderer/frame/light_views.h"
#include "renderer/scene/pattern_layout.h"
#include "renderer/scene/scene_tables.h"

namespace opaline {

namespace {

std::optional<PatternLayout> patternOf(const SceneResources& scene, const RenderOptions& options) {
  if (!scene.needs.mapSize) return std::nullopt;
  return layOutPattern(scene, options);
}

}  // namespace

void makeFrameResources(gpu::Device& device, const Passes& passes, SceneResources& scene,
                        const Lighting& lighting, const RenderOptions& options,
                        FrameResources& made) {
  const auto width = static_cast<std::uint32_t>(options.width);
  const auto height = static_cast<std::uint32_t>(options.height);
  made.view = passes::FitPass::makeView(device);
  const std::optional<PatternLayout> pattern = patternOf(scene, options);
  if (pattern) {
    made.sources = passes.map.prepare(
        device, scene.mesh, static_cast<std::uint32_t>(*scene.needs.mapSize), pattern->maps);
  } else {
    made.sources.charts =
        gpu::makeBuffer(device, "no charts", {}, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  }
  made.tables = makeSceneTables(device, scene, pattern, options);
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
  resources.tables = makeSceneTables(device, scene, patternOf(scene, options), options);
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
