#include "opaline/view.h"

#include <algorithm>
#include <utility>

#include "gpu/command_list.h"
#include "gpu/transfer.h"
#include "opaline/error.h"
#include "opaline/renderer.h"
#include "opaline/vulkan.h"
#include "renderer/context.h"
#include "renderer/frame/camera_view.h"
#include "renderer/frame/frame.h"
#include "renderer/frame/frame_plan.h"
#include "renderer/frame/frame_queue.h"
#include "renderer/frame/light_views.h"
#include "renderer/frame/timing.h"
#include "renderer/frame/view_resources.h"
#include "renderer/scene/opaque_tables.h"
#include "renderer/validate.h"

namespace opaline {

namespace {

bool hasOpaque(const Scene& scene) {
  return std::any_of(scene.objects.begin(), scene.objects.end(),
                     [](const Object& object) { return object.opaque.has_value(); });
}

bool hasPaint(const Scene& scene) {
  return std::any_of(scene.objects.begin(), scene.objects.end(), isPainted);
}

bool hasOwnSurfaces(const Scene& scene) {
  return std::any_of(scene.objects.begin(), scene.objects.end(), hasOwnSurface);
}

void requireKnownToPattern(const Scene& scene) {
  if (hasOpaque(scene))
    throw UsageError(
        "the pattern lights no opaque bodies and no ground; the sums tree and all do, and "
        "LoadOptions::medium makes bodies translucent");
  if (hasPaint(scene))
    throw UsageError("the pattern knows no paint, and a body is painted; the sums tree and all do");
  if (std::any_of(scene.objects.begin(), scene.objects.end(), hasOwnNormals))
    throw UsageError(
        "the pattern knows no normal textures, and a body has one; the sums tree and all do");
  if (!scene.lighting.areas.empty())
    throw UsageError(
        "the pattern has no surfels that area lights could shine on; the sums tree and all have");
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

class View::Implementation {
 public:
  Implementation(RendererContext& context, const RenderOptions& options)
      : context_(context),
        queue_(context.device),
        frameData_(context.device, "frame data", sizeof(shared::FrameData), framesInFlight, 0),
        resources_(context.device, context.passes) {
    setOptions(options);
  }

  void setOptions(const RenderOptions& options) {
    validate(options);
    options_ = options;
  }
  const RenderOptions& options() const { return options_; }

  void setCamera(const std::optional<Camera>& camera) {
    if (camera) validate(*camera);
    camera_ = camera;
  }

  RenderResult render(const FrameOrder& order) {
    if (!queue_.isEmpty())
      throw UsageError("frames wait to be collected; collect them before calling render");
    times_.clear();
    Frame frame;
    submit(order);
    collect(frame);
    return {std::move(frame.images), report()};
  }

  void submit(const FrameOrder& order) {
    validate(options_, order.aovs);
    queue_.requireRoom();
    shown_ = false;
    EditedScene& edited = context_.edited;
    edited.beginFrame();
    if (std::exchange(scene_, edited.number()) != edited.number()) times_.clear();
    if (options_.sum == Sum::Pattern) requireKnownToPattern(edited.scene());
    FramePlan plan = planFor(options_, order.aovs, order.onDevice);
    plan.time = edited.time();
    plan.opaque = hasOpaque(edited.scene());
    plan.painted = hasPaint(edited.scene());
    plan.ownSurfaces = hasOwnSurfaces(edited.scene());
    try {
      submit(plan, order);
    } catch (...) {
      startAnew();
      throw;
    }
    shown_ = order.onDevice;
  }

  void collect(Frame& frame) {
    counts_ = queue_.collect(frame, times_);
    solutions_ = frame.solutions;
  }

  DeviceImage picture() const {
    if (!shown_) throw UsageError("the last frame did not leave its picture on the device");
    const gpu::GpuImage& radiance = resources_.made().radiance;
    return {radiance.handle(), radiance.view(), radiance.options().format,
            gpu::scopeOf(gpu::Access::Sampled).layout, radiance.extent()};
  }

  RenderReport report() const {
    if (times_.empty() || scene_ != context_.edited.number())
      throw UsageError("there is no report before the first frame");
    constexpr double megabyte = 1e6;
    const SceneResources& scene = prepared_->scene();
    const bool solved = plan_.transport == Transport::Boundary;
    return {
        .device = describe(context_.device.info()),
        .transport = plan_.transport,
        .sum = plan_.sum,
        .site = plan_.site,
        .triangles = scene.triangles,
        .vertices = scene.mesh.vertexCount,
        .sources = plan_.sum == Sum::Pattern ? resources_.made().map->sources.sourceCount
                                             : scene.surfels.count,
        .clusters = solved ? scene.clusters.count : 0,
        .solutions = solutions_,
        .passes = times_.passes(),
        .frameMilliseconds = times_.frameMilliseconds(),
        .dispatches = counts_.dispatches,
        .barriers = counts_.barriers,
        .recordings = counts_.recordings,
        .peakMemoryMegabytes = static_cast<double>(context_.device.peakMemoryBytes()) / megabyte};
  }

 private:
  void submit(FramePlan& plan, const FrameOrder& order) {
    EditedScene& edited = context_.edited;
    const Lighting& lighting = edited.lighting();
    prepared_ = context_.prepared.share(options_, plan, lighting, std::move(prepared_));
    prepared_->prepare(options_, plan, order.patient, edited);
    const SceneChanges changes = prepared_->changes(edited);
    resources_.follow(options_, plan, prepared_->scene(), edited, changes);
    fitToScene(prepared_->scene(), lighting, plan);
    plan.light = prepared_->light().mustFind(options_, plan, order.reuseLight, changes, resources_);
    plan_ = plan;
    record(order);
    queue_.submit();
  }

  // What was noted as made or lit may not have been: the next frame makes all of it.
  void startAnew() {
    queue_.abandon();
    if (prepared_) prepared_->clear();
    resources_.forget();
  }

  void record(const FrameOrder& order) {
    const Scene& scene = context_.edited.scene();
    SceneResources& prepared = prepared_->scene();
    FrameResources& resources = resources_.made();
    const CameraView camera =
        makeCameraView(camera_.value_or(scene.camera),
                       static_cast<float>(options_.width) / static_cast<float>(options_.height));
    frameData_.nextFrame();
    shared::FrameData data =
        makeFrameData(context_.edited.lighting(), camera, options_.shadowSize, plan_.samples);
    data.cameraAxis.w = groundOf(scene) ? 1.0F : 0.0F;
    const FrameUpload upload{frameData_.buffer(), frameData_.push(data)};
    const bool solves = plan_.transport == Transport::Boundary && plan_.scatter;

    FrameSlot& slot = queue_.next();
    slot.provisional = prepared_->isProvisional();
    slot.readback.prepare(context_.device, order.aovs, camera, resources);
    slot.commands.begin();
    recordFrame(slot.commands, context_.passes, plan_, upload, context_.edited.motion(), prepared,
                resources);
    slot.readback.record(slot.commands, resources);
    slot.readback.recordSolutions(slot.commands, solves ? plan_.bounces + 1 : 0, prepared.solver);
    if (order.onDevice) slot.commands.use(resources.radiance, gpu::Access::Sampled);
  }

  RendererContext& context_;
  RenderOptions options_;
  std::optional<Camera> camera_;  // none: the scene's
  FrameQueue queue_;
  gpu::UploadRing frameData_;
  std::shared_ptr<PreparedScene> prepared_;  // none before the first frame
  ViewResources resources_;
  bool shown_ = false;       // the last frame's picture was left for others to sample
  std::uint64_t scene_ = 0;  // number of the scene that was rendered last
  FramePlan plan_;           // of the frame submitted last
  FrameTimes times_;
  gpu::CommandCounts counts_;        // of the last frame
  std::vector<Solution> solutions_;  // of the frame collected last
};

View::View(Renderer& renderer, const RenderOptions& options)
    : implementation_(std::make_unique<Implementation>(renderer.context(), options)) {}
View::~View() = default;
View::View(View&&) noexcept = default;
View& View::operator=(View&&) noexcept = default;

void View::setOptions(const RenderOptions& options) {
  implementation_->setOptions(options);
}

const RenderOptions& View::options() const {
  return implementation_->options();
}

void View::setCamera(const std::optional<Camera>& camera) {
  implementation_->setCamera(camera);
}

RenderResult View::render(const FrameOrder& order) {
  return implementation_->render(order);
}

void View::submit(const FrameOrder& order) {
  implementation_->submit(order);
}

void View::collect(Frame& frame) {
  implementation_->collect(frame);
}

DeviceImage View::picture() const {
  return implementation_->picture();
}

RenderReport View::report() const {
  return implementation_->report();
}

}  // namespace opaline
