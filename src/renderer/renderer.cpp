#include "opaline/renderer.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "gpu/command_list.h"
#include "gpu/device.h"
#include "gpu/transfer.h"
#include "opaline/error.h"
#include "opaline/vulkan.h"
#include "renderer/frame/camera_view.h"
#include "renderer/frame/frame.h"
#include "renderer/frame/frame_plan.h"
#include "renderer/frame/frame_queue.h"
#include "renderer/frame/light_reuse.h"
#include "renderer/frame/light_views.h"
#include "renderer/frame/timing.h"
#include "renderer/scene/edited_scene.h"
#include "renderer/scene/prepared_scene.h"
#include "renderer/validate.h"

namespace opaline {

namespace {

DeviceDescription describe(const gpu::DeviceInfo& info) {
  return {info.name, gpu::toString(info.type), info.driver, info.rayQueries};
}

shared::FrameData makeFrameData(const Lighting& lighting, const CameraView& camera, int shadowSize,
                                int samples) {
  shared::FrameData frame{};
  frame.worldToClip = camera.worldToClip;
  frame.cameraPosition = {camera.position, 1};
  frame.cameraAxis = {camera.axis, 0};
  fillLights(lighting, static_cast<std::uint32_t>(shadowSize), frame);
  fillSamples(samples, frame);
  return frame;
}

}  // namespace

class Renderer::Implementation {
 public:
  explicit Implementation(const RendererOptions& options)
      : device_({.selector = options.device,
                 .validation = options.validation,
                 .log = options.log,
                 .instanceExtensions = options.instanceExtensions,
                 .deviceExtensions = options.deviceExtensions,
                 .rayQueries = options.rayQueries}),
        passes_(device_),
        queue_(device_),
        frameData_(device_, "frame data", sizeof(shared::FrameData), framesInFlight, 0),
        prepared_(device_, passes_, options.log) {}

  // Frames may still be under way.
  ~Implementation() { device_.waitIdle(); }
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  void setScene(const Scene& scene) {
    validate(scene);
    device_.waitIdle();
    queue_.clear();
    prepared_.clear();
    times_.clear();
    edited_.set(device_, scene);
  }

  RenderResult render(const RenderOptions& options, const std::vector<Aov>& aovs) {
    if (!queue_.isEmpty())
      throw UsageError("frames wait to be collected; collect them before calling render");
    FrameTimes times;
    for (int i = 0; i < std::max(options.frames, 1); ++i) {
      submit(options, aovs);
      collect(frame_, times);
    }
    return {std::move(frame_.images), makeReport(times)};
  }

  void submit(const RenderOptions& options, const std::vector<Aov>& aovs) {
    submit(options, aovs, planFor(options, aovs, false));
  }

  DeviceImage submitOnDevice(const RenderOptions& options, const std::vector<Aov>& aovs) {
    shown_ = true;
    submit(options, aovs, planFor(options, aovs, true));
    const gpu::GpuImage& radiance = prepared_.frame()->resources.radiance;
    return {radiance.handle(), radiance.view(), radiance.options().format,
            gpu::scopeOf(gpu::Access::Sampled).layout, radiance.extent()};
  }

  void collect(Frame& frame) { collect(frame, times_); }

  RenderReport report() const {
    if (prepared_.frame() == nullptr) throw UsageError("there is no report before the first frame");
    return makeReport(times_);
  }

  EditedScene& edited() { return edited_; }

  VulkanDevice vulkanDevice() const {
    return {device_.instance(), device_.physical(), device_.handle(), device_.queueFamily(),
            device_.queue()};
  }

  gpu::Device& device() { return device_; }

 private:
  void collect(Frame& frame, FrameTimes& times) {
    queue_.collect(frame, times);
    solutions_ = frame.solutions;
  }

  void submit(const RenderOptions& options, const std::vector<Aov>& aovs, FramePlan plan) {
    validate(options);
    validate(options, aovs);
    edited_.moveTo(options.clip, options.seconds);
    queue_.requireRoom();
    PreparedFrame& frame = prepared_.prepare(options, plan, edited_);
    fitToScene(prepared_.scene(), edited_.scene().lighting, plan);
    makeRoom(device_, plan, frame.resources);
    plan.light = light_.mustFind(options, plan, edited_.changes(), frame);
    plan_ = plan;
    record(options, aovs, plan, frame.resources);
    queue_.submit();
  }

  void record(const RenderOptions& options, const std::vector<Aov>& aovs, const FramePlan& plan,
              FrameResources& resources) {
    const Scene& scene = edited_.scene();
    const CameraView camera = makeCameraView(
        scene.camera, static_cast<float>(options.width) / static_cast<float>(options.height));
    frameData_.nextFrame();
    const FrameUpload upload{
        frameData_.buffer(),
        frameData_.push(makeFrameData(scene.lighting, camera, options.shadowSize, plan.samples))};
    const bool solves = plan.transport == Transport::Boundary && plan.scatter;

    FrameSlot& slot = queue_.next();
    slot.provisional = prepared_.isProvisional();
    slot.readback.prepare(device_, aovs, camera, resources);
    slot.commands.begin();
    recordFrame(slot.commands, passes_, plan, upload, edited_.motion(), prepared_.scene(),
                resources);
    slot.readback.record(slot.commands, resources);
    slot.readback.recordSolutions(slot.commands, solves ? plan.bounces + 1 : 0,
                                  prepared_.scene().solver);
    // Whoever shows pictures may sample this frame's too.
    if (shown_) slot.commands.use(resources.radiance, gpu::Access::Sampled);
  }

  RenderReport makeReport(const FrameTimes& times) const {
    constexpr double megabyte = 1e6;
    const SceneResources& scene = prepared_.scene();
    const bool solved = plan_.transport == Transport::Boundary;
    return {.device = describe(device_.info()),
            .transport = plan_.transport,
            .sum = plan_.sum,
            .site = plan_.site,
            .triangles = scene.triangles,
            .vertices = scene.mesh.vertexCount,
            .sources = plan_.sum == Sum::Pattern
                           ? prepared_.frame()->resources.map->sources.sourceCount
                           : scene.surfels.count,
            .clusters = solved ? scene.clusters.count : 0,
            .solutions = solutions_,
            .passes = times.passes(),
            .frameMilliseconds = times.frameMilliseconds(),
            .peakMemoryMegabytes = static_cast<double>(device_.peakMemoryBytes()) / megabyte};
  }

  gpu::Device device_;
  Passes passes_;
  FrameQueue queue_;
  gpu::UploadRing frameData_;
  EditedScene edited_;
  PreparedScene prepared_;
  LightReuse light_;
  bool shown_ = false;  // pictures are left for others to sample
  FramePlan plan_;      // of the frame submitted last
  FrameTimes times_;
  std::vector<Solution> solutions_;  // of the frame collected last
  Frame frame_;                      // of render()
};

bool showsMap(Aov aov) {
  return aov == Aov::DsmPosition || aov == Aov::DsmNormal || aov == Aov::DsmIrradiance ||
         aov == Aov::DsmArea;
}

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

DeviceImage Renderer::submitOnDevice(const RenderOptions& options, const std::vector<Aov>& aovs) {
  return implementation_->submitOnDevice(options, aovs);
}

void Renderer::collect(Frame& frame) {
  implementation_->collect(frame);
}

void Renderer::setCamera(const Camera& camera) {
  implementation_->edited().setCamera(camera);
}

void Renderer::setLighting(const Lighting& lighting) {
  implementation_->edited().setLighting(lighting);
}

void Renderer::setMedium(std::size_t object, const Medium& medium) {
  implementation_->edited().setMedium(object, medium);
}

void Renderer::setDeformers(const std::vector<Deformer>& deformers) {
  implementation_->edited().setDeformers(deformers);
}

RenderReport Renderer::report() const {
  return implementation_->report();
}

void Renderer::replacePositions(std::size_t object, std::span<const Vec3> positionsMm) {
  implementation_->edited().replacePositions(device(), object, positionsMm);
}

void Renderer::replacePositions(std::size_t object, const DevicePositions& positions) {
  implementation_->edited().replacePositions(device(), object, positions);
}

void Renderer::restorePositions(std::size_t object) {
  implementation_->edited().restorePositions(object);
}

VulkanDevice Renderer::vulkanDevice() const {
  return implementation_->vulkanDevice();
}

std::size_t Renderer::validationMessages() const {
  return implementation_->device().validationMessages();
}

gpu::Device& Renderer::device() {
  return implementation_->device();
}

std::uint64_t Renderer::sceneNumber() const {
  return implementation_->edited().number();
}

std::size_t Renderer::vertexCount(std::size_t object) const {
  return implementation_->edited().object(object).mesh.positionsMm.size();
}

std::vector<DeviceDescription> listDevices() {
  std::vector<DeviceDescription> devices;
  for (const gpu::DeviceInfo& info : gpu::Device::list()) devices.push_back(describe(info));
  return devices;
}

}  // namespace opaline
