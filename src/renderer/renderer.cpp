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
  RendererContext& context = present(context_, "renderer");
  context.prepared.clear();
  context.edited.set(context.device, scene);
}

RenderResult Renderer::render(const RenderOptions& options, const std::vector<Aov>& aovs) {
  std::optional<View>& view = present(context_, "renderer").view;
  if (view)
    view->setOptions(options);
  else
    view.emplace(*this, options);
  return view->render({.aovs = aovs});
}

void Renderer::setTime(const SceneTime& time) {
  present(context_, "renderer").edited.setTime(time);
}

void Renderer::setCamera(const Camera& camera) {
  present(context_, "renderer").edited.setCamera(camera);
}

void Renderer::setLighting(const Lighting& lighting) {
  present(context_, "renderer").edited.setLighting(lighting);
}

const std::vector<DirectionalLight>& Renderer::suns() const {
  return present(context_, "renderer").edited.suns();
}

void Renderer::setMedium(std::size_t object, const Medium& medium) {
  present(context_, "renderer").edited.setMedium(object, medium);
}

void Renderer::setMaterial(std::size_t object, const Material& material) {
  present(context_, "renderer").edited.setMaterial(object, material);
}

void Renderer::setDeformers(const std::vector<Deformer>& deformers) {
  present(context_, "renderer").edited.setDeformers(deformers);
}

void Renderer::replacePositions(std::size_t object, std::span<const Vec3> positionsMm) {
  present(context_, "renderer").edited.replacePositions(object, positionsMm);
}

void Renderer::replacePositions(std::size_t object, const DevicePositions& positions) {
  present(context_, "renderer").edited.replacePositions(object, positions);
}

void Renderer::restorePositions(std::size_t object) {
  present(context_, "renderer").edited.restorePositions(object);
}

VulkanDevice Renderer::vulkanDevice() const {
  const gpu::Device& device = present(context_, "renderer").device;
  return {device.instance(), device.physical(), device.handle(), device.queueFamily(),
          device.queue()};
}

std::vector<std::byte> Renderer::pipelineCache() const {
  return present(context_, "renderer").device.pipelineCache();
}

std::size_t Renderer::memoryBytes() const {
  return present(context_, "renderer").device.memoryBytes();
}

std::size_t Renderer::validationMessages() const {
  return present(context_, "renderer").device.validationMessages();
}

}  // namespace opaline
