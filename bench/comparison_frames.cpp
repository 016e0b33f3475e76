#include "comparison_frames.h"

#include <glm/gtc/type_ptr.hpp>

#include "gpu/command_list.h"
#include "gpu/device.h"
#include "gpu/transfer.h"
#include "passes/gather/diffusion_source_pass.h"
#include "passes/gather/shadow_pass.h"
#include "passes/scatter/surface_pass.h"
#include "passes/shade/shade_pass.h"
#include "renderer/camera_view.h"
#include "renderer/light_views.h"
#include "renderer/scene_resources.h"
#include "renderer/scene_tables.h"
#include "shaders/shaders.h"
#include "shaders/shared/frame.h"
#include "shaders/shared/mesh.h"

namespace opaline::bench {

namespace {

using gpu::Binding;
using gpu::BindingType;

constexpr std::uint32_t tileSize = 8;

std::uint32_t unsignedOf(int value) {
  return static_cast<std::uint32_t>(value);
}

shared::FrameData makeFrameData(const Scene& scene, const Bounds& bounds,
                                const RenderOptions& options) {
  const CameraView camera = makeCameraView(
      scene.camera, bounds, static_cast<float>(options.width) / static_cast<float>(options.height));
  shared::FrameData frame{};
  frame.worldToClip = camera.worldToClip;
  frame.cameraPosition = {camera.position, 1};
  frame.cameraAxis = {camera.axis, 0};
  fillLights(scene.lighting, bounds, unsignedOf(options.shadowSize), frame);
  frame.counts.w = unsignedOf(options.dsmSize);
  frame.ambient = {glm::make_vec3(scene.lighting.ambient.data()), 0};
  return frame;
}

gpu::Pipeline makeLambert(gpu::Device& device) {
  return {device, gpu::ComputePipelineOptions{.name = "lambert",
                                              .shader = shaders::shaders_lambert_comp,
                                              .bindings = {{0, BindingType::UniformBuffer},
                                                           {1, BindingType::SampledImage},
                                                           {2, BindingType::SampledImage},
                                                           {3, BindingType::SampledImage},
                                                           {4, BindingType::StorageImage}}}};
}

gpu::Pipeline makeVertexStage(gpu::Device& device) {
  gpu::GraphicsPipelineOptions options{
      .name = "surface with pattern",
      .vertexShader = shaders::shaders_surface_pattern_vert,
      .fragmentShader = shaders::shaders_surface_pattern_frag,
      .specialization = {0U},
      .colorFormats = {VK_FORMAT_R32G32B32A32_SFLOAT, VK_FORMAT_R16G16B16A16_SFLOAT,
                       VK_FORMAT_R32G32B32A32_SFLOAT},
      .depthFormat = VK_FORMAT_D32_SFLOAT,
      .depth = gpu::DepthMode::Write};
  options.bindings = {{0, BindingType::UniformBuffer}};
  for (std::uint32_t slot = 1; slot < 7; ++slot)
    options.bindings.push_back({slot, BindingType::StorageBuffer});
  for (std::uint32_t slot = 7; slot < 11; ++slot)
    options.bindings.push_back({slot, BindingType::SampledImage});
  options.bindings.push_back({11, BindingType::StorageBuffer});
  return {device, options};
}

}  // namespace

class ComparisonFrames::Implementation {
 public:
  Implementation(const Scene& scene, const RenderOptions& options)
      : views_(shadowViewCount(scene.lighting)),
        shadow_(device_),
        gather_(device_),
        surface_(device_),
        nearest_(device_, gpu::Filter::Nearest),
        linear_(device_, gpu::Filter::Linear),
        lambert_(makeLambert(device_)),
        vertexStage_(makeVertexStage(device_)),
        resources_(makeSceneResources(device_, scene, options.dsmSize)),
        commands_(device_, "comparison") {
    const PatternLayout pattern = layOutPattern(resources_, options);
    sources_ = gather_.prepare(device_, resources_.mesh, unsignedOf(options.dsmSize),
                               resources_.objects, pattern.maps);
    tables_ = makeSceneTables(device_, resources_, pattern, sources_.firstOfObject, scene.lighting,
                              options);
    shadows_ = passes::ShadowPass::makeMaps(device_, unsignedOf(options.shadowSize), views_);
    const std::uint32_t width = unsignedOf(options.width);
    const std::uint32_t height = unsignedOf(options.height);
    visible_ = passes::SurfacePass::makeSurface(device_, width, height);
    exitance_ =
        passes::SurfacePass::makeExitance(device_, width, height, resources_.mesh.vertexCount);
    radiance_ = passes::ShadePass::makeRadiance(device_, width, height);
    frame_ = makeFrameData(scene, resources_.bounds, options);
    frameBuffer_ = gpu::makeBuffer(device_, "frame data", std::vector<shared::FrameData>{frame_},
                                   VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
  }

  void opaqueFrame(FrameTimes& times) {
    commands_.begin();
    shadow_.record(commands_, frame_, views_, resources_.mesh, shadows_);
    surface_.record(commands_, {frameBuffer_, 0, resources_.mesh, sources_.charts, {0, 0}, false},
                    visible_, exitance_);
    commands_.beginPass("lambert");
    commands_.bind(lambert_);
    commands_.bindResources(
        {Binding::uniform(0, frameBuffer_), Binding::sampled(1, visible_.position, nearest_),
         Binding::sampled(2, visible_.normal, nearest_),
         Binding::sampled(3, shadows_.depth, nearest_), Binding::writeImage(4, radiance_)});
    const VkExtent2D extent = radiance_.extent();
    commands_.dispatch((extent.width + tileSize - 1) / tileSize,
                       (extent.height + tileSize - 1) / tileSize);
    commands_.endPass();
    finish(times);
  }

  void gather() {
    FrameTimes ignored;
    commands_.begin();
    shadow_.record(commands_, frame_, views_, resources_.mesh, shadows_);
    gather_.record(commands_, {frameBuffer_, 0, resources_.mesh, tables_, shadows_}, sources_);
    finish(ignored);
  }

  void vertexStageFrame(FrameTimes& times) {
    passes::DeformedMesh& mesh = resources_.mesh;
    commands_.begin();
    commands_.beginPass("surface with pattern");
    commands_.bind(vertexStage_);
    commands_.use(mesh.indices, gpu::Access::Index);
    commands_.bindResources(
        {Binding::uniform(0, frameBuffer_), Binding::read(1, mesh.positions),
         Binding::read(2, mesh.normals), Binding::read(3, mesh.corners),
         Binding::read(4, tables_.objects), Binding::read(5, tables_.media),
         Binding::read(6, tables_.pattern), Binding::sampled(7, sources_.nearPosition, nearest_),
         Binding::sampled(8, sources_.nearFlux, linear_),
         Binding::sampled(9, sources_.farPosition, linear_),
         Binding::sampled(10, sources_.farFlux, linear_), Binding::read(11, sources_.charts)});
    const gpu::DepthTarget depth{.image = &visible_.depth};
    commands_.beginRendering(
        {{.image = &visible_.position}, {.image = &visible_.normal}, {.image = &exitance_.image}},
        &depth);
    commands_.drawIndexed(mesh.indices, mesh.indexCount);
    commands_.endRendering();
    commands_.endPass();
    finish(times);
  }

  std::size_t corners() const {
    return resources_.mesh.corners.bytes() / sizeof(shared::AtlasCorner);
  }

 private:
  void finish(FrameTimes& times) {
    commands_.submit();
    commands_.wait();
    times.add(commands_.frameMilliseconds(), commands_.timings());
  }

  gpu::Device device_;
  std::uint32_t views_;
  passes::ShadowPass shadow_;
  passes::DiffusionSourcePass gather_;
  passes::SurfacePass surface_;
  gpu::Sampler nearest_;
  gpu::Sampler linear_;
  gpu::Pipeline lambert_;
  gpu::Pipeline vertexStage_;
  SceneResources resources_;
  gpu::CommandList commands_;
  passes::DiffusionSources sources_;
  passes::SceneTables tables_;
  passes::ShadowMaps shadows_;
  passes::VisibleSurface visible_;
  passes::Exitance exitance_;
  gpu::GpuImage radiance_;
  shared::FrameData frame_{};
  gpu::Buffer frameBuffer_;
};

ComparisonFrames::ComparisonFrames(const Scene& scene, const RenderOptions& options)
    : implementation_(std::make_unique<Implementation>(scene, options)) {
  implementation_->gather();
}
ComparisonFrames::~ComparisonFrames() = default;

void ComparisonFrames::renderOpaque(FrameTimes& times) {
  implementation_->opaqueFrame(times);
}
void ComparisonFrames::renderVertexStage(FrameTimes& times) {
  implementation_->vertexStageFrame(times);
}
std::size_t ComparisonFrames::corners() const {
  return implementation_->corners();
}

}  // namespace opaline::bench
