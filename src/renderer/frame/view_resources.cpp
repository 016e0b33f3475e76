#include "renderer/frame/view_resources.h"

#include <cstdint>
#include <utility>

#include "renderer/frame/frame.h"
#include "renderer/frame/light_views.h"
#include "renderer/scene/scene_tables.h"

namespace opaline {

namespace {

bool sameSize(const RenderOptions& a, const RenderOptions& b) {
  return a.width == b.width && a.height == b.height;
}

bool samePattern(const PatternOptions& a, const PatternOptions& b) {
  return a.nearRings == b.nearRings && a.nearSpacing == b.nearSpacing &&
         a.farDistance == b.farDistance;
}

}  // namespace

ViewResources::ViewResources(gpu::Device& device, const Passes& passes)
    : device_(device), passes_(passes) {}

void ViewResources::follow(const RenderOptions& options, const FramePlan& plan,
                           SceneResources& scene, const Lighting& lighting,
                           const SceneChanges& changes) {
  const std::optional<For> before = std::exchange(for_, std::nullopt);
  const bool whole = !before || before->changes.whole != changes.whole;
  const bool size = whole || !sameSize(before->options, options);
  const bool surface = whole || before->options.roughness != options.roughness;
  const bool transport = whole || before->options.transport != options.transport;
  const bool media = whole || before->changes.media != changes.media;
  const bool pattern = whole || !samePattern(before->options.pattern, options.pattern) ||
                       before->options.dsmSize != options.dsmSize;
  const bool sky = surface || before->changes.sky != changes.sky;
  const std::uint32_t views = shadowViewCount(lighting);
  const bool shadows =
      whole || made_.view.shadowViews != views || before->options.shadowSize != options.shadowSize;

  if (whole) made_ = {.radiance = std::move(made_.radiance)};
  if (size || media || transport || pattern) made_.map.reset();
  if (size || shadows || surface || pattern) lit.reset();
  if (whole) made_.view = passes::FitPass::makeView(device_);
  if (media || transport || surface) makeTables(device_, scene, options, made_);
  if (sky) makeSky(device_, passes_, lighting, options, made_);
  if (size) makeImages(options, scene);
  if (shadows) makeShadows(device_, lighting, options, made_);
  if (plan.map && !made_.map) makeMap(options, scene);
  if (plan.seenSurfels && !made_.seenSurfels.image)
    made_.seenSurfels = passes::SeenSurfelsPass::makeSeen(device_, made_.surface);
  if (plan.irradiance && !made_.seenIrradiance)
    made_.seenIrradiance = passes::SeenIrradiancePass::makeImage(device_, made_.surface);
  for_ = {options, changes};
}

void ViewResources::makeImages(const RenderOptions& options, const SceneResources& scene) {
  const auto width = static_cast<std::uint32_t>(options.width);
  const auto height = static_cast<std::uint32_t>(options.height);
  // Before memory for the next is taken.
  made_.surface = {};
  made_.exitance = {};
  made_.reflectedSky = {};
  made_.seenSurfels = {};
  made_.seenIrradiance = {};
  const bool fits = made_.radiance && made_.radiance.extent().width == width &&
                    made_.radiance.extent().height == height;
  if (!fits) made_.radiance = {};
  made_.surface = passes::SurfacePass::makeSurface(device_, width, height);
  made_.exitance =
      passes::SurfacePass::makeExitance(device_, width, height, scene.mesh.vertexCount);
  made_.reflectedSky = passes::ReflectedSkyPass::makeSky(device_, width, height);
  if (!fits) made_.radiance = passes::ShadePass::makeRadiance(device_, width, height);
}

// Few frames are by the paper's method, or show its map.
void ViewResources::makeMap(const RenderOptions& options, SceneResources& scene) {
  made_.map = passes_.paper->makeMap(device_, restSceneOf(scene), *scene.flat, scene.mesh, options);
  lit.reset();
}

}  // namespace opaline
