#include "opaline/renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include <glm/gtc/type_ptr.hpp>

#include "gpu/command_list.h"
#include "gpu/device.h"
#include "gpu/transfer.h"
#include "opaline/error.h"
#include "opaline/vulkan.h"
#include "renderer/camera_view.h"
#include "renderer/frame.h"
#include "renderer/light_views.h"
#include "renderer/pattern_layout.h"
#include "renderer/readback.h"
#include "renderer/scene_motion.h"
#include "renderer/scene_resources.h"
#include "renderer/scene_tables.h"
#include "renderer/timing.h"
#include "renderer/validate.h"

namespace opaline {

namespace {

DeviceDescription describe(const gpu::DeviceInfo& info) {
  return {info.name, gpu::toString(info.type), info.driver};
}

// What is asked for, or where all objects agree, that; Auto where they do not.
Site chooseSite(const RenderOptions& options, const SceneResources& resources) {
  if (options.site != Site::Auto) return options.site;
  std::size_t atVertices = 0;
  for (std::size_t i = 0; i < resources.objects; ++i)
    if (wantsVertices(resources, i)) ++atVertices;
  if (atVertices == resources.objects) return Site::Vertex;
  return atVertices == 0 || options.sum == Sum::Pattern ? Site::Fragment : Site::Auto;
}

bool needsMap(const RenderOptions& options, const std::vector<Aov>& aovs) {
  return options.sum == Sum::Pattern ||
         std::any_of(aovs.begin(), aovs.end(), [](Aov aov) { return showsMap(aov); });
}

FramePlan makePlan(const RenderOptions& options, const std::vector<Aov>& aovs, Site site,
                   bool skyIsDark, const SceneResources& resources) {
  // Where nothing has an inside, boundary transport is what it falls back to.
  const bool halfSpaces = options.transport == Transport::Boundary && !resources.hasInside();
  return {.transport = halfSpaces ? Transport::BetterDipole : options.transport,
          .sum = options.sum,
          .site = site,
          .tolerance = options.tolerance,
          .bounces = options.bounces,
          .skyIsDark = skyIsDark,
          .map = needsMap(options, aovs),
          .samples = std::find(aovs.begin(), aovs.end(), Aov::Radiance) != aovs.end()
                         ? options.antialias
                         : 0,
          .centre = std::any_of(aovs.begin(), aovs.end(), needsCentre),
          .specular = options.specular,
          .roughness = options.roughness,
          .clip = options.clip,
          .seconds = options.seconds};
}

// Every pass of a frame: deform, normals, fit, shadow, map, neighbours, surfels, tree; of boundary
// transport the rays' boxes, clusters, their rays, rays and sources of every light, sources of
// every bounce, as many solutions, means and what is carried to vertices; estimate, scatter and
// nearby at the vertices and at the surfels; and surface, scatter, nearby, carry and shade for each
// look, of which there are as many as antialiasing samples and one at the pixels' centres.
constexpr std::uint32_t maxPassesOfFrame =
    8 + (3 + 2 * (shared::maxLights + 1) + 3 * (maxBounces + 1) + 2) + 2 * 3 + 5 * (8 + 1);

// One of the frames that may be under way.
struct FrameSlot {
  explicit FrameSlot(gpu::Device& device) : commands(device, "frame", maxPassesOfFrame) {}

  gpu::CommandList commands;
  Readback readback;
};

}  // namespace

class Renderer::Implementation {
 public:
  explicit Implementation(const RendererOptions& options)
      : device_({.selector = options.device, .validation = options.validation, .log = options.log}),
        log_(options.log),
        passes_(device_),
        slots_{FrameSlot(device_), FrameSlot(device_)},
        frameData_(device_, "frame data", sizeof(shared::FrameData), framesInFlight, 0) {}

  // Frames may still be under way.
  ~Implementation() { device_.waitIdle(); }
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  void setScene(const Scene& scene) {
    validate(scene);
    device_.waitIdle();
    ++sceneNumber_;
    waiting_ = 0;
    resources_.reset();
    motion_.reset();
    uploaded_.reset();
    times_.clear();
    scene_.reset();
    scene_ = std::make_unique<const Scene>(scene);
    try {
      merged_ = scene::mergedMesh(*scene_);
      motion_.emplace(device_, *scene_, merged_);
    } catch (...) {
      scene_.reset();  // half a scene is none
      throw;
    }
  }

  RenderResult render(const RenderOptions& options, const std::vector<Aov>& aovs) {
    if (waiting_ > 0)
      throw UsageError("frames wait to be collected; collect them before calling render");
    FrameTimes times;
    for (int i = 0; i < std::max(options.frames, 1); ++i) {
      submit(options, aovs);
      finishOldest(frame_, times);
    }
    return {std::move(frame_.images), makeReport(times)};
  }

  void submit(const RenderOptions& options, const std::vector<Aov>& aovs) {
    validate(options);
    if (!scene_) throw Error("no scene is set; call setScene first");
    requireClip(options.clip);
    if (waiting_ >= framesInFlight)
      throw UsageError(fmt::format(
          "{} frames are under way, which is all there may be; collect one first", waiting_));
    prepare(options, aovs);
    last_ = options;
    site_ = chooseSite(options, *uploaded_);
    const CameraView camera = makeCameraView(
        scene_->camera, static_cast<float>(options.width) / static_cast<float>(options.height));
    frameData_.nextFrame();
    const FrameUpload upload{frameData_.buffer(), frameData_.push(makeFrameData(camera, options))};

    FrameSlot& slot = slots_[next_];
    slot.readback.prepare(device_, aovs, site_, camera, *resources_);
    slot.commands.begin();
    recordFrame(slot.commands, passes_, makePlan(options, aovs, site_, skyIsDark(), *uploaded_),
                upload, *motion_, *uploaded_, *resources_);
    slot.readback.record(slot.commands, site_, *resources_);
    const bool boundary = options.transport == Transport::Boundary && uploaded_->hasInside();
    slot.readback.recordSolutions(slot.commands, boundary ? options.bounces + 1 : 0,
                                  uploaded_->solver);
    slot.commands.submit();
    next_ = (next_ + 1) % slots_.size();
    ++waiting_;
  }

  void collect(Frame& frame) {
    if (waiting_ == 0) throw UsageError("no frame is under way; submit one first");
    finishOldest(frame, times_);
  }

  RenderReport report() const {
    if (!uploaded_ || !resources_) throw UsageError("there is no report before the first frame");
    return makeReport(times_);
  }

  template <typename Positions>
  void replacePositions(std::size_t object, const Positions& positions) {
    motion().given().give(device_, object, positions, motion().tables());
  }

  void restorePositions(std::size_t object) { motion().given().restore(object); }

  VulkanDevice vulkanDevice() const {
    return {device_.instance(), device_.physical(), device_.handle(), device_.queueFamily(),
            device_.queue()};
  }

  std::size_t validationMessages() const { return device_.validationMessages(); }

  gpu::Device& device() { return device_; }

  std::uint64_t sceneNumber() const { return sceneNumber_; }

  std::size_t vertexCount(std::size_t object) const {
    if (!scene_) throw Error("no scene is set; call setScene first");
    if (object >= scene_->objects.size())
      throw UsageError(
          fmt::format("there is no object {}: the scene has {}", object, scene_->objects.size()));
    return scene_->objects[object].mesh.positionsMm.size();
  }

 private:
  void requireClip(int clip) const {
    const auto clips = static_cast<int>(scene_->clips.size());
    if (clip > 0 && clip >= clips)
      throw UsageError(fmt::format("there is no clip {}: the scene has {}", clip, clips));
  }

  // Waits for the oldest frame under way and takes its pictures.
  void finishOldest(Frame& frame, FrameTimes& times) {
    FrameSlot& slot = slots_[(next_ + slots_.size() - waiting_) % slots_.size()];
    --waiting_;
    slot.commands.wait();
    slot.readback.finish(frame.images);
    slot.readback.finishSolutions(frame.solutions);
    solutions_ = frame.solutions;
    const std::vector<gpu::PassTiming>& timings = slot.commands.timings();
    frame.milliseconds = slot.commands.frameMilliseconds();
    frame.passes.resize(timings.size());
    for (std::size_t i = 0; i < timings.size(); ++i) {
      frame.passes[i].name = timings[i].name;
      frame.passes[i].milliseconds = timings[i].milliseconds;
    }
    times.add(frame.milliseconds, timings);
  }

  // Makes what depends on the scene and the options, where it is not there yet. What one sum needs
  // is kept for when it is asked for again.
  void prepare(const RenderOptions& options, const std::vector<Aov>& aovs) {
    SceneNeeds needs = uploaded_ ? uploaded_->needs : SceneNeeds{};
    if (needsMap(options, aovs)) needs.mapSize = options.dsmSize;
    if (options.sum != Sum::Pattern) needs.maxSurfels = options.maxSources;
    if (options.transport == Transport::Boundary) needs.maxClusters = options.boundarySurfels;
    const bool isUploaded = uploaded_ && uploaded_->needs == needs;
    if (isUploaded && resources_ && sameTables(prepared_, options)) return;
    device_.waitIdle();
    resources_.reset();
    if (!isUploaded) {
      uploaded_.reset();
      uploaded_ = makeSceneResources(device_, *scene_, merged_, needs, log_);
    }
    prepared_ = options;
    if (needs.mapSize) prepared_.dsmSize = *needs.mapSize;  // kept, if no map is asked for now
    resources_ = makeFrameResources(prepared_);
  }

  bool skyIsDark() const {
    const Lighting& lighting = scene_->lighting;
    return !lighting.environment && lighting.ambient == Rgb{0, 0, 0};
  }

  static bool sameTables(const RenderOptions& a, const RenderOptions& b) {
    return a.width == b.width && a.height == b.height && a.transport == b.transport &&
           a.pattern.nearRings == b.pattern.nearRings &&
           a.pattern.nearSpacing == b.pattern.nearSpacing &&
           a.pattern.farDistance == b.pattern.farDistance && a.shadowSize == b.shadowSize &&
           a.roughness == b.roughness;
  }

  SceneMotion& motion() {
    if (!motion_) throw Error("no scene is set; call setScene first");
    return *motion_;
  }

  FrameResources makeFrameResources(const RenderOptions& options) {
    const auto width = static_cast<std::uint32_t>(options.width);
    const auto height = static_cast<std::uint32_t>(options.height);
    FrameResources made;
    made.view = passes::FitPass::makeView(device_);
    made.view.shadowViews = shadowViewCount(scene_->lighting);
    std::optional<PatternLayout> pattern;
    if (uploaded_->needs.mapSize) {
      pattern = layOutPattern(*uploaded_, options);
      made.sources =
          passes_.map.prepare(device_, uploaded_->mesh,
                              static_cast<std::uint32_t>(*uploaded_->needs.mapSize), pattern->maps);
    } else {
      made.sources.charts =
          gpu::makeBuffer(device_, "no charts", {}, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    }
    made.tables = makeSceneTables(device_, *uploaded_, pattern, scene_->lighting, options);
    made.shadows = passes::ShadowPass::makeMaps(
        device_, static_cast<std::uint32_t>(options.shadowSize), made.view.shadowViews);
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
    fillLights(scene_->lighting, static_cast<std::uint32_t>(options.shadowSize), frame);
    frame.counts.z = scene_->lighting.environment ? 1 : 0;
    frame.ambient = {glm::make_vec3(scene_->lighting.ambient.data()), 0};
    return frame;
  }

  RenderReport makeReport(const FrameTimes& times) const {
    constexpr double megabyte = 1e6;
    return {.device = describe(device_.info()),
            .transport = last_.transport,
            .sum = last_.sum,
            .site = site_,
            .triangles = uploaded_->triangles,
            .vertices = uploaded_->mesh.vertexCount,
            .sources = last_.sum == Sum::Pattern ? resources_->sources.sourceCount
                                                 : uploaded_->surfels.count,
            .boundarySurfels = last_.transport == Transport::Boundary && uploaded_->hasInside()
                                   ? uploaded_->clusters.count
                                   : 0,
            .solutions = solutions_,
            .passes = times.passes(),
            .frameMilliseconds = times.frameMilliseconds(),
            .peakMemoryMegabytes = static_cast<double>(device_.peakMemoryBytes()) / megabyte};
  }

  gpu::Device device_;
  LogCallback log_;
  Passes passes_;
  std::array<FrameSlot, framesInFlight> slots_;
  std::size_t next_ = 0;     // slot of the next frame
  std::size_t waiting_ = 0;  // frames submitted and not collected
  gpu::UploadRing frameData_;
  std::uint64_t sceneNumber_ = 0;
  std::unique_ptr<const Scene> scene_;
  scene::MergedMesh merged_;
  std::optional<SceneMotion> motion_;
  std::optional<SceneResources> uploaded_;
  std::optional<FrameResources> resources_;
  RenderOptions prepared_;  // what resources_ were made for
  RenderOptions last_;      // of the frame submitted last
  Site site_ = Site::Fragment;
  FrameTimes times_;
  std::vector<Solution> solutions_;  // of the frame collected last
  Frame frame_;                      // of render()
};

bool showsMap(Aov aov) {
  return aov == Aov::Irradiance || aov == Aov::DsmPosition || aov == Aov::DsmNormal ||
         aov == Aov::DsmIrradiance || aov == Aov::DsmArea;
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

void Renderer::collect(Frame& frame) {
  implementation_->collect(frame);
}

RenderReport Renderer::report() const {
  return implementation_->report();
}

void Renderer::replacePositions(std::size_t object, std::span<const Vec3> positionsMm) {
  implementation_->replacePositions(object, positionsMm);
}

void Renderer::replacePositions(std::size_t object, const DevicePositions& positions) {
  implementation_->replacePositions(object, positions);
}

void Renderer::restorePositions(std::size_t object) {
  implementation_->restorePositions(object);
}

VulkanDevice Renderer::vulkanDevice() const {
  return implementation_->vulkanDevice();
}

std::size_t Renderer::validationMessages() const {
  return implementation_->validationMessages();
}

gpu::Device& Renderer::device() {
  return implementation_->device();
}

std::uint64_t Renderer::sceneNumber() const {
  return implementation_->sceneNumber();
}

std::size_t Renderer::vertexCount(std::size_t object) const {
  return implementation_->vertexCount(object);
}

std::vector<DeviceDescription> listDevices() {
  std::vector<DeviceDescription> devices;
  for (const gpu::DeviceInfo& info : gpu::Device::list()) devices.push_back(describe(info));
  return devices;
}

}  // namespace opaline
