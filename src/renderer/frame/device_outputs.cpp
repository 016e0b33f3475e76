#include "renderer/frame/device_outputs.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "gpu/device.h"
#include "opaline/error.h"
#include "renderer/validate.h"

namespace opaline {

namespace {

gpu::GpuImage borrowed(const DeviceTarget& target, VkExtent2D extent) {
  return gpu::GpuImage::borrowed({target.image, target.view, target.format, target.layout, extent});
}

void validate(const DeviceTarget& target, const char* name) {
  if (target.view == VK_NULL_HANDLE || target.format == VK_FORMAT_UNDEFINED ||
      target.layout == VK_IMAGE_LAYOUT_UNDEFINED)
    throw UsageError(fmt::format("Composition::{} needs image, view, format and layout", name));
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
  if (!hasMatrices)
    throw UsageError("Composition::depth needs the CameraMatrices with which it was drawn");
}

ExitanceRange exitanceRange(const std::vector<ObjectRange>& ranges, std::size_t object) {
  requireObject(object, ranges.size());
  constexpr std::size_t bytes = sizeof(shared::vec4);
  return {bytes * ranges[object].firstVertex, bytes * ranges[object].vertexCount};
}

void OutputRecorder::record(gpu::CommandList& commands, const DeviceOutputs& outputs,
                            const Inputs& inputs) {
  if (outputs.over == nullptr && outputs.exitances.empty()) return;
  commands.cut();  // what is given may be another in every frame
  for (const DeviceExitance& exitance : outputs.exitances) {
    const ExitanceRange range = exitanceRange(inputs.ranges, exitance.object);
    gpu::Buffer to = gpu::Buffer::borrowed(exitance.buffer, exitance.offsetBytes + range.bytes);
    if (range.bytes > 0)
      commands.copyBuffer(inputs.resources.exitance.vertices, to, range.bytes, range.offset,
                          exitance.offsetBytes);
  }
  if (outputs.over != nullptr) compose(commands, *outputs.over, inputs);
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
                   .scale = over.radianceScale});
}

}  // namespace opaline
