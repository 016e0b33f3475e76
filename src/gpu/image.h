#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "gpu/access.h"

namespace opaline::gpu {

class Device;

/// Bytes per texel of the formats that Opaline uses; 0 for any other.
std::size_t bytesPerTexel(VkFormat format);

/// The numbers of samples that a texel of an image of that format may have, one bit for each.
VkSampleCountFlags sampleCountsOf(const Device& device, VkFormat format, VkImageUsageFlags usage);

enum class ImageKind {
  Flat,       ///< sampler2D, or sampler2DMS with several samples
  Array,      ///< sampler2DArray
  CubeArray,  ///< samplerCubeArray; layers is a multiple of 6
};

struct ImageOptions {
  std::string name;
  std::uint32_t width = 1;
  std::uint32_t height = 1;
  std::uint32_t layers = 1;
  std::uint32_t mipLevels = 1;
  VkFormat format = VK_FORMAT_UNDEFINED;
  VkImageUsageFlags usage = 0;
  VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
  ImageKind kind = ImageKind::Flat;
  bool lent = false;  ///< the caller submits work to the queue that uses it
};

/// A target of the caller's. Earlier uses, if any, were as an attachment.
struct BorrowedTarget {
  VkImage image = VK_NULL_HANDLE;
  VkImageView view = VK_NULL_HANDLE;
  VkFormat format = VK_FORMAT_UNDEFINED;
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;  ///< any that attachments may have; is kept
  VkExtent2D extent{};
};

/// An image with memory of its own and views of it, unless it is borrowed. Movable.
class GpuImage {
 public:
  GpuImage() = default;
  /// An image that can only be drawn into.
  static GpuImage borrowed(const BorrowedTarget& target);
  GpuImage(Device& device, const ImageOptions& options);
  ~GpuImage();
  GpuImage(GpuImage&& other) noexcept;
  GpuImage& operator=(GpuImage&& other) noexcept;
  GpuImage(const GpuImage&) = delete;
  GpuImage& operator=(const GpuImage&) = delete;

  explicit operator bool() const { return image_ != VK_NULL_HANDLE; }
  VkImage handle() const { return image_; }
  /// Forgets the contents and all recorded accesses; see CommandList::abandon.
  void forget() { state_ = {}; }
  bool isBorrowed() const { return device_ == nullptr; }
  const ImageOptions& options() const { return options_; }
  VkExtent2D extent() const { return {options_.width, options_.height}; }
  VkImageAspectFlags aspect() const;  ///< colour or depth, from the format

  /// All layers and levels, of the image's kind.
  VkImageView view() const { return view_; }
  /// One layer of one level, as a flat attachment or storage image.
  VkImageView layerView(std::uint32_t layer, std::uint32_t mipLevel = 0) const;
  /// All layers of one level for storage images: image2D of a Flat image, else image2DArray.
  VkImageView levelView(std::uint32_t mipLevel) const;

 private:
  friend class CommandList;
  void create();
  void createViews();
  VkImageView createView(VkImageViewType type, const VkImageSubresourceRange& range) const;
  void swap(GpuImage& other) noexcept;

  Device* device_ = nullptr;
  ImageOptions options_;
  VkImage image_ = VK_NULL_HANDLE;
  VkDeviceMemory memory_ = VK_NULL_HANDLE;
  std::size_t allocatedBytes_ = 0;
  VkImageView view_ = VK_NULL_HANDLE;
  std::vector<VkImageView> layerViews_;  // layer + layers · level
  std::vector<VkImageView> levelViews_;
  AccessState state_;  // of the whole image
  // One more than the last layer that was attached, if the last access was as an attachment.
  std::uint32_t attachedLayers_ = 0;
};

enum class Filter { Nearest, Linear };
enum class Wrap { Clamp, Repeat };

/// How an image is read. Movable.
class Sampler {
 public:
  Sampler() = default;
  Sampler(Device& device, Filter filter, Wrap wrapU = Wrap::Clamp, Wrap wrapV = Wrap::Clamp);
  ~Sampler();
  Sampler(Sampler&& other) noexcept;
  Sampler& operator=(Sampler&& other) noexcept;
  Sampler(const Sampler&) = delete;
  Sampler& operator=(const Sampler&) = delete;

  VkSampler handle() const { return sampler_; }

 private:
  Device* device_ = nullptr;
  VkSampler sampler_ = VK_NULL_HANDLE;
};

}  // namespace opaline::gpu
