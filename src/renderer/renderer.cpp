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
#include "renderer/background_divider.h"
#include "renderer/camera_view.h"
#include "renderer/frame.h"
#include "renderer/light_views.h"
#include "renderer/prepared_frames.h"
#include "renderer/readback.h"
#include "renderer/scene_motion.h"
#include "renderer/scene_resources.h"
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

bool same(const std::optional<Image>& a, const std::optional<Image>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->width == b->width && a->height == b->height && a->rgba == b->rgba;
}

// Whether light found for one frame is that of another: all but the camera and what is made of it.
bool holds(const PreparedFrame::Lit& lit, const PreparedFrame::Lit& now) {
  const RenderOptions& a = lit.options;
  const RenderOptions& b = now.options;
  return lit.changes == now.changes && lit.site == now.site && lit.map >= now.map &&
         a.transport == b.transport && a.sum == b.sum && a.tolerance == b.tolerance &&
         a.bounces == b.bounces;
}

// Every pass of a frame: deform, normals, fit, shadow, map, neighbours, surfels, tree; of boundary
// transport the rays' boxes, clusters, their rays, rays and sources of every light, sources of
// every bounce, as many solutions, means and what is carried to vertices; estimate, scatter and
// nearby at the vertices and at the surfels; and surface, scatter, nearby, carry and shade for each
// look, of which there are as many as antialiasing samples and one at the pixels' centres; and the
// surfels seen there.
constexpr std::uint32_t maxPassesOfFrame =
    8 + (3 + 2 * (shared::maxLights + 1) + 3 * (maxBounces + 1) + 2) + 2 * 3 + 5 * (8 + 1) + 1;

// One of the frames that may be under way.
struct FrameSlot {
  explicit FrameSlot(gpu::Device& device) : commands(device, "frame", maxPassesOfFrame) {}

  gpu::CommandList commands;
  Readback readback;
  bool provisional = false;  // see Frame
};

}  // namespace

class Renderer::Implementation {
 public:
  explicit Implementation(const RendererOptions& options)
      : device_({.selector = options.device,
                 .validation = options.validation,
                 .log = options.log,
                 .instanceExtensions = options.instanceExtensions,
                 .deviceExtensions = options.deviceExtensions}),
        log_(options.log),
        passes_(device_),
        slots_{FrameSlot(device_), FrameSlot(device_)},
        frameData_(device_, "frame data", sizeof(shared::FrameData), framesInFlight, 0),
        prepared_(device_, passes_) {}

  // Frames may still be under way.
  ~Implementation() { device_.waitIdle(); }
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  void setScene(const Scene& scene) {
    validate(scene);
    device_.waitIdle();
    ++sceneNumber_;
    waiting_ = 0;
    forgetFrames();
    divider_.forget();
    motion_.reset();
    uploaded_.reset();
    times_.clear();
    scene_.reset();
    scene_ = std::make_unique<Scene>(scene);
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
    submit(options, aovs, makePlan(options, aovs));
  }

  DeviceImage submitOnDevice(const RenderOptions& options, const std::vector<Aov>& aovs) {
    FramePlan plan = makePlan(options, aovs);
    plan.samples = options.antialias;
    shown_ = true;
    submit(options, aovs, plan);
    const gpu::GpuImage& radiance = current_->resources.radiance;
    return {radiance.handle(), radiance.view(), radiance.options().format,
            gpu::scopeOf(gpu::Access::Sampled).layout, radiance.extent()};
  }

  void collect(Frame& frame) {
    if (waiting_ == 0) throw UsageError("no frame is under way; submit one first");
    finishOldest(frame, times_);
  }

  RenderReport report() const {
    if (!uploaded_ || current_ == nullptr)
      throw UsageError("there is no report before the first frame");
    return makeReport(times_);
  }

  template <typename Positions>
  void replacePositions(std::size_t object, const Positions& positions) {
    motion().given().give(device_, object, positions, motion().tables());
    ++changes_.pose;
  }

  void restorePositions(std::size_t object) {
    motion().given().restore(object);
    ++changes_.pose;
  }

  void setCamera(const Camera& camera) {
    validate(camera);
    scene().camera = camera;
  }

  void setLighting(const Lighting& lighting) {
    validate(lighting);
    Lighting& present = scene().lighting;
    ++changes_.lights;
    if (lighting.ambient != present.ambient || !same(lighting.environment, present.environment))
      ++changes_.sky;
    present = lighting;
  }

  void setMedium(std::size_t object, const Medium& medium) {
    validate(medium);
    if (object >= scene().objects.size())
      throw UsageError(
          fmt::format("there is no object {}: the scene has {}", object, scene_->objects.size()));
    scene().objects[object].medium = medium;
    ++changes_.media;
  }

  void setDeformers(const std::vector<Deformer>& deformers) {
    validate(deformers);
    scene().deformers = deformers;
    ++changes_.pose;
  }

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
    frame.provisional = slot.provisional;
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

  FramePlan makePlan(const RenderOptions& options, const std::vector<Aov>& aovs) const {
    return {.transport = options.transport,
            .sum = options.sum,
            .tolerance = options.tolerance,
            .bounces = options.bounces,
            .scatter = std::any_of(aovs.begin(), aovs.end(), needsScattering),
            .map = needsMap(options, aovs),
            .samples = std::find(aovs.begin(), aovs.end(), Aov::Radiance) != aovs.end()
                           ? options.antialias
                           : 0,
            .centre = std::any_of(aovs.begin(), aovs.end(), needsCentre),
            .seenSurfels = std::find(aovs.begin(), aovs.end(), Aov::Surfels) != aovs.end(),
            .treeLevel = options.treeLevel,
            .specular = options.specular,
            .roughness = options.roughness,
            .clip = options.clip,
            .seconds = options.seconds};
  }

  void submit(const RenderOptions& options, const std::vector<Aov>& aovs, FramePlan plan) {
    validate(options);
    validate(options, aovs);
    scene();
    requireClip(options.clip);
    if (waiting_ >= framesInFlight)
      throw UsageError(fmt::format(
          "{} frames are under way, which is all there may be; collect one first", waiting_));
    prepare(options, plan.map);
    if (plan.seenSurfels) prepareSeenSurfels();
    last_ = options;
    site_ = chooseSite(options, *uploaded_);
    plan.site = site_;
    plan.skyIsDark = skyIsDark();
    // Where nothing has an inside, boundary transport is what it falls back to.
    const bool boundary = plan.transport == Transport::Boundary && uploaded_->hasInside();
    if (plan.transport == Transport::Boundary && !boundary)
      plan.transport = Transport::BetterDipole;
    noteLight(options, plan);
    const CameraView camera = makeCameraView(
        scene_->camera, static_cast<float>(options.width) / static_cast<float>(options.height));
    frameData_.nextFrame();
    const FrameUpload upload{frameData_.buffer(), frameData_.push(makeFrameData(camera, options))};

    FrameResources& resources = current_->resources;
    FrameSlot& slot = slots_[next_];
    slot.readback.prepare(device_, aovs, site_, camera, resources);
    slot.commands.begin();
    recordFrame(slot.commands, passes_, plan, upload, *motion_, *uploaded_, resources);
    slot.readback.record(slot.commands, site_, resources);
    slot.readback.recordSolutions(slot.commands, boundary && plan.scatter ? options.bounces + 1 : 0,
                                  uploaded_->solver);
    // Whoever shows pictures may sample this frame's too.
    if (shown_) slot.commands.use(resources.radiance, gpu::Access::Sampled);
    slot.provisional = provisional();
    slot.commands.submit();
    next_ = (next_ + 1) % slots_.size();
    ++waiting_;
  }

  // Makes what depends on the scene and the options, where it is not there yet. What one sum needs
  // is kept for when it is asked for again.
  void prepare(const RenderOptions& options, bool map) {
    SceneNeeds needs = uploaded_ ? uploaded_->needs : SceneNeeds{};
    if (map) needs.mapSize = options.dsmSize;
    if (options.sum != Sum::Pattern) needs.maxSurfels = options.maxSources;
    if (options.transport == Transport::Boundary) needs.maxClusters = options.boundarySurfels;
    if (!uploaded_ || uploaded_->needs != needs) {
      device_.waitIdle();
      forgetFrames();
      uploaded_.reset();
      divider_.forget();
      uploaded_ = makeSceneResources(device_, scene(), merged_, needs, log_);
      media_ = changes_.media;
      noteDivision();
    } else {
      followMedia(options.patient);
    }
    if (uploaded_->needs.maxClusters) uploaded_->clusters.lights = lightCount(scene_->lighting);
    current_ = &prepared_.of(options, *uploaded_, scene_->lighting, changes_);
  }

  // Most frames are not asked which surfels they show.
  void prepareSeenSurfels() {
    if (!uploaded_->rays.boxes)
      uploaded_->rays = passes::RayPass::makeHierarchy(device_, uploaded_->surfels);
    FrameResources& resources = current_->resources;
    if (!resources.seenSurfels.image)
      resources.seenSurfels = passes::SeenSurfelsPass::makeSeen(device_, resources.surface);
  }

  // Brings the scene on the device in step with its media.
  void followMedia(bool patient) {
    if (media_ != changes_.media) {
      takeMedia(scene(), *uploaded_);
      noteDivision();
    }
    media_ = changes_.media;
    if (!provisional()) return;
    divider_.want(wanted_, merged_);
    const std::optional<Division> division = divider_.take(patient);
    if (!division || !(division->order == wanted_)) return;
    device_.waitIdle();
    takeDivision(device_, *division, *uploaded_);
    litSurfels_ = nullptr;
    ++changes_.media;  // tables name where surfels lie
    media_ = changes_.media;
  }

  bool provisional() { return uploaded_->needs.maxSurfels && !(uploaded_->divided == wanted_); }

  void noteDivision() {
    if (uploaded_->needs.maxSurfels) wanted_ = orderFor(device_, scene(), *uploaded_);
  }

  void forgetFrames() {
    current_ = nullptr;
    litSurfels_ = nullptr;
    prepared_.clear();
  }

  // Whether the frame's light has to be found, or is there from before.
  void noteLight(const RenderOptions& options, FramePlan& plan) {
    if (motion_->given().readsDevice() || options.seconds != pose_.seconds ||
        options.clip != pose_.clip)
      ++changes_.pose;
    pose_ = {options.seconds, options.clip};
    const PreparedFrame::Lit now{options, changes_, plan.site, plan.map};
    // Surfels and what boundary transport makes of them belong to the last frame that lit them.
    const bool ofSurfels = options.sum != Sum::Pattern && plan.site != Site::Vertex;
    const bool there =
        !(ofSurfels || plan.transport == Transport::Boundary) || litSurfels_ == current_;
    plan.light = !(options.reuseLight && there && current_->lit && holds(*current_->lit, now));
    if (!plan.light || !plan.scatter) return;
    current_->lit = now;
    if (options.sum != Sum::Pattern) litSurfels_ = current_;
  }

  bool skyIsDark() const {
    const Lighting& lighting = scene_->lighting;
    return !lighting.environment && lighting.ambient == Rgb{0, 0, 0};
  }

  Scene& scene() {
    if (!scene_) throw Error("no scene is set; call setScene first");
    return *scene_;
  }

  SceneMotion& motion() {
    scene();
    return *motion_;
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
            .sources = last_.sum == Sum::Pattern ? current_->resources.sources.sourceCount
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
  std::unique_ptr<Scene> scene_;
  SceneChanges changes_;
  scene::MergedMesh merged_;
  std::optional<SceneMotion> motion_;
  std::optional<SceneResources> uploaded_;
  std::uint64_t media_ = 0;  // changes_.media that uploaded_ is of
  DivisionOrder wanted_;     // for these media
  BackgroundDivider divider_;
  PreparedFrames prepared_;
  PreparedFrame* current_ = nullptr;           // of the frame submitted last
  const PreparedFrame* litSurfels_ = nullptr;  // whose light the surfels hold
  struct {
    double seconds = -1;
    int clip = 0;
  } pose_;              // of the frame submitted last
  bool shown_ = false;  // pictures are left for others to sample
  RenderOptions last_;  // of the frame submitted last
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

DeviceImage Renderer::submitOnDevice(const RenderOptions& options, const std::vector<Aov>& aovs) {
  return implementation_->submitOnDevice(options, aovs);
}

void Renderer::collect(Frame& frame) {
  implementation_->collect(frame);
}

void Renderer::setCamera(const Camera& camera) {
  implementation_->setCamera(camera);
}

void Renderer::setLighting(const Lighting& lighting) {
  implementation_->setLighting(lighting);
}

void Renderer::setMedium(std::size_t object, const Medium& medium) {
  implementation_->setMedium(object, medium);
}

void Renderer::setDeformers(const std::vector<Deformer>& deformers) {
  implementation_->setDeformers(deformers);
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
