#include <array>
#include <cstring>

#include "core/digest.h"
#include "gpu/device.h"
#include "gpu/vulkan_result.h"

namespace opaline::gpu {

namespace {

// Precedes the driver's data, because drivers trust any data that begins with their own header.
struct Seal {
  std::array<char, 8> format{'O', 'P', 'A', 'L', 'P', 'S', 'O', '1'};
  std::uint64_t digest = 0;
};

Seal sealOf(std::span<const std::byte> data) {
  core::Digest digest;
  digest.addBytes(data.data(), data.size());
  return {.digest = digest.value()};
}

// The driver's data; empty if the data is anything else or has been changed.
std::span<const std::byte> intact(std::span<const std::byte> given) {
  if (given.size() < sizeof(Seal)) return {};
  const std::span<const std::byte> data = given.subspan(sizeof(Seal));
  const Seal seal = sealOf(data);
  return std::memcmp(given.data(), &seal, sizeof seal) == 0 ? data : std::span<const std::byte>();
}

}  // namespace

void Device::createPipelineCache(std::span<const std::byte> given) {
  const std::span<const std::byte> data = intact(given);
  VkPipelineCacheCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO;
  info.initialDataSize = data.size();
  info.pInitialData = data.data();
  check(vk_.vkCreatePipelineCache(device_, &info, nullptr, &pipelineCache_),
        "create a pipeline cache");
  setName(VK_OBJECT_TYPE_PIPELINE_CACHE, reinterpret_cast<std::uint64_t>(pipelineCache_),
          "pipelines");
}

std::vector<std::byte> Device::pipelineCache() const {
  std::size_t bytes = 0;
  check(vk_.vkGetPipelineCacheData(device_, pipelineCache_, &bytes, nullptr),
        "read the pipeline cache");
  std::vector<std::byte> sealed(sizeof(Seal) + bytes);
  check(vk_.vkGetPipelineCacheData(device_, pipelineCache_, &bytes, sealed.data() + sizeof(Seal)),
        "read the pipeline cache");
  sealed.resize(sizeof(Seal) + bytes);
  const Seal seal = sealOf(std::span(sealed).subspan(sizeof(Seal)));
  std::memcpy(sealed.data(), &seal, sizeof seal);
  return sealed;
}

}  // namespace opaline::gpu
