#include "opaline/renderer.h"

#include <algorithm>
#include <optional>

#include <glm/gtc/type_ptr.hpp>

#include "gpu/command_list.h"
#include "gpu/device.h"
#include "gpu/transfer.h"
#include "opaline/error.h"
#include "renderer/camera_view.h"
#include "renderer/frame.h"
#include "renderer/light_views.h"
#include "renderer/pattern_layout.h"
#include "renderer/readback.h"
#include "renderer/scene_resources.h"
#include "renderer/scene_tables.h"
#include "renderer/timing.h"
#include "renderer/validate.h"

namespace opaline {

namespace {

DeviceDescription describe(const gpu::DeviceInfo& info) {
  return {info.name, gpu::toString(info.type), info.driver};
}

// The paper's rule, per object: vertices suffice where edges are no longer than a mean free path.
Site chooseSite(Site wanted, const SceneResources& resources) {
  if (wanted != Site::Auto) return wanted;
  for (std::size_t i = 0; i < resources.objects; ++i)
    if (resources.meanEdgeOfObjectMm[i] >
        shortestMeanFreePathMm(resources.media[resources.mediumOfObject[i]]))
      return Site::Fragment;
  return Site::Vertex;
}

FramePlan makePlan(const RenderOptions& options, const std::vector<Aov>& aovs, Site site) {
  return {.transport = options.transport,
          .sum = options.sum,
          .site = site,
          .samples = std::find(aovs.begin(), aovs.end(), Aov::Radiance) != aovs.end()
                         ? options.antialias
                         : 0,
          .centre = std::any_of(aovs.begin(), aovs.end(), needsCentre),
          .specular = options.specular,
          .roughness = options.roughness};
}

// Every pass of a frame in a command list's count: those of gathering, those of the vertices'
// scattering, and three for each look at the surface.
constexpr std::uint32_t maxPassesOfFrame = 8 + 3 * 10;

}  // namespace

class Renderer::Implementation {
 public:
  explicit Implementation(const RendererOptions& options)
      : device_({.selector = options.device, .validation = options.validation, .log = options.log}),
        passes_(device_),
        commands_(device_, "frame", maxPassesOfFrame),
        frameData_(device_, "frame data", sizeof(shared::FrameData), 2,
                   VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT) {}

  void setScene(const Scene& scene) {
    validate(scene);
    device_.waitIdle();
    resources_.reset();
    uploaded_.reset();
    scene_ = scene;
  }

  RenderResult render(const RenderOptions& options, const std::vector<Aov>& aovs) {
    validate(options);
    if (!scene_) throw Error("no scene is set; call setScene first");
    prepare(options);

    const Site site = chooseSite(options.site, *uploaded_);
    const FramePlan plan = makePlan(options, aovs, site);
    const CameraView camera =
        makeCameraView(scene_->camera, uploaded_->bounds,
                       static_cast<float>(options.width) / static_cast<float>(options.height));
    const shared::FrameData frame = makeFrameData(camera, options);

    FrameTimes times;
    for (int i = 0; i < options.frames; ++i) {
      runFrame(plan, frame);
      times.add(commands_.frameMilliseconds(), commands_.timings());
    }

    RenderResult result;
    for (const Aov aov : aovs)
      result.images.push_back(readAov(device_, aov, site, *resources_, camera));
    result.report = makeReport(options, site, times);
    return result;
  }

  void submit(const RenderOptions& options, const std::vector<Aov>& aovs) {
    if (waiting_.size() >= framesInFlight) throw UsageError("collect a frame before the next");
    RenderResult result = render(options, aovs);
    waiting_.push_back({std::move(result.images), result.report.frameMilliseconds,
                        std::move(result.report.passes)});
    report_ = std::move(result.report);
  }

  void collect(Frame& frame) {
    if (waiting_.empty()) throw UsageError("no frame is under way; call submit first");
    frame = std::move(waiting_.front());
    waiting_.erase(waiting_.begin());
  }

  RenderReport report() const { return report_; }

  std::size_t validationMessages() const { return device_.validationMessages(); }

 private:
  // Makes what depends on the scene and the options, where it is not there yet.
  void prepare(const RenderOptions& options) {
    if (!uploaded_ || prepared_.dsmSize != options.dsmSize) {
      resources_.reset();
      uploaded_.reset();
      uploaded_ = makeSceneResources(device_, *scene_, options.dsmSize);
    }
    if (!resources_ || !sameTables(prepared_, options)) {
      resources_.reset();
      resources_ = makeFrameResources(options);
    }
    if (options.sum == Sum::All) passes_.gather.prepareList(device_, resources_->sources);
    prepared_ = options;
  }

  static bool sameTables(const RenderOptions& a, const RenderOptions& b) {
    return a.width == b.width && a.height == b.height && a.transport == b.transport &&
           a.pattern.nearRings == b.pattern.nearRings &&
           a.pattern.nearSpacing == b.pattern.nearSpacing &&
           a.pattern.farDistance == b.pattern.farDistance && a.dsmSize == b.dsmSize &&
           a.shadowSize == b.shadowSize && a.roughness == b.roughness;
  }

  FrameResources makeFrameResources(const RenderOptions& options) {
    const auto width = static_cast<std::uint32_t>(options.width);
    const auto height = static_cast<std::uint32_t>(options.height);
    const PatternLayout pattern = layOutPattern(*uploaded_, options);
    FrameResources made;
    made.sources = passes_.gather.prepare(device_, uploaded_->mesh,
                                          static_cast<std::uint32_t>(options.dsmSize),
                                          uploaded_->objects, pattern.maps);
    made.tables = makeSceneTables(device_, *uploaded_, pattern, made.sources.firstOfObject,
                                  scene_->lighting, options);
    made.shadows = passes::ShadowPass::makeMaps(
        device_, static_cast<std::uint32_t>(options.shadowSize), shadowViewCount(scene_->lighting));
    made.surface = passes::SurfacePass::makeSurface(device_, width, height);
    made.exitance =
        passes::SurfacePass::makeExitance(device_, width, height, uploaded_->mesh.vertexCount);
    made.radiance = passes::ShadePass::makeRadiance(device_, width, height);
    const std::optional<Image>& environment = scene_->lighting.environment;
    made.environmentCube =
        environment ? passes_.environment.makeCube(device_, *environment, options.roughness)
                    : passes::EnvironmentPass::makeBlack(device_);
    return made;
  }

  shared::FrameData makeFrameData(const CameraView& camera, const RenderOptions& options) const {
    shared::FrameData frame{};
    frame.worldToClip = camera.worldToClip;
    frame.cameraPosition = {camera.position, 1};
    frame.cameraAxis = {camera.axis, 0};
    fillLights(scene_->lighting, uploaded_->bounds, static_cast<std::uint32_t>(options.shadowSize),
               frame);
    frame.counts.z = scene_->lighting.environment ? 1 : 0;
    frame.ambient = {glm::make_vec3(scene_->lighting.ambient.data()), 0};
    return frame;
  }

  void runFrame(const FramePlan& plan, const shared::FrameData& frame) {
    commands_.begin();
    frameData_.nextFrame();
    const std::size_t offset = frameData_.push(frame);
    recordFrame(commands_, passes_, plan, frame, shadowViewCount(scene_->lighting),
                frameData_.buffer(), offset, uploaded_->mesh, *resources_);
    commands_.submit();
    commands_.wait();
  }

  RenderReport makeReport(const RenderOptions& options, Site site, const FrameTimes& times) const {
    constexpr double megabyte = 1e6;
    return {.device = describe(device_.info()),
            .transport = options.transport,
            .sum = options.sum,
            .site = site,
            .triangles = uploaded_->triangles,
            .vertices = uploaded_->mesh.vertexCount,
            .sources = resources_->sources.sourceCount,
            .passes = times.passes(),
            .frameMilliseconds = times.frameMilliseconds(),
            .peakMemoryMegabytes = static_cast<double>(device_.peakMemoryBytes()) / megabyte};
  }

  gpu::Device device_;
  Passes passes_;
  gpu::CommandList commands_;
  gpu::UploadRing frameData_;
  std::optional<Scene> scene_;
  std::optional<SceneResources> uploaded_;
  std::optional<FrameResources> resources_;
  RenderOptions prepared_;
  std::vector<Frame> waiting_;
  RenderReport report_;
};

Renderer::Renderer(const RendererOptions& options)
    : implementation_(std::make_unique<Implementation>(options)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

void Renderer::setScene(const Scene& scene) {
  implementation_->setScene(scene);
}

RenderResult Renderer::render(const RenderOptions& options, const std::vector<Aov>& aovs) {
  return implementation_->render(options, aovs);
}

void Renderer::submit(const RenderOptions& options, const std::vector<Aov>& aovs) {
  implementation_->submit(options, aovs);
}

void Renderer::collect(Frame& frame) {
  implementation_->collect(frame);
}

RenderReport Renderer::report() const {
  return implementation_->report();
}

std::size_t Renderer::validationMessages() const {
  return implementation_->validationMessages();
}

std::vector<DeviceDescription> listDevices() {
  std::vector<DeviceDescription> devices;
  for (const gpu::DeviceInfo& info : gpu::Device::list()) devices.push_back(describe(info));
  return devices;
}

}  // namespace opaline
