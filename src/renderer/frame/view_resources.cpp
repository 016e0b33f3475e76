#include "renderer/frame/view_resources.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "passes/mechanics.h"
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
                           SceneResources& scene, const EditedScene& edited,
                           const SceneChanges& changes) {
  const Lighting& lighting = edited.lighting();
  const std::optional<For> before = std::exchange(for_, std::nullopt);
  const bool whole = !before || before->changes.whole != changes.whole;
  const bool size = whole || !sameSize(before->options, options);
  const bool surface = whole || before->options.roughness != options.roughness;
  const bool transport = whole || before->options.transport != options.transport;
  const bool media = whole || before->changes.media != changes.media;
  const bool pattern = whole || !samePattern(before->options.pattern, options.pattern) ||
                       before->options.dsmSize != options.dsmSize;
  const bool glossy = plan.opaque || plan.ownSurfaces;
  const bool sky = surface || before->changes.sky != changes.sky || (glossy && !made_.sky.glossy);
  const std::uint32_t views = shadowViewCount(lighting);
  const bool cutOut = !scene.mesh.cutOut.empty();
  const bool newShadows = whole || made_.view.shadowViews != views ||
                          before->options.shadowSize != options.shadowSize ||
                          made_.shadows.cutOut != cutOut;

  if (whole) dropAllButPicture();
  if (size || media || transport || pattern) made_.map.reset();
  if (newShadows || surface || pattern) lit.reset();
  if (whole) made_.view = passes::FitPass::makeView(device_);
  if (media || transport || surface)
    makeTables(device_, passes_, scene, options, edited.scene(), made_);
  if (sky) makeSky(device_, passes_, lighting, options, glossy, made_);
  const bool behind =
      sky || media || transport || before->options.environmentBehind != options.environmentBehind;
  makeBackdrop(plan, edited, behind);
  if (whole) makeExitance(scene);
  if (size) makeImages(options);
  makeRoom(plan, lighting, cutOut);
  if (newShadows) {
    shadows.reset();
    makeShadows(device_, lighting, options, cutOut, made_);
  }
  if (plan.map && !made_.map) makeMap(options, scene);
  if (plan.seenSurfels && !made_.seenSurfels.image)
    made_.seenSurfels = passes::SeenSurfelsPass::makeSeen(device_, made_.radiance.extent());
  if (plan.irradiance && !made_.seenIrradiance)
    made_.seenIrradiance = passes::SeenIrradiancePass::makeImage(device_, made_.radiance.extent());
  for_ = {options, changes};
}

void ViewResources::dropAllButPicture() {
  made_ = {.radiance = std::move(made_.radiance)};
}

void ViewResources::forget() {
  dropAllButPicture();
  made_.radiance.forget();
  lit.reset();
  sight.reset();
  shadows.reset();
  for_.reset();
}

// Uses the environment as it was given, so that its suns are visible.
void ViewResources::makeBackdrop(const FramePlan& plan, const EditedScene& edited, bool anew) {
  const Lighting& given = edited.scene().lighting;
  const bool through = seesThrough(plan, made_.tables);
  const bool wanted = showsBackdrop(plan, given) || through;
  if (!wanted || anew) made_.backdrop = {};
  if (!wanted || made_.backdrop.environment) return;
  made_.backdrop = passes::BackdropPass::makeBackdrop(
      device_, plan.environmentBehind || through ? given.environment.get() : nullptr);
}

void ViewResources::makeExitance(const SceneResources& scene) {
  // Sheets have irradiance on either side, and any opaque body may become one that lets light
  // through.
  const std::size_t sides = scene.hasOpaque() ? 2 : 1;
  const std::size_t count = std::max<std::size_t>(sides * scene.mesh.vertexCount, 1);
  made_.exitance.vertices =
      gpu::Buffer(device_, {.name = "exitance of vertices",
                            .bytes = count * sizeof(shared::vec4),
                            .usage = passes::roomUsage | VK_BUFFER_USAGE_VERTEX_BUFFER_BIT,
                            .lent = true});
  made_.exitance.origins = passes::makeRoom<shared::vec4>(device_, "origins of light of vertices",
                                                          scene.mesh.vertexCount);
}

void ViewResources::makeImages(const RenderOptions& options) {
  const auto width = static_cast<std::uint32_t>(options.width);
  const auto height = static_cast<std::uint32_t>(options.height);
  // Freed before memory for the next is allocated.
  made_.surfaces = {};
  made_.centres = {};
  made_.seenSurfels = {};
  made_.seenIrradiance = {};
  made_.variables = {};
  const bool fits = made_.radiance && made_.radiance.extent().width == width &&
                    made_.radiance.extent().height == height;
  if (fits) return;
  made_.radiance = {};
  made_.radiance = passes::ShadePass::makeRadiance(device_, width, height);
}

// Makes room for the largest number of samples that any frame has had.
void ViewResources::makeRoom(const FramePlan& plan, const Lighting& lighting, bool cutOut) {
  const VkExtent2D extent = made_.radiance.extent();
  const auto samples = static_cast<std::uint32_t>(std::max(plan.samples, 1));
  passes::VisibleSurfaces& surfaces = made_.surfaces;
  const bool looksFurther = plan.opaque || plan.mirrorsBodies || seesThrough(plan, made_.tables);
  const passes::KeptOfSeen kept{
      .materials = surfaces.kept.materials || plan.ownSurfaces || looksFurther,
      .paint = surfaces.kept.paint || plan.painted,
      .origins = surfaces.kept.origins || leavesByOrigin(plan),
      .ofPixels = surfaces.kept.ofPixels || looksFurther,
      .drawn = surfaces.kept.drawn || (!showsBackdrop(plan, lighting) && !cutOut)};
  if (!surfaces.words || surfaces.words.options().layers < samples || surfaces.kept != kept) {
    sight.reset();
    surfaces = {};  // freed before memory for the next is allocated
    surfaces = passes::SurfacePass::makeSurfaces(device_, extent, samples, kept);
  }
  if (plan.centre && !made_.centres.position)
    made_.centres = passes::CentresPass::makeCentres(device_, extent);
}

// Made on demand, as few frames use the paper's method or show its map.
void ViewResources::makeMap(const RenderOptions& options, SceneResources& scene) {
  made_.map = passes_.paper->makeMap(device_, restSceneOf(scene), *scene.flat, scene.mesh, options);
  lit.reset();
}

}  // namespace opaline
