#include "opaline/renderer.h"

#include <memory>

#include "gpu/device.h"
#include "opaline/error.h"
#include "opaline/options/picture.h"
#include "opaline/vulkan.h"
#include "renderer/context.h"
#include "renderer/validate.h"

namespace opaline {

namespace {

std::optional<std::size_t> mostMemoryBytes(const RendererOptions& options) {
  if (const std::string complaint = options::complaintAboutFields(options); !complaint.empty())
    throw UsageError(complaint);
  if (!options.memoryLimit) return std::nullopt;
  return static_cast<std::size_t>(1e6 * static_cast<double>(*options.memoryLimit));
}

}  // namespace

RendererContext::RendererContext(const RendererOptions& options)
    : device({.selector = options.device,
              .validation = options.validation,
              .log = options.log,
              .instanceExtensions = options.instanceExtensions,
              .deviceExtensions = options.deviceExtensions,
              .rayQueries = options.rayQueries,
              .mostMemoryBytes = mostMemoryBytes(options),
              .given = options.given.get(),
              .pipelineCache = options.pipelineCache}),
      passes(device),
      prepared(device, passes, options.log) {}

DeviceDescription describe(const gpu::DeviceInfo& info) {
  return {info.name, gpu::toString(info.type), info.driver, info.rayQueries};
}

std::vector<DeviceDescription> listDevices() {
  std::vector<DeviceDescription> devices;
  for (const gpu::DeviceInfo& info : gpu::Device::list()) devices.push_back(describe(info));
  return devices;
}

Given::Given(const GivenVulkan& given) : given_(std::make_shared<const GivenVulkan>(given)) {}
Given::Given(const GivenVulkan* given) {
  if (given != nullptr) *this = Given(*given);
}

Renderer::Renderer(const RendererOptions& options)
    : context_(std::make_unique<RendererContext>(options)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

void Renderer::setScene(const Scene& scene) {
  validate(scene);
  context_->prepared.clear();
  context_->edited.set(context_->device, scene);
}

RenderResult Renderer::render(const RenderOptions& options, const std::vector<Aov>& aovs) {
  std::optional<View>& view = context_->view;
  if (view)
    view->setOptions(options);
  else
    view.emplace(*this, options);
  return view->render({.aovs = aovs});
}

void Renderer::setTime(const SceneTime& time) {
  context_->edited.setTime(time);
}

void Renderer::setCamera(const Camera& camera) {
  context_->edited.setCamera(camera);
}

void Renderer::setLighting(const Lighting& lighting) {
  context_->edited.setLighting(lighting);
}

const std::vector<DirectionalLight>& Renderer::suns() const {
  return context_->edited.suns();
}

void Renderer::setMedium(std::size_t object, const Medium& medium) {
  context_->edited.setMedium(object, medium);
}

void Renderer::setMaterial(std::size_t object, const Material& material) {
  context_->edited.setMaterial(object, material);
}

void Renderer::setDeformers(const std::vector<Deformer>& deformers) {
  context_->edited.setDeformers(deformers);
}

void Renderer::replacePositions(std::size_t object, std::span<const Vec3> positionsMm) {
  context_->edited.replacePositions(object, positionsMm);
}

void Renderer::replacePositions(std::size_t object, const DevicePositions& positions) {
  context_->edited.replacePositions(object, positions);
}

void Renderer::restorePositions(std::size_t object) {
  context_->edited.restorePositions(object);
}

VulkanDevice Renderer::vulkanDevice() const {
  const gpu::Device& device = context_->device;
  return {device.instance(), device.physical(), device.handle(), device.queueFamily(),
          device.queue()};
}

std::vector<std::byte> Renderer::pipelineCache() const {
  return context_->device.pipelineCache();
}

std::size_t Renderer::memoryBytes() const {
  return context_->device.memoryBytes();
}

std::size_t Renderer::validationMessages() const {
  return context_->device.validationMessages();
}

}  // namespace opaline
