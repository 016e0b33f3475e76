#include "opaque_frame.h"

#include <cstdint>
#include <glm/gtc/type_ptr.hpp>
#include <string>
#include <vector>

#include "gpu/command_list.h"
#include "gpu/device.h"
#include "gpu/transfer.h"
#include "passes/deform/deform_pass.h"
#include "passes/gather/fit_pass.h"
#include "passes/gather/shadow_pass.h"
#include "passes/scatter/surface_pass.h"
#include "passes/shade/shade_pass.h"
#include "renderer/frame/camera_view.h"
#include "renderer/frame/light_views.h"
#include "renderer/motion/scene_motion.h"
#include "renderer/scene/scene_resources.h"
#include "shaders/lambert.comp.h"
#include "shaders/shared/frame.h"

namespace opaline::bench {

namespace {

std::uint32_t unsignedOf(int value) {
  return static_cast<std::uint32_t>(value);
}

shared::FrameData makeFrameData(const Scene& scene, const RenderOptions& options) {
  const CameraView camera = makeCameraView(
      scene.camera, static_cast<float>(options.width) / static_cast<float>(options.height));
  shared::FrameData frame{};
  frame.worldToClip = camera.worldToClip;
  frame.cameraPosition = {camera.position, 1};
  frame.cameraAxis = {camera.axis, 0};
  fillLights(scene.lighting, unsignedOf(options.shadowSize), frame);
  fillSamples(1, frame);
  return frame;
}

}  // namespace

class OpaqueFrame::Implementation {
 public:
  Implementation(const Scene& scene, const RenderOptions& options, const std::string& device)
      : device_({.selector = device, .validation = false, .log = {}}),
        deform_(device_),
        fit_(device_),
        shadow_(device_),
        surface_(device_),
        nearest_(device_, gpu::Filter::Nearest),
        lambert_(device_, "lambert"),
        scene_(scene),
        merged_(scene::mergedMesh(scene_)),
        resources_(makeSceneResources(device_, scene_, merged_, {})),
        motion_(device_, scene_, merged_, Vec3{}),
        view_(passes::FitPass::makeView(device_)),
        commands_(device_, "opaque frame") {
    const std::uint32_t width = unsignedOf(options.width);
    const std::uint32_t height = unsignedOf(options.height);
    view_.shadowViews = shadowViewCount(scene.lighting);
    shadows_ = passes::ShadowPass::makeMaps(device_, unsignedOf(options.shadowSize),
                                            view_.shadowViews, false);
    visible_ = passes::SurfacePass::makeSurfaces(device_, {width, height}, 1, {});
    radiance_ = passes::ShadePass::makeRadiance(device_, width, height);
    upload_ = gpu::makeBuffer(device_, "frame data",
                              std::vector<shared::FrameData>{makeFrameData(scene, options)}, 0);
  }

  void render(double seconds, FrameTimes& times) {
    const passes::CutOuts cutOuts{tables_, resources_.opaque};
    commands_.begin();
    motion_.record(commands_, deform_, {.seconds = seconds}, resources_.mesh);
    fit_.record(commands_, upload_, 0, resources_.mesh, view_);
    const passes::ShadowViews all((std::uint64_t{1} << view_.shadowViews) - 1);
    shadow_.record(commands_, view_, resources_.mesh, cutOuts, all, shadows_);
    const passes::SeenSurfaces seen{view_, resources_.mesh, visible_};
    surface_.draw(commands_, seen, cutOuts, samplePattern(1), {});
    surface_.list(commands_, seen, 0, 1);
    commands_.beginPass("lambert");
    commands_.bind(lambert_,
                   {.seenPlaces = passes::seenPlaces(seen, nearest_),
                    .shadowMaps = {shadows_.depth, nearest_},
                    .radiance = radiance_},
                   {.ambient = glm::vec4(glm::make_vec3(scene_.lighting.ambient.data()), 0)});
    commands_.dispatchTiles(radiance_);
    commands_.endPass();
    commands_.submit();
    commands_.wait();
    times.add(commands_.frameMilliseconds(), commands_.timings());
  }

 private:
  gpu::Device device_;
  passes::DeformPass deform_;
  passes::FitPass fit_;
  passes::ShadowPass shadow_;
  passes::SurfacePass surface_;
  gpu::Sampler nearest_;
  gpu::Compute<shaders::Lambert> lambert_;
  Scene scene_;
  scene::MergedMesh merged_;
  SceneResources resources_;
  SceneMotion motion_;
  passes::FrameView view_;
  gpu::CommandList commands_;
  passes::ShadowMaps shadows_;
  passes::SceneTables tables_;
  passes::VisibleSurfaces visible_;
  gpu::GpuImage radiance_;
  gpu::Buffer upload_;
};

OpaqueFrame::OpaqueFrame(const Scene& scene, const RenderOptions& options,
                         const std::string& device)
    : implementation_(std::make_unique<Implementation>(scene, options, device)) {}
OpaqueFrame::~OpaqueFrame() = default;

void OpaqueFrame::render(double seconds, FrameTimes& times) {
  implementation_->render(seconds, times);
}

}  // namespace opaline::bench
