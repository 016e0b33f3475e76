#include "renderer/frame/device_outputs.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "gpu/device.h"
#include "opaline/error.h"
#include "renderer/frame/readback.h"
#include "renderer/validate.h"
#include "shaders/shared/variable.h"

namespace opaline {

namespace {

gpu::GpuImage borrowed(const DeviceTarget& target, VkExtent2D extent) {
  return gpu::GpuImage::borrowed({target.image, target.view, target.format, target.layout, extent});
}

std::uint32_t kindOf(Aov aov) {
  switch (aov) {
    case Aov::Position:
      return shared::variablePlace;
    case Aov::Depth:
      return shared::variableDepth;
    case Aov::Object:
      return shared::variableObject;
    case Aov::Evaluations:
      return shared::variableLast;
    default:
      return shared::variableValues;
  }
}

void validate(const DeviceTarget& target, const char* name) {
  if (target.view == VK_NULL_HANDLE || target.format == VK_FORMAT_UNDEFINED ||
      target.layout == VK_IMAGE_LAYOUT_UNDEFINED)
    throw UsageError(fmt::format("Composition::{} needs image, view, format and layout", name));
  if (!std::has_single_bit(static_cast<std::uint32_t>(target.samples)) ||
      target.samples > VK_SAMPLE_COUNT_64_BIT)
    throw UsageError(fmt::format("Composition::{} has an unknown number of samples", name));
}

}  // namespace

void validate(const DeviceOutputs& outputs, const RenderOptions& options, bool hasMatrices) {
  if (!outputs.exitances.empty() && options.site != Site::Vertex)
    throw UsageError("the exitance of vertices needs RenderOptions::site Site::Vertex");
  for (const DeviceExitance& exitance : outputs.exitances)
    if (exitance.buffer == VK_NULL_HANDLE || exitance.offsetBytes % 4 != 0)
      throw UsageError("DeviceExitance needs a buffer and an offset that is a multiple of 4");
  if (outputs.over == nullptr) return;
  const Composition& over = *outputs.over;
  if (over.color.image == VK_NULL_HANDLE) throw UsageError("Composition::color needs an image");
  validate(over.color, "color");
  if (!std::isfinite(over.radianceScale))
    throw UsageError("Composition::radianceScale is not finite");
  if (over.depth.image == VK_NULL_HANDLE) return;
  validate(over.depth, "depth");
  if (over.depth.samples != over.color.samples)
    throw UsageError("Composition::color and Composition::depth have different numbers of samples");
  if (!hasMatrices)
    throw UsageError("Composition::depth needs the CameraMatrices with which it was drawn");
}

ExitanceRange exitanceRange(const std::vector<ObjectRange>& ranges, std::size_t object) {
  requireObject(object, ranges.size());
  constexpr std::size_t bytes = sizeof(shared::vec4);
  return {bytes * ranges[object].firstVertex, bytes * ranges[object].vertexCount};
}

void OutputRecorder::record(gpu::CommandList& commands, const FrameOrder& order,
                            const DeviceOutputs& outputs, const Inputs& inputs) {
  if (order.aovsOnDevice.empty() && outputs.over == nullptr && outputs.exitances.empty()) return;
  commands.cut();  // the caller's objects may be others in every frame
  for (const Aov aov : order.aovsOnDevice) leave(commands, aov, inputs);
  for (const DeviceExitance& exitance : outputs.exitances) {
    const ExitanceRange range = exitanceRange(inputs.ranges, exitance.object);
    gpu::Buffer to = gpu::Buffer::borrowed(exitance.buffer, exitance.offsetBytes + range.bytes);
    if (range.bytes > 0)
      commands.copyBuffer(inputs.resources.exitance.vertices, to, range.bytes, range.offset,
                          exitance.offsetBytes);
  }
  if (outputs.over != nullptr) compose(commands, *outputs.over, inputs);
}

void OutputRecorder::leave(gpu::CommandList& commands, Aov aov, const Inputs& inputs) {
  FrameResources& resources = inputs.resources;
  if (aov == Aov::Radiance) return commands.use(resources.radiance, gpu::Access::Sampled);
  gpu::GpuImage& variable = resources.variables.at(static_cast<std::size_t>(aov));
  if (!variable) variable = passes::VariablePass::makeImage(device_, resources.radiance.extent());
  gpu::GpuImage* const values = imagesOf(aov, resources)[1];
  const CameraView& camera = inputs.camera;
  variable_.record(commands,
                   {.centres = resources.centres,
                    .values = values != nullptr ? *values : resources.centres.exitance,
                    .kind = kindOf(aov),
                    .depth = {camera.axis, -glm::dot(camera.axis, camera.position)},
                    .origin = glm::make_vec3(inputs.originMm.data())},
                   variable);
  commands.use(variable, gpu::Access::Sampled);
}

void OutputRecorder::compose(gpu::CommandList& commands, const Composition& over,
                             const Inputs& inputs) {
  FrameResources& resources = inputs.resources;
  const VkExtent2D extent = resources.radiance.extent();
  gpu::GpuImage color = borrowed(over.color, extent);
  gpu::GpuImage depth =
      over.depth.image != VK_NULL_HANDLE ? borrowed(over.depth, extent) : gpu::GpuImage();
  compose_.record(commands, {resources.view, inputs.mesh, resources.surfaces}, resources.radiance,
                  {.color = color,
                   .depth = depth ? &depth : nullptr,
                   .how = inputs.depth,
                   .scale = over.radianceScale,
                   .samples = over.color.samples});
}

}  // namespace opaline
