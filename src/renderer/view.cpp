#include "opaline/view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include "gpu/command_list.h"
#include "gpu/transfer.h"
#include "opaline/error.h"
#include "opaline/renderer.h"
#include "opaline/vulkan.h"
#include "renderer/context.h"
#include "renderer/frame/camera_view.h"
#include "renderer/frame/device_outputs.h"
#include "renderer/frame/frame.h"
#include "renderer/frame/frame_plan.h"
#include "renderer/frame/frame_queue.h"
#include "renderer/frame/given_camera.h"
#include "renderer/frame/light_views.h"
#include "renderer/frame/shadow_reuse.h"
#include "renderer/frame/sight_reuse.h"
#include "renderer/frame/timing.h"
#include "renderer/frame/view_resources.h"
#include "renderer/scene/opaque_tables.h"
#include "renderer/validate.h"

namespace opaline {

namespace {

const Object* firstOpaque(const Scene& scene) {
  const auto found = std::find_if(scene.objects.begin(), scene.objects.end(),
                                  [](const Object& object) { return object.opaque.has_value(); });
  return found != scene.objects.end() ? &*found : nullptr;
}

bool hasPaint(const Scene& scene) {
  return std::any_of(scene.objects.begin(), scene.objects.end(), isPainted);
}

bool hasOwnSurfaces(const Scene& scene) {
  return std::any_of(scene.objects.begin(), scene.objects.end(), hasOwnSurface);
}

void requireKnownToPattern(const Scene& scene) {
  if (const Object* const opaque = firstOpaque(scene))
    throw UsageError(fmt::format(
        "the pattern lights no opaque bodies and no ground, and object '{}' is opaque; the sums "
        "tree and all do, and LoadOptions::medium makes bodies translucent",
        opaque->name));
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
  frame.cameraPosition =
      camera.isParallel ? glm::vec4(-camera.axis, 0) : glm::vec4(camera.position, 1);
  frame.cameraAxis = {camera.axis, 0};
  fillLights(lighting, static_cast<std::uint32_t>(shadowSize), frame);
  fillSamples(samples, frame);
  return frame;
}

// Whether the camera's numbers fit into floats.
bool fitsFloats(const CameraView& view) {
  const auto areFinite = [](const auto& of) {
    const float* const first = glm::value_ptr(of);
    return std::all_of(first, first + sizeof of / sizeof *first,
                       [](float value) { return std::isfinite(value); });
  };
  const glm::mat4 rows = glm::transpose(view.worldToClip);
  constexpr float least = std::numeric_limits<float>::min();
  return areFinite(rows) && areFinite(view.position) && areFinite(view.axis) &&
         glm::length(glm::vec3(rows[0])) > least && glm::length(glm::vec3(rows[1])) > least;
}

// Converts points on timelines to the device's form.
class PointsOf {
 public:
  PointsOf(std::span<const TimelinePoint> given, const char* name) : count_(given.size()) {
    if (count_ > points_.size())
      throw UsageError(
          fmt::format("{} has {} points; there may be {}", name, count_, points_.size()));
    for (std::size_t i = 0; i < count_; ++i) {
      if (given[i].semaphore == VK_NULL_HANDLE)
        throw UsageError(fmt::format("{}: point {} has no semaphore", name, i));
      points_[i] = {given[i].semaphore, given[i].value};
    }
  }
  std::span<const gpu::SemaphoreValue> points() const { return std::span(points_).first(count_); }

 private:
  std::array<gpu::SemaphoreValue, gpu::Device::mostSemaphores> points_;
  std::size_t count_ = 0;
};

}  // namespace

class View::Implementation {
 public:
  Implementation(RendererContext& context, const RenderOptions& options)
      : context_(context),
        queue_(context.device),
        frameData_(context.device, "frame data", sizeof(shared::FrameData), framesInFlight, 0),
        outputs_(context.device),
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
    matrices_.reset();
  }

  void setCamera(const CameraMatrices& matrices) {
    const GivenCamera camera =
        makeGivenCamera(matrices, context_.edited.origin(), options_.width, options_.height);
    if (!fitsFloats(camera.view))
      throw UsageError("CameraMatrices: what they show is too large or too small for a camera");
    matrices_ = matrices;
  }

  RenderResult render(const FrameOrder& order) {
    if (!queue_.isEmpty())
      throw UsageError("frames wait to be collected; collect them before calling render");
    times_.clear();
    Frame frame;
    submit({}, order);
    collect(frame);
    return {std::move(frame.images), report()};
  }

  void submit(const FrameSubmission& submission, const FrameOrder& order) {
    const PointsOf waits(submission.waits, "FrameSubmission::waits");
    const PointsOf signals(submission.signals, "FrameSubmission::signals");
    make(order, submission.outputs, [&] { queue_.submit(waits.points(), signals.points()); });
  }

  void record(const FrameRecording& recording, const FrameOrder& order) {
    if (recording.commands == VK_NULL_HANDLE || recording.finished.semaphore == VK_NULL_HANDLE)
      throw UsageError("FrameRecording needs commands and the point at which they have finished");
    make(order, recording.outputs, [&] {
      queue_.recordInto(recording.commands,
                        {recording.finished.semaphore, recording.finished.value});
    });
  }

  void prepare(const FrameOrder& order) {
    FramePlan plan = planOf(order, {});
    orAnew([&] { follow(plan, order); });
  }

  void collect(Frame& frame) {
    counts_ = queue_.collect(frame, times_);
    solutions_ = frame.solutions;
  }

  DeviceBuffer exitance(std::size_t object) const {
    if (!exitanceShown_)
      throw UsageError("the last frame did not leave the exitance of vertices on the device");
    const ExitanceRange range = exitanceRange(context_.edited.motion().ranges(), object);
    return {resources_.made().exitance.vertices.handle(), range.offset, range.bytes};
  }

  DeviceImage picture() const {
    if (!shown_) throw UsageError("the last frame did not leave its picture on the device");
    return shownAs(resources_.made().radiance);
  }

  DeviceImage picture(Aov aov) const {
    const auto index = static_cast<std::size_t>(aov);
    if (index >= variablesOfCentres || !shownAovs_.test(index))
      throw UsageError("the last frame did not leave that variable on the device");
    const FrameResources& made = resources_.made();
    return shownAs(aov == Aov::Radiance ? made.radiance : made.variables[index]);
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
  static DeviceImage shownAs(const gpu::GpuImage& image) {
    return {image.handle(), image.view(), image.options().format,
            gpu::scopeOf(gpu::Access::Sampled).layout, image.extent()};
  }

  FramePlan planOf(const FrameOrder& order, const DeviceOutputs& outputs) {
    validate(options_, order.aovs);
    validate(options_, order.aovsOnDevice);
    if (std::any_of(order.aovsOnDevice.begin(), order.aovsOnDevice.end(), showsMap))
      throw UsageError("FrameOrder::aovsOnDevice has a variable of the diffusion source map");
    validate(outputs, options_, matrices_.has_value());
    if (order.exitance && options_.site != Site::Vertex)
      throw UsageError("FrameOrder::exitance needs RenderOptions::site Site::Vertex");
    EditedScene& edited = context_.edited;
    edited.beginFrame();
    if (options_.sum == Sum::Pattern) requireKnownToPattern(edited.scene());
    FramePlan plan = planFor(options_, order, order.onDevice || outputs.over != nullptr,
                             order.exitance || !outputs.exitances.empty());
    plan.time = edited.time();
    plan.opaque = firstOpaque(edited.scene()) != nullptr;
    plan.painted = hasPaint(edited.scene());
    plan.ownSurfaces = hasOwnSurfaces(edited.scene());
    plan.mirrorsBodies = mirrorsBodies(plan, edited.scene());
    return plan;
  }

  // Makes a frame, which `hand` submits or records.
  template <typename Hand>
  void make(const FrameOrder& order, const DeviceOutputs& outputs, const Hand& hand) {
    FramePlan plan = planOf(order, outputs);
    queue_.requireRoom();
    shown_ = exitanceShown_ = false;
    shownAovs_.reset();
    if (std::exchange(scene_, context_.edited.number()) != context_.edited.number()) times_.clear();
    orAnew([&] {
      const SceneChanges changes = follow(plan, order);
      plan.light =
          prepared_->light().mustFind(options_, plan, order.reuseLight, changes, resources_);
      plan.shape =
          plan.light && prepared_->shape().mustFind(options_, plan, order.reuseLight, changes);
      const GivenCamera given = givenCamera();
      plan.sight = mustFindSight(options_, plan, order.reuseLight, changes, given.view, resources_);
      const shared::FrameData data = frameOf(plan, given.view);
      plan.shadows = shadowsToDraw(plan, order.reuseLight, changes, data, resources_);
      plan_ = plan;
      fill(order, outputs, given, data);
      hand();
    });
    shown_ = order.onDevice;
    for (const Aov aov : order.aovsOnDevice) shownAovs_.set(static_cast<std::size_t>(aov));
    exitanceShown_ = order.exitance;
  }

  SceneChanges follow(FramePlan& plan, const FrameOrder& order) {
    EditedScene& edited = context_.edited;
    const Lighting& lighting = edited.lighting();
    prepared_ = context_.prepared.share(options_, plan, edited, std::move(prepared_));
    prepared_->prepare(options_, plan, order.patient, edited);
    const SceneChanges changes = prepared_->changes(edited);
    resources_.follow(options_, plan, prepared_->scene(), edited, changes);
    fitToScene(prepared_->scene(), lighting, plan);
    return changes;
  }

  template <typename Work>
  void orAnew(const Work& work) {
    try {
      work();
    } catch (...) {
      startAnew();
      throw;
    }
  }

  // After a failure, what was noted as made or lit may not be: the next frame remakes everything.
  void startAnew() {
    queue_.abandon();
    context_.edited.motion().abandon();
    if (prepared_) prepared_->clear();
    resources_.forget();
  }

  shared::FrameData frameOf(const FramePlan& plan, const CameraView& camera) const {
    const EditedScene& edited = context_.edited;
    shared::FrameData data =
        makeFrameData(edited.lighting(), camera, options_.shadowSize, plan.samples);
    data.cameraAxis.w = groundOf(edited.scene()) ? 1.0F : 0.0F;
    return data;
  }

  void fill(const FrameOrder& order, const DeviceOutputs& outputs, const GivenCamera& given,
            const shared::FrameData& data) {
    SceneResources& prepared = prepared_->scene();
    FrameResources& resources = resources_.made();
    const CameraView& camera = given.view;
    frameData_.nextFrame();
    const FrameUpload upload{frameData_.buffer(), frameData_.push(data)};

    FrameSlot& slot = queue_.next();
    slot.provisional = prepared_->isProvisional();
    slot.toHost = !order.aovs.empty();
    slot.readback.prepare(context_.device, order.aovs, camera, context_.edited.origin(), resources);
    slot.commands.begin();
    recordFrame(slot.commands, context_.passes, plan_, upload, context_.edited.motion(), prepared,
                resources);
    slot.readback.record(slot.commands, resources, solves(plan_) ? plan_.bounces + 1 : 0,
                         prepared.solver);
    if (order.onDevice) slot.commands.use(resources.radiance, gpu::Access::Sampled);
    if (order.exitance) slot.commands.use(resources.exitance.vertices, gpu::Access::Lent);
    outputs_.record(slot.commands, order, outputs,
                    {prepared.mesh, resources, context_.edited.motion().ranges(), given.depth,
                     camera, context_.edited.origin()});
  }

  GivenCamera givenCamera() const {
    if (matrices_)
      return makeGivenCamera(*matrices_, context_.edited.origin(), options_.width, options_.height);
    const Camera camera = camera_ ? context_.edited.seen(*camera_) : context_.edited.camera();
    const float aspect = static_cast<float>(options_.width) / static_cast<float>(options_.height);
    return {makeCameraView(camera, aspect), {}};
  }

  RendererContext& context_;
  RenderOptions options_;
  std::optional<Camera> camera_;            // none: the scene's
  std::optional<CameraMatrices> matrices_;  // take the place of a camera
  FrameQueue queue_;
  gpu::UploadRing frameData_;
  OutputRecorder outputs_;
  std::shared_ptr<PreparedScene> prepared_;  // null before the first frame
  ViewResources resources_;
  bool exitanceShown_ = false;                 // the last frame left its exitance on the device
  bool shown_ = false;                         // the last frame left its picture on the device
  std::bitset<variablesOfCentres> shownAovs_;  // the same for other variables
  std::uint64_t scene_ = 0;                    // number of the scene that was rendered last
  FramePlan plan_;                             // of the frame submitted last
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
  present(implementation_, "view").setOptions(options);
}

const RenderOptions& View::options() const {
  return present(implementation_, "view").options();
}

void View::setCamera(const std::optional<Camera>& camera) {
  present(implementation_, "view").setCamera(camera);
}

RenderResult View::render(const FrameOrder& order) {
  return present(implementation_, "view").render(order);
}

void View::setCamera(const CameraMatrices& matrices) {
  present(implementation_, "view").setCamera(matrices);
}

void View::submit(const FrameOrder& order) {
  present(implementation_, "view").submit({}, order);
}

void View::submit(const FrameSubmission& submission, const FrameOrder& order) {
  present(implementation_, "view").submit(submission, order);
}

void View::prepare(const FrameOrder& order) {
  present(implementation_, "view").prepare(order);
}

void View::record(const FrameRecording& recording, const FrameOrder& order) {
  present(implementation_, "view").record(recording, order);
}

DeviceBuffer View::exitance(std::size_t object) const {
  return present(implementation_, "view").exitance(object);
}

void View::collect(Frame& frame) {
  present(implementation_, "view").collect(frame);
}

DeviceImage View::picture() const {
  return present(implementation_, "view").picture();
}

DeviceImage View::picture(Aov aov) const {
  return present(implementation_, "view").picture(aov);
}

RenderReport View::report() const {
  return present(implementation_, "view").report();
}

}  // namespace opaline
