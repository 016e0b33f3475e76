#include "gpu/image.h"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <utility>

#include "gpu/device.h"
#include "gpu/vulkan_result.h"
#include "opaline/error.h"

namespace opaline::gpu {

namespace {

constexpr VkImageUsageFlags attachmentUsage =
    VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
constexpr VkImageUsageFlags viewedUsage =
    attachmentUsage | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT;

bool isDepth(VkFormat format) {
  return format == VK_FORMAT_D32_SFLOAT || format == VK_FORMAT_D16_UNORM ||
         format == VK_FORMAT_X8_D24_UNORM_PACK32;
}

VkImageViewType viewTypeOf(ImageKind kind) {
  switch (kind) {
    case ImageKind::Flat:
      return VK_IMAGE_VIEW_TYPE_2D;
    case ImageKind::Array:
      return VK_IMAGE_VIEW_TYPE_2D_ARRAY;
    case ImageKind::CubeArray:
      return VK_IMAGE_VIEW_TYPE_CUBE_ARRAY;
  }
  assert(false);
  return VK_IMAGE_VIEW_TYPE_2D;
}

VkImageCreateInfo infoOf(const ImageOptions& options) {
  VkImageCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
  if (options.kind == ImageKind::CubeArray) info.flags = VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT;
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = options.format;
  info.extent = {options.width, options.height, 1};
  info.mipLevels = options.mipLevels;
  info.arrayLayers = options.layers;
  info.samples = options.samples;
  info.tiling = VK_IMAGE_TILING_OPTIMAL;
  info.usage = options.usage;
  info.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
  info.initialLayout = VK_IMAGE_LAYOUT_UNDEFINED;
  return info;
}

void checkSize(const Device& device, const VkImageCreateInfo& info, const ImageOptions& options) {
  const std::uint32_t side = device.limits().maxImageDimension2D;
  if (options.width > side || options.height > side) {
    throw Error(fmt::format(
        "the image \"{}\" of {} x {} pixels is larger than the {} pixels a side that {} can do; "
        "use a smaller size",
        options.name, options.width, options.height, side, device.info().name));
  }
  const std::uint32_t layers = device.limits().maxImageArrayLayers;
  if (options.layers > layers) {
    throw Error(fmt::format("the image \"{}\" has {} layers, but {} can do {} at most",
                            options.name, options.layers, device.info().name, layers));
  }
  VkImageFormatProperties able{};
  const VkResult result = device.instanceFunctions().vkGetPhysicalDeviceImageFormatProperties(
      device.physical(), info.format, info.imageType, info.tiling, info.usage, info.flags, &able);
  if (result == VK_ERROR_FORMAT_NOT_SUPPORTED) {
    throw Error(fmt::format(
        "{} does not support what the image \"{}\" needs (VkFormat {}, usage {:#x}); use another "
        "device",
        device.info().name, options.name, static_cast<int>(options.format), options.usage));
  }
  check(result, fmt::format("find out about the image \"{}\"", options.name));
  if (options.width > able.maxExtent.width || options.height > able.maxExtent.height ||
      options.layers > able.maxArrayLayers || options.mipLevels > able.maxMipLevels) {
    throw Error(fmt::format(
        "the image \"{}\" ({} x {} pixels, {} layers, {} levels) is larger than {} can do with its "
        "format; use a smaller size",
        options.name, options.width, options.height, options.layers, options.mipLevels,
        device.info().name));
  }
}

}  // namespace

std::size_t bytesPerTexel(VkFormat format) {
  switch (format) {
    case VK_FORMAT_R8_UNORM:
    case VK_FORMAT_R8_UINT:
      return 1;
    case VK_FORMAT_R8G8_UNORM:
    case VK_FORMAT_R16_SFLOAT:
    case VK_FORMAT_R16_UINT:
    case VK_FORMAT_D16_UNORM:
      return 2;
    case VK_FORMAT_R8G8B8A8_UNORM:
    case VK_FORMAT_R8G8B8A8_SRGB:
    case VK_FORMAT_B8G8R8A8_UNORM:
    case VK_FORMAT_B8G8R8A8_SRGB:
    case VK_FORMAT_A2B10G10R10_UNORM_PACK32:
    case VK_FORMAT_B10G11R11_UFLOAT_PACK32:
    case VK_FORMAT_R16G16_UNORM:
    case VK_FORMAT_R16G16_SNORM:
    case VK_FORMAT_R16G16_SFLOAT:
    case VK_FORMAT_R32_SFLOAT:
    case VK_FORMAT_R32_UINT:
    case VK_FORMAT_R32_SINT:
    case VK_FORMAT_D32_SFLOAT:
      return 4;
    case VK_FORMAT_R16G16B16A16_UNORM:
    case VK_FORMAT_R16G16B16A16_SNORM:
    case VK_FORMAT_R16G16B16A16_SFLOAT:
    case VK_FORMAT_R32G32_SFLOAT:
    case VK_FORMAT_R32G32_UINT:
      return 8;
    case VK_FORMAT_R32G32B32A32_SFLOAT:
    case VK_FORMAT_R32G32B32A32_UINT:
      return 16;
    default:
      return 0;
  }
}

VkSampleCountFlags sampleCountsOf(const Device& device, VkFormat format, VkImageUsageFlags usage) {
  VkImageFormatProperties able{};
  const VkResult result = device.instanceFunctions().vkGetPhysicalDeviceImageFormatProperties(
      device.physical(), format, VK_IMAGE_TYPE_2D, VK_IMAGE_TILING_OPTIMAL, usage, 0, &able);
  return result == VK_SUCCESS ? able.sampleCounts : VkSampleCountFlags{VK_SAMPLE_COUNT_1_BIT};
}

GpuImage::GpuImage(Device& device, const ImageOptions& options) : GpuImage() {
  assert(options.width > 0 && options.height > 0 && options.layers > 0 && options.mipLevels > 0);
  assert(options.mipLevels <=
         static_cast<std::uint32_t>(std::bit_width(std::max(options.width, options.height))));
  assert(options.kind != ImageKind::Flat || options.layers == 1);
  assert(options.samples == VK_SAMPLE_COUNT_1_BIT ||
         (options.kind == ImageKind::Flat && options.mipLevels == 1));
  assert(options.kind != ImageKind::CubeArray ||
         (options.layers % 6 == 0 && options.width == options.height));
  device_ = &device;
  options_ = options;
  create();
  if ((options_.usage & viewedUsage) != 0) createViews();
}

void GpuImage::create() {
  const VkImageCreateInfo info = infoOf(options_);
  checkSize(*device_, info, options_);
  check(device_->vk().vkCreateImage(device_->handle(), &info, nullptr, &image_),
        fmt::format("create the image \"{}\"", options_.name));
  device_->setName(VK_OBJECT_TYPE_IMAGE, reinterpret_cast<std::uint64_t>(image_), options_.name);
  VkMemoryRequirements requirements{};
  device_->vk().vkGetImageMemoryRequirements(device_->handle(), image_, &requirements);
  memory_ = device_->allocate(requirements, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, options_.name);
  allocatedBytes_ = requirements.size;
  check(device_->vk().vkBindImageMemory(device_->handle(), image_, memory_, 0),
        fmt::format("give memory to the image \"{}\"", options_.name));
}

void GpuImage::createViews() {
  const std::uint32_t layers = options_.layers;
  const std::uint32_t levels = options_.mipLevels;
  view_ = createView(viewTypeOf(options_.kind), {aspect(), 0, levels, 0, layers});
  // A view's slot exists before the view, so that no view leaks when a creation throws.
  if ((options_.usage & (attachmentUsage | VK_IMAGE_USAGE_STORAGE_BIT)) != 0) {
    layerViews_.assign(std::size_t{layers} * levels, VK_NULL_HANDLE);
    for (std::uint32_t i = 0; i < layers * levels; ++i) {
      layerViews_[i] = createView(VK_IMAGE_VIEW_TYPE_2D, {aspect(), i / layers, 1, i % layers, 1});
    }
  }
  if ((options_.usage & VK_IMAGE_USAGE_STORAGE_BIT) != 0) {
    const VkImageViewType type =
        options_.kind == ImageKind::Flat ? VK_IMAGE_VIEW_TYPE_2D : VK_IMAGE_VIEW_TYPE_2D_ARRAY;
    levelViews_.assign(levels, VK_NULL_HANDLE);
    for (std::uint32_t level = 0; level < levels; ++level) {
      levelViews_[level] = createView(type, {aspect(), level, 1, 0, layers});
    }
  }
}

VkImageView GpuImage::createView(VkImageViewType type, const VkImageSubresourceRange& range) const {
  VkImageViewCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
  info.image = image_;
  info.viewType = type;
  info.format = options_.format;
  info.subresourceRange = range;
  VkImageView view = VK_NULL_HANDLE;
  check(device_->vk().vkCreateImageView(device_->handle(), &info, nullptr, &view),
        fmt::format("create a view of the image \"{}\"", options_.name));
  device_->setName(VK_OBJECT_TYPE_IMAGE_VIEW, reinterpret_cast<std::uint64_t>(view), options_.name);
  return view;
}

GpuImage GpuImage::borrowed(const BorrowedTarget& target) {
  GpuImage result;
  result.options_.width = target.extent.width;
  result.options_.height = target.extent.height;
  result.options_.format = target.format;
  result.image_ = target.image;
  result.view_ = target.view;
  const AccessScope before =
      scopeOf(isDepth(target.format) ? Access::DepthWrite : Access::ColorWrite);
  result.state_ = {
      .layout = target.layout, .writeStages = before.stages, .writeAccesses = before.accesses};
  return result;
}

GpuImage::~GpuImage() {
  if (device_ == nullptr) return;
  const auto retire = [&](VkObjectType type, auto handle) {
    device_->retire(type, handle, options_.lent);
  };
  for (const VkImageView view : layerViews_) retire(VK_OBJECT_TYPE_IMAGE_VIEW, view);
  for (const VkImageView view : levelViews_) retire(VK_OBJECT_TYPE_IMAGE_VIEW, view);
  retire(VK_OBJECT_TYPE_IMAGE_VIEW, view_);
  retire(VK_OBJECT_TYPE_IMAGE, image_);
  device_->release(memory_, allocatedBytes_, options_.lent);
}

GpuImage::GpuImage(GpuImage&& other) noexcept {
  swap(other);
}

GpuImage& GpuImage::operator=(GpuImage&& other) noexcept {
  GpuImage taken(std::move(other));
  swap(taken);
  return *this;
}

void GpuImage::swap(GpuImage& other) noexcept {
  std::swap(device_, other.device_);
  std::swap(options_, other.options_);
  std::swap(image_, other.image_);
  std::swap(memory_, other.memory_);
  std::swap(allocatedBytes_, other.allocatedBytes_);
  std::swap(view_, other.view_);
  std::swap(layerViews_, other.layerViews_);
  std::swap(levelViews_, other.levelViews_);
  std::swap(state_, other.state_);
  std::swap(attachedLayers_, other.attachedLayers_);
}

VkImageAspectFlags GpuImage::aspect() const {
  return isDepth(options_.format) ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}

VkImageView GpuImage::layerView(std::uint32_t layer, std::uint32_t mipLevel) const {
  assert(layer < options_.layers && mipLevel < options_.mipLevels);
  if (isBorrowed()) return view_;
  return layerViews_.at(layer + std::size_t{options_.layers} * mipLevel);
}

VkImageView GpuImage::levelView(std::uint32_t mipLevel) const {
  return levelViews_.at(mipLevel);
}

Sampler::Sampler(Device& device, Filter filter, Wrap wrapU, Wrap wrapV) : device_(&device) {
  const auto mode = [](Wrap wrap) {
    return wrap == Wrap::Repeat ? VK_SAMPLER_ADDRESS_MODE_REPEAT
                                : VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  };
  const bool linear = filter == Filter::Linear;
  VkSamplerCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
  info.magFilter = linear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
  info.minFilter = info.magFilter;
  info.mipmapMode = linear ? VK_SAMPLER_MIPMAP_MODE_LINEAR : VK_SAMPLER_MIPMAP_MODE_NEAREST;
  info.addressModeU = mode(wrapU);
  info.addressModeV = mode(wrapV);
  info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  info.maxLod = VK_LOD_CLAMP_NONE;
  check(device.vk().vkCreateSampler(device.handle(), &info, nullptr, &sampler_),
        "create a sampler");
  device.setName(VK_OBJECT_TYPE_SAMPLER, reinterpret_cast<std::uint64_t>(sampler_),
                 linear ? "linear sampler" : "nearest sampler");
}

Sampler::~Sampler() {
  if (device_ != nullptr) device_->retire(VK_OBJECT_TYPE_SAMPLER, sampler_);
}

Sampler::Sampler(Sampler&& other) noexcept
    : device_(std::exchange(other.device_, nullptr)),
      sampler_(std::exchange(other.sampler_, VK_NULL_HANDLE)) {}

Sampler& Sampler::operator=(Sampler&& other) noexcept {
  Sampler taken(std::move(other));
  std::swap(device_, taken.device_);
  std::swap(sampler_, taken.sampler_);
  return *this;
}

}  // namespace opaline::gpu
