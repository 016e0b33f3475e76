#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "c_interface/handles.h"
#include "c_interface/status.h"
#include "c_interface/values.h"
#include "opaline/renderer.h"

namespace opaline::c {

namespace {

// Both interfaces number the choices in the same way.
static_assert(static_cast<int>(Transport::Boundary) == OpalineTransportBoundary);
static_assert(static_cast<int>(Sum::All) == OpalineSumAll);
static_assert(static_cast<int>(Site::Fragment) == OpalineSiteFragment);
static_assert(static_cast<int>(Aov::DsmArea) == OpalineAovDsmArea);
static_assert(static_cast<int>(LogLevel::Warning) == OpalineWarning);
static_assert(sizeof(OpalineAov) == 4 && sizeof(OpalineTransport) == 4);

// More than there are, since a frame may return a variable twice.
constexpr std::size_t mostVariables = 64;

OpalineRendererOptions defaultRendererOptions() {
  OpalineRendererOptions options{};
  options.rayQueries = -1;
  return options;
}

RendererOptions rendererOptionsOf(const OpalineRendererOptions* given) {
  RendererOptions options;
  if (!given) return options;
  const OpalineRendererOptions whole = wholeOf(given, defaultRendererOptions(), "options");
  if (whole.device) options.device = whole.device;
  options.validation = whole.validation != 0;
  if (whole.rayQueries >= 0) options.rayQueries = whole.rayQueries != 0;
  if (whole.memoryLimitMegabytes != 0) options.memoryLimit = whole.memoryLimitMegabytes;
  if (whole.given) options.given = givenOf(*whole.given);
  if (whole.pipelineCacheBytes > 0) {
    const auto* bytes = static_cast<const std::byte*>(whole.pipelineCache);
    required(bytes, "pipelineCache");
    options.pipelineCache.assign(bytes, bytes + whole.pipelineCacheBytes);
  }
  options.log = logOf(whole.log, whole.logContext);
  options.instanceExtensions =
      stringsOf(whole.instanceExtensions, whole.instanceExtensionCount, "instanceExtensions");
  options.deviceExtensions =
      stringsOf(whole.deviceExtensions, whole.deviceExtensionCount, "deviceExtensions");
  return options;
}

OpalinePattern patternOf(const RenderOptions& options) {
  return {0, options.pattern.nearRings, options.pattern.nearSpacing, options.pattern.farDistance,
          options.dsmSize};
}

OpalineRenderOptions given(const RenderOptions& options) {
  return {0,
          options.width,
          options.height,
          static_cast<OpalineTransport>(options.transport),
          static_cast<OpalineSum>(options.sum),
          static_cast<OpalineSite>(options.site),
          options.tolerance,
          options.maxSurfels,
          options.maxClusters,
          options.bounces,
          options.ambientOcclusion ? 1 : 0,
          options.shadowSize,
          options.specular ? 1 : 0,
          options.roughness,
          options.antialias,
          options.environmentBehind ? 1 : 0,
          nullptr,
          options.treeLevel};
}

RenderOptions renderOptionsOf(const OpalineRenderOptions* from) {
  RenderOptions options;
  if (!from) return options;
  const OpalineRenderOptions whole = wholeOf(from, given(options), "options");
  options.width = whole.width;
  options.height = whole.height;
  options.transport = choiceOf<Transport>(whole.transport, OpalineTransportBoundary, "transport");
  options.sum = choiceOf<Sum>(whole.sum, OpalineSumAll, "sum");
  options.site = choiceOf<Site>(whole.site, OpalineSiteFragment, "site");
  options.tolerance = whole.tolerance;
  options.maxSurfels = whole.maxSurfels;
  options.maxClusters = whole.maxClusters;
  options.bounces = whole.bounces;
  options.ambientOcclusion = whole.ambientOcclusion != 0;
  options.shadowSize = whole.shadowSize;
  options.specular = whole.specular != 0;
  options.roughness = whole.roughness;
  options.antialias = whole.antialias;
  options.environmentBehind = whole.environmentBehind != 0;
  options.treeLevel = whole.treeLevel;
  if (whole.pattern) {
    const OpalinePattern pattern = wholeOf(whole.pattern, patternOf(options), "pattern");
    options.pattern = {pattern.nearRings, pattern.nearSpacing, pattern.farDistance};
    options.dsmSize = pattern.dsmSize;
  }
  return options;
}

std::vector<OpalineTarget> targetsOf(const OpalineTarget* targets, std::size_t count) {
  std::vector<OpalineTarget> whole;
  forEachOf(targets, count, mostVariables, "targets", [&](const OpalineTarget& target) {
    required(target.rgba, "rgba");
    whole.push_back(target);
  });
  return whole;
}

void requireRoom(const OpalineTarget& target, int width, int height) {
  const std::size_t needed =
      std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (target.floatCount < needed) {
    throw UsageError(fmt::format("A target has room for {} floats; a picture of {}x{} has {}.",
                                 target.floatCount, width, height, needed));
  }
}

void copy(const std::vector<Image>& images, const std::vector<OpalineTarget>& targets) {
  for (std::size_t i = 0; i < images.size(); ++i)
    requireRoom(targets[i], images[i].width, images[i].height);
  for (std::size_t i = 0; i < images.size(); ++i) {
    std::copy(images[i].rgba.begin(), images[i].rgba.end(), targets[i].rgba);
  }
}

void requireSame(const std::vector<Aov>& aovs, const std::vector<OpalineTarget>& targets) {
  if (aovs.size() != targets.size())
    throw UsageError(fmt::format("There are {} targets, but the frame has {} variables.",
                                 targets.size(), aovs.size()));
  for (std::size_t i = 0; i < aovs.size(); ++i)
    if (targets[i].aov != static_cast<OpalineAov>(aovs[i]))
      throw UsageError(fmt::format("Target {} is for another variable than the frame has.", i));
}

}  // namespace

Aov aovOf(const OpalineAov& given) {
  return choiceOf<Aov>(given, OpalineAovDsmArea, "variable");
}

DeviceDescription deviceOf(std::size_t index) {
  const std::vector<DeviceDescription> devices = listDevices();
  return oneOf(devices, index, "device", "there are");
}

FrameOrder orderOf(std::vector<Aov> aovs, std::int32_t reuseLight, std::int32_t impatient) {
  FrameOrder order;
  order.aovs = std::move(aovs);
  order.reuseLight = reuseLight != 0;
  order.patient = impatient == 0;
  return order;
}

std::vector<Aov> aovsOf(const OpalineAov* aovs, std::size_t count) {
  requireCount(count, mostVariables, "aovs");
  if (count > 0) required(aovs, "aovs");
  std::vector<Aov> wanted;
  for (std::size_t i = 0; i < count; ++i) wanted.push_back(aovOf(aovs[i]));
  return wanted;
}

View& changing(OpalineView* view) {
  required(view, "view").report.reset();
  return view->view;
}

}  // namespace opaline::c

using namespace opaline;
using opaline::c::guarded;
using opaline::c::required;

extern "C" {

OpalineStatus opalineDeviceCount(size_t* count) {
  return guarded([&] { required(count, "count") = listDevices().size(); });
}

OpalineStatus opalineDeviceName(size_t device, char* name, size_t nameBytes) {
  return guarded([&] { c::give(c::deviceOf(device).name, name, nameBytes, "name"); });
}

OpalineStatus opalineDefaultRendererOptions(OpalineRendererOptions* options) {
  return guarded([&] { c::give(c::defaultRendererOptions(), options, "options"); });
}

OpalineStatus opalineCreateRenderer(const OpalineRendererOptions* options,
                                    OpalineRenderer** renderer) {
  return guarded([&] {
    required(renderer, "renderer");
    *renderer = new OpalineRenderer{{}, Renderer(c::rendererOptionsOf(options)), {}, {}, {}};
  });
}

void opalineDestroyRenderer(OpalineRenderer* renderer) {
  c::destroy(renderer);
}

OpalineStatus opalineSetScene(OpalineRenderer* renderer, const OpalineScene* scene) {
  return guarded([&] {
    const Scene& given = required(scene, "scene").scene;
    std::vector<std::size_t> counts;
    for (const Object& object : given.objects) counts.push_back(object.mesh.positionsMm.size());
    required(renderer, "renderer").renderer.setScene(given);
    renderer->vertexCounts = std::move(counts);
    for (const auto& view : renderer->views) view->report.reset();
  });
}

OpalineStatus opalineSetTime(OpalineRenderer* renderer, double seconds, int32_t clip) {
  return guarded([&] { required(renderer, "renderer").renderer.setTime({seconds, clip}); });
}

OpalineStatus opalineSetCamera(OpalineRenderer* renderer, const OpalineCamera* camera) {
  return guarded([&] { required(renderer, "renderer").renderer.setCamera(c::cameraOf(camera)); });
}

OpalineStatus opalineSetMedium(OpalineRenderer* renderer, size_t object,
                               const OpalineMedium* medium) {
  return guarded(
      [&] { required(renderer, "renderer").renderer.setMedium(object, c::mediumOf(medium)); });
}

OpalineStatus opalineSetMaterial(OpalineRenderer* renderer, size_t object,
                                 const OpalineScene* scene) {
  return guarded([&] {
    required(renderer, "renderer")
        .renderer.setMaterial(object, materialOf(c::objectOf(scene, object)));
  });
}

OpalineStatus opalineSetLights(OpalineRenderer* renderer, const OpalineScene* scene) {
  return guarded([&] {
    required(renderer, "renderer").renderer.setLighting(required(scene, "scene").scene.lighting);
  });
}

OpalineStatus opalineSetDeformers(OpalineRenderer* renderer, const OpalineScene* scene) {
  return guarded([&] {
    required(renderer, "renderer").renderer.setDeformers(required(scene, "scene").scene.deformers);
  });
}

OpalineStatus opalineSetPositions(OpalineRenderer* renderer, size_t object,
                                  const float* positionsMm, size_t vertexCount,
                                  size_t strideBytes) {
  return guarded([&] {
    const std::vector<std::size_t>& counts = required(renderer, "renderer").vertexCounts;
    // Checked before any position is read.
    if (object < counts.size() && vertexCount != counts[object])
      throw UsageError(fmt::format("object {} has {} vertices, but {} positions are given", object,
                                   counts[object], vertexCount));
    renderer->renderer.replacePositions(
        object, c::vectorsOf<Vec3>(positionsMm, vertexCount, strideBytes, "positionsMm"));
  });
}

OpalineStatus opalineRestorePositions(OpalineRenderer* renderer, size_t object) {
  return guarded([&] { required(renderer, "renderer").renderer.restorePositions(object); });
}

OpalineStatus opalineDefaultRenderOptions(OpalineRenderOptions* options) {
  return guarded([&] { c::give(c::given(RenderOptions{}), options, "options"); });
}

OpalineStatus opalineDefaultPattern(OpalinePattern* pattern) {
  return guarded([&] { c::give(c::patternOf(RenderOptions{}), pattern, "pattern"); });
}

OpalineStatus opalineCreateView(OpalineRenderer* renderer, const OpalineRenderOptions* options,
                                OpalineView** view) {
  return guarded([&] {
    required(view, "view");
    const RenderOptions wanted = c::renderOptionsOf(options);
    View made(required(renderer, "renderer").renderer, wanted);
    c::keep(new OpalineView{{}, renderer, std::move(made), {}, false, {}}, &OpalineRenderer::views,
            view);
  });
}

void opalineDestroyView(OpalineView* view) {
  c::destroyPart(view, &OpalineRenderer::views);
}

OpalineStatus opalineSetViewOptions(OpalineView* view, const OpalineRenderOptions* options) {
  return guarded([&] {
    required(options, "options");
    const RenderOptions wanted = c::renderOptionsOf(options);
    required(view, "view").view.setOptions(wanted);
  });
}

OpalineStatus opalineSetViewCamera(OpalineView* view, const OpalineCamera* camera) {
  return guarded([&] {
    required(view, "view")
        .view.setCamera(camera ? std::optional<Camera>(c::cameraOf(camera)) : std::nullopt);
  });
}

OpalineStatus opalineSetViewMatrices(OpalineView* view, const OpalineCameraMatrices* matrices) {
  return guarded([&] {
    const OpalineCameraMatrices whole = c::wholeOf(matrices, {}, "matrices");
    CameraMatrices given;
    std::copy_n(whole.worldToView, 16, given.worldToView.begin());
    std::copy_n(whole.viewToClip, 16, given.viewToClip.begin());
    given.jitterPixels = {whole.jitterPixels[0], whole.jitterPixels[1]};
    required(view, "view").view.setCamera(given);
  });
}

OpalineStatus opalineMemoryInUse(const OpalineRenderer* renderer, uint64_t* bytes) {
  return guarded(
      [&] { required(bytes, "bytes") = required(renderer, "renderer").renderer.memoryBytes(); });
}

OpalineStatus opalineValidationMessages(const OpalineRenderer* renderer, uint64_t* count) {
  return guarded([&] {
    required(count, "count") = required(renderer, "renderer").renderer.validationMessages();
  });
}

OpalineStatus opalinePipelineCache(const OpalineRenderer* renderer, void* data, size_t* bytes) {
  return guarded([&] {
    required(bytes, "bytes");
    const std::vector<std::byte> cache = required(renderer, "renderer").renderer.pipelineCache();
    const size_t room = data ? *bytes : 0;
    *bytes = cache.size();
    if (!data) return;
    if (room < cache.size())
      throw UsageError(fmt::format("There is room for {} bytes; the pipeline cache has {}.", room,
                                   cache.size()));
    std::memcpy(data, cache.data(), cache.size());
  });
}

OpalineStatus opalineRender(OpalineView* view, const OpalineTarget* targets, size_t targetCount) {
  return guarded([&] {
    View& rendered = c::changing(view);
    const std::vector<OpalineTarget> to = c::targetsOf(targets, targetCount);
    if (to.empty()) throw UsageError("A picture needs at least one target.");
    std::vector<Aov> aovs;
    for (const OpalineTarget& target : to) {
      aovs.push_back(c::aovOf(target.aov));
      const RenderOptions& options = rendered.options();
      if (showsMap(aovs.back()))
        c::requireRoom(target, options.dsmSize, options.dsmSize);
      else
        c::requireRoom(target, options.width, options.height);
    }
    c::copy(rendered.render(c::orderOf(std::move(aovs), 0, 0)).images, to);
  });
}

OpalineStatus opalineSubmit(OpalineView* view, const OpalineAov* aovs, size_t aovCount) {
  return guarded([&] { c::changing(view).submit(c::orderOf(c::aovsOf(aovs, aovCount), 0, 0)); });
}

OpalineStatus opalineSubmitOrder(OpalineView* view, const OpalineFrameOrder* order) {
  return guarded([&] {
    const OpalineFrameOrder whole = c::wholeOf(order, {}, "order");
    c::changing(view).submit(
        c::orderOf(c::aovsOf(whole.aovs, whole.aovCount), whole.reuseLight, whole.impatient));
  });
}

OpalineStatus opalineCollect(OpalineView* view, const OpalineTarget* targets, size_t targetCount,
                             double* milliseconds) {
  return guarded([&] {
    View& collected = c::changing(view);
    const std::vector<OpalineTarget> to = c::targetsOf(targets, targetCount);
    if (!view->isFrameWaiting) collected.collect(view->frame);
    view->isFrameWaiting = true;
    c::requireSame(view->frame.aovs, to);
    c::copy(view->frame.images, to);
    view->isFrameWaiting = false;
    if (milliseconds) *milliseconds = view->frame.milliseconds;
  });
}

}  // extern "C"
