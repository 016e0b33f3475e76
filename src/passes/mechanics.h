#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/command_list.h"
#include "gpu/device.h"
#include "gpu/pipeline.h"
#include "passes/products.h"

/// What passes are put together from.
namespace opaline::passes {

/// Slots 0 to `count` - 1: storage buffers but for those listed, which are texel buffers.
inline std::vector<gpu::BindingSlot> slots(std::uint32_t count,
                                           std::initializer_list<std::uint32_t> texels = {}) {
  std::vector<gpu::BindingSlot> made;
  for (std::uint32_t i = 0; i < count; ++i) {
    const bool texel = std::find(texels.begin(), texels.end(), i) != texels.end();
    made.push_back({i, texel ? gpu::BindingType::TexelBuffer : gpu::BindingType::StorageBuffer});
  }
  return made;
}

/// Of what shaders write, and read as storage or texels.
constexpr VkBufferUsageFlags roomUsage =
    VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT;

/// Room for `count` of T that shaders write, and read as storage or texels; for one at least.
template <typename T>
gpu::Buffer makeRoom(gpu::Device& device, const char* name, std::size_t count) {
  return {device,
          {.name = name, .bytes = std::max<std::size_t>(count, 1) * sizeof(T), .usage = roomUsage}};
}

/// BINDING_RAYS of shaders with lib/rays.glsl, which are to be the variant with ray queries where
/// the device has them.
inline gpu::BindingSlot raysSlot(const gpu::Device& device, std::uint32_t slot) {
  return {slot, device.hasRayQueries() ? gpu::BindingType::AccelerationStructure
                                       : gpu::BindingType::TexelBuffer};
}

inline gpu::Binding rays(std::uint32_t slot, RayHierarchy& hierarchy) {
  return hierarchy.structure ? gpu::Binding::rays(slot, hierarchy.structure)
                             : gpu::Binding::texels(slot, hierarchy.boxes);
}

/// A tree's nodes of one height, as its list by height has them.
struct NodeRange {
  std::uint32_t first;
  std::uint32_t count;
};

/// Calls `record(height, range)` from the leaves, which are of height 0, to the roots.
template <typename Record>
void forEachHeight(const std::vector<std::uint32_t>& firstOfHeight, const Record& record) {
  for (std::size_t height = 0; height + 1 < firstOfHeight.size(); ++height)
    record(height,
           NodeRange{firstOfHeight[height], firstOfHeight[height + 1] - firstOfHeight[height]});
}

}  // namespace opaline::passes
