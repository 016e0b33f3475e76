#pragma once

#include <vulkan/vulkan.h>

namespace opaline::gpu {

/// What a command does with a resource: the only vocabulary in which barriers are spoken of.
enum class Access {
  None,            ///< contents are not needed any more
  ColorWrite,      ///< colour attachment, written and blended
  DepthWrite,      ///< depth attachment, tested and written
  DepthTest,       ///< depth attachment, tested only
  Sampled,         ///< read through a sampler or texelFetch, any shader stage
  StorageRead,     ///< storage image or buffer read, any shader stage
  StorageWrite,    ///< storage image or buffer written or read and written, any shader stage
  Uniform,         ///< uniform buffer
  Index,           ///< index buffer
  TransferRead,
  TransferWrite,
  HostRead,        ///< by the host, once the submission has finished
};

struct AccessScope {
  VkPipelineStageFlags2 stages = 0;
  VkAccessFlags2 accesses = 0;
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
  bool writes = false;
};

AccessScope scopeOf(Access access);

}  // namespace opaline::gpu
