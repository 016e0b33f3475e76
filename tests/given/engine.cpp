#include "given/engine.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <stdexcept>

namespace opaline::test {

namespace {

void require(VkResult result, const char* attempt) {
  if (result < 0) throw std::runtime_error(std::string("the engine could not ") + attempt);
}

std::atomic<int> submitted = 0;
std::atomic<int> waitedForIdle = 0;
std::atomic<bool> isLost = false;

VKAPI_ATTR VkResult VKAPI_CALL submitCounted(VkQueue queue, std::uint32_t count,
                                             const VkSubmitInfo2* submits, VkFence fence) {
  ++submitted;
  return isLost ? VK_ERROR_DEVICE_LOST : vkQueueSubmit2(queue, count, submits, fence);
}

VKAPI_ATTR VkResult VKAPI_CALL waitCounted(VkDevice device) {
  ++waitedForIdle;
  return vkDeviceWaitIdle(device);
}

VKAPI_ATTR VkResult VKAPI_CALL waitForSemaphores(VkDevice device, const VkSemaphoreWaitInfo* info,
                                                 std::uint64_t timeout) {
  return isLost ? VK_ERROR_DEVICE_LOST : vkWaitSemaphores(device, info, timeout);
}

template <typename Function>
PFN_vkVoidFunction plain(Function function) {
  return reinterpret_cast<PFN_vkVoidFunction>(function);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL loadOfDevice(VkDevice device, const char* name) {
  if (std::strcmp(name, "vkQueueSubmit2") == 0) return plain(submitCounted);
  if (std::strcmp(name, "vkDeviceWaitIdle") == 0) return plain(waitCounted);
  if (std::strcmp(name, "vkWaitSemaphores") == 0) return plain(waitForSemaphores);
  return vkGetDeviceProcAddr(device, name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL loadOfInstance(VkInstance instance, const char* name) {
  if (std::strcmp(name, "vkGetDeviceProcAddr") == 0) return plain(loadOfDevice);
  return vkGetInstanceProcAddr(instance, name);
}

VkImageMemoryBarrier2 barrierOf(const Engine::Target& target, VkImageLayout from,
                                VkImageLayout to) {
  VkImageMemoryBarrier2 barrier{};
  barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
  barrier.srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
  barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
  barrier.oldLayout = from;
  barrier.newLayout = to;
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = target.image;
  barrier.subresourceRange = {target.aspect, 0, 1, 0, 1};
  return barrier;
}

void change(VkCommandBuffer commands, std::initializer_list<VkImageMemoryBarrier2> barriers) {
  VkDependencyInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
  info.imageMemoryBarrierCount = static_cast<std::uint32_t>(barriers.size());
  info.pImageMemoryBarriers = barriers.begin();
  vkCmdPipelineBarrier2(commands, &info);
}

VkRenderingAttachmentInfo attachmentOf(const Engine::Target& target, VkClearValue value) {
  VkRenderingAttachmentInfo info{};
  info.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
  info.imageView = target.view;
  info.imageLayout = VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL;
  info.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
  info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  info.clearValue = value;
  return info;
}

}  // namespace

Engine::Engine(bool validated) {
  submitted = waitedForIdle = 0;
  isLost = false;
  makeInstance(validated);
  if (validated) listen();
  makeDevice();
}

Engine::Lane& Engine::lane() {
  const std::lock_guard lock(laneMutex_);
  const auto [at, isNew] = lanes_.try_emplace(std::this_thread::get_id());
  Lane& own = at->second;
  if (!isNew) return own;
  VkSemaphoreTypeCreateInfo type{};
  type.sType = VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO;
  type.semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE;
  VkSemaphoreCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO;
  info.pNext = &type;
  require(vkCreateSemaphore(device_, &info, nullptr, &own.timeline), "make a timeline");
  VkCommandPoolCreateInfo pool{};
  pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
  require(vkCreateCommandPool(device_, &pool, nullptr, &own.pool), "make a command pool");
  return own;
}

Engine::~Engine() {
  vkDeviceWaitIdle(device_);
  for (const Target& target : targets_) {
    vkDestroyImageView(device_, target.view, nullptr);
    vkDestroyImage(device_, target.image, nullptr);
  }
  for (const VkBuffer buffer : buffers_) vkDestroyBuffer(device_, buffer, nullptr);
  for (const VkDeviceMemory memory : memories_) vkFreeMemory(device_, memory, nullptr);
  for (const auto& [thread, lane] : lanes_) {
    vkDestroyCommandPool(device_, lane.pool, nullptr);
    vkDestroySemaphore(device_, lane.timeline, nullptr);
  }
  vkDestroyDevice(device_, nullptr);
  if (messenger_ != VK_NULL_HANDLE) {
    const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(instance_, "vkDestroyDebugUtilsMessengerEXT"));
    destroy(instance_, messenger_, nullptr);
  }
  vkDestroyInstance(instance_, nullptr);
}

void Engine::makeInstance(bool validated) {
  VkApplicationInfo application{};
  application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
  application.apiVersion = vulkanNeeds().apiVersion;
  const VkValidationFeatureEnableEXT enabled[] = {
      VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
  VkValidationFeaturesEXT features{};
  features.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT;
  features.enabledValidationFeatureCount = 1;
  features.pEnabledValidationFeatures = enabled;
  const char* const layer = "VK_LAYER_KHRONOS_validation";
  const char* const extension = VK_EXT_DEBUG_UTILS_EXTENSION_NAME;
  VkInstanceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
  info.pNext = validated ? &features : nullptr;
  info.pApplicationInfo = &application;
  info.enabledLayerCount = info.enabledExtensionCount = validated ? 1 : 0;
  info.ppEnabledLayerNames = &layer;
  info.ppEnabledExtensionNames = &extension;
  require(vkCreateInstance(&info, nullptr, &instance_), "make an instance");
}

void Engine::listen() {
  VkDebugUtilsMessengerCreateInfoEXT info{};
  info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
  info.messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT |
                         VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
  info.pUserData = this;
  info.pfnUserCallback = [](VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                            const VkDebugUtilsMessengerCallbackDataEXT* data,
                            void* user) -> VkBool32 {
    auto* engine = static_cast<Engine*>(user);
    const std::lock_guard lock(engine->messageMutex_);
    engine->messages_.emplace_back(data->pMessage);
    return VK_FALSE;
  };
  const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
      vkGetInstanceProcAddr(instance_, "vkCreateDebugUtilsMessengerEXT"));
  require(create(instance_, &info, nullptr, &messenger_), "listen to the validation layer");
}

void Engine::makeDevice() {
  std::uint32_t one = 1;
  require(vkEnumeratePhysicalDevices(instance_, &one, &physical_), "find a device");
  const float priority = 1;
  VkDeviceQueueCreateInfo queue{};
  queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  const VulkanNeeds& needs = vulkanNeeds();
  VkDeviceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
  info.pNext = needs.requiredFeatures;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.enabledExtensionCount = static_cast<std::uint32_t>(needs.requiredExtensions.size());
  info.ppEnabledExtensionNames = needs.requiredExtensions.data();
  require(vkCreateDevice(physical_, &info, nullptr, &device_), "open the device");
  vkGetDeviceQueue(device_, 0, 0, &queue_);
}

GivenVulkan Engine::given() {
  const VulkanNeeds& needs = vulkanNeeds();
  return {.instance = instance_,
          .physicalDevice = physical_,
          .device = device_,
          .queueFamily = 0,
          .queue = queue_,
          .getInstanceProcAddr = loadOfInstance,
          .enabledExtensions = needs.requiredExtensions,
          .enabledFeatures = needs.requiredFeatures,
          .lockQueue =
              [this] {
                queueMutex_.lock();
                ++locks_;
              },
          .unlockQueue = [this] { queueMutex_.unlock(); }};
}

std::vector<std::string> Engine::messages() const {
  const std::lock_guard lock(messageMutex_);
  return messages_;
}

int Engine::submissions() {
  return submitted;
}

int Engine::waitsForIdle() {
  return waitedForIdle;
}

void Engine::loseDevice(bool lost) {
  isLost = lost;
}

Engine::Memory Engine::allocate(const VkMemoryRequirements& requirements,
                                VkMemoryPropertyFlags flags) {
  VkPhysicalDeviceMemoryProperties properties{};
  vkGetPhysicalDeviceMemoryProperties(physical_, &properties);
  VkMemoryAllocateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
  info.allocationSize = requirements.size;
  while ((requirements.memoryTypeBits >> info.memoryTypeIndex & 1U) == 0 ||
         (properties.memoryTypes[info.memoryTypeIndex].propertyFlags & flags) != flags)
    ++info.memoryTypeIndex;
  Memory made;
  require(vkAllocateMemory(device_, &info, nullptr, &made.memory), "find memory");
  memories_.push_back(made.memory);
  if (flags == 0) return made;
  void* mapped = nullptr;
  require(vkMapMemory(device_, made.memory, 0, VK_WHOLE_SIZE, 0, &mapped), "map memory");
  made.mapped = static_cast<std::byte*>(mapped);
  return made;
}

Engine::HostBuffer Engine::makeBuffer(std::size_t bytes, VkBufferUsageFlags usage) {
  VkBufferCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
  info.size = bytes;
  info.usage = usage;
  HostBuffer made;
  require(vkCreateBuffer(device_, &info, nullptr, &made.buffer), "make a buffer");
  buffers_.push_back(made.buffer);
  VkMemoryRequirements requirements{};
  vkGetBufferMemoryRequirements(device_, made.buffer, &requirements);
  const Memory memory = allocate(
      requirements, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
  require(vkBindBufferMemory(device_, made.buffer, memory.memory, 0), "bind memory");
  made.mapped = memory.mapped;
  return made;
}

Engine::Target Engine::makeTarget(VkFormat format, VkExtent2D extent,
                                  VkSampleCountFlagBits samples) {
  const bool isDepth = format == VK_FORMAT_D32_SFLOAT || format == VK_FORMAT_D16_UNORM;
  Target target{.format = format,
                .extent = extent,
                .aspect = static_cast<VkImageAspectFlags>(isDepth ? VK_IMAGE_ASPECT_DEPTH_BIT
                                                                  : VK_IMAGE_ASPECT_COLOR_BIT)};
  VkImageCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = format;
  info.extent = {extent.width, extent.height, 1};
  info.mipLevels = info.arrayLayers = 1;
  info.samples = samples;
  info.usage =
      VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT |
      (isDepth ? VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT : VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
  require(vkCreateImage(device_, &info, nullptr, &target.image), "make an image");
  VkMemoryRequirements requirements{};
  vkGetImageMemoryRequirements(device_, target.image, &requirements);
  require(vkBindImageMemory(device_, target.image, allocate(requirements, 0).memory, 0),
          "bind memory");
  VkImageViewCreateInfo view{};
  view.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
  view.image = target.image;
  view.viewType = VK_IMAGE_VIEW_TYPE_2D;
  view.format = format;
  view.subresourceRange = {target.aspect, 0, 1, 0, 1};
  require(vkCreateImageView(device_, &view, nullptr, &target.view), "make a view of an image");
  targets_.push_back(target);
  return target;
}

VkCommandBuffer Engine::begin() {
  VkCommandBufferAllocateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
  info.commandPool = lane().pool;
  info.commandBufferCount = 1;
  VkCommandBuffer commands = VK_NULL_HANDLE;
  require(vkAllocateCommandBuffers(device_, &info, &commands), "make a command buffer");
  VkCommandBufferBeginInfo begin{};
  begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  require(vkBeginCommandBuffer(commands, &begin), "begin a command buffer");
  return commands;
}

void Engine::submit(VkCommandBuffer commands, const TimelinePoint& point,
                    const std::vector<TimelinePoint>& waits) {
  require(vkEndCommandBuffer(commands), "record commands");
  const auto infoOf = [](const TimelinePoint& at) {
    VkSemaphoreSubmitInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO;
    info.semaphore = at.semaphore;
    info.value = at.value;
    info.stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    return info;
  };
  const VkSemaphoreSubmitInfo signal = infoOf(point);
  std::vector<VkSemaphoreSubmitInfo> waited;
  for (const TimelinePoint& wait : waits) waited.push_back(infoOf(wait));
  VkCommandBufferSubmitInfo buffer{};
  buffer.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO;
  buffer.commandBuffer = commands;
  VkSubmitInfo2 info{};
  info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2;
  info.waitSemaphoreInfoCount = static_cast<std::uint32_t>(waited.size());
  info.pWaitSemaphoreInfos = waited.data();
  info.commandBufferInfoCount = 1;
  info.pCommandBufferInfos = &buffer;
  info.signalSemaphoreInfoCount = 1;
  info.pSignalSemaphoreInfos = &signal;
  const std::lock_guard lock(queueMutex_);
  require(vkQueueSubmit2(queue_, 1, &info, VK_NULL_HANDLE), "submit");
}

void Engine::waitFor(const TimelinePoint& point) const {
  VkSemaphoreWaitInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO;
  info.semaphoreCount = 1;
  info.pSemaphores = &point.semaphore;
  info.pValues = &point.value;
  require(vkWaitSemaphores(device_, &info, UINT64_MAX), "wait");
}

void Engine::signal(const TimelinePoint& point) const {
  VkSemaphoreSignalInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SIGNAL_INFO;
  info.semaphore = point.semaphore;
  info.value = point.value;
  require(vkSignalSemaphore(device_, &info), "signal");
}

void Engine::run(const std::function<void(VkCommandBuffer)>& record) {
  const VkCommandBuffer commands = begin();
  record(commands);
  const TimelinePoint point = nextPoint();
  submit(commands, point);
  waitFor(point);
}

void Engine::clear(VkCommandBuffer commands, const Target& color, const VkClearColorValue& value,
                   const Target& depth, float depthValue) {
  change(commands,
         {barrierOf(color, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL),
          barrierOf(depth, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL)});
  const VkRenderingAttachmentInfo ofColor = attachmentOf(color, {.color = value});
  const VkRenderingAttachmentInfo ofDepth = attachmentOf(depth, {.depthStencil = {depthValue, 0}});
  VkRenderingInfo info{};
  info.sType = VK_STRUCTURE_TYPE_RENDERING_INFO;
  info.renderArea.extent = color.extent;
  info.layerCount = 1;
  info.colorAttachmentCount = 1;
  info.pColorAttachments = &ofColor;
  info.pDepthAttachment = &ofDepth;
  vkCmdBeginRendering(commands, &info);
  vkCmdEndRendering(commands);
}

void Engine::copy(const Target& target, VkImageLayout layout, const HostBuffer& buffer) {
  run([&](VkCommandBuffer commands) {
    change(commands, {barrierOf(target, layout, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL)});
    VkBufferImageCopy region{};
    region.imageSubresource = {target.aspect, 0, 0, 1};
    region.imageExtent = {target.extent.width, target.extent.height, 1};
    vkCmdCopyImageToBuffer(commands, target.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                           buffer.buffer, 1, &region);
    change(commands, {barrierOf(target, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, layout)});
  });
}

std::vector<float> Engine::read(const Target& target) {
  return readAs(target, VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL);
}

std::vector<float> Engine::read(const DeviceImage& image) {
  return readAs({.image = image.image, .format = image.format, .extent = image.extent},
                image.layout);
}

std::vector<float> Engine::readAs(const Target& target, VkImageLayout layout) {
  const bool four = target.format == VK_FORMAT_R32G32B32A32_SFLOAT;
  const std::size_t count =
      std::size_t{target.extent.width} * target.extent.height * (four ? 4 : 1);
  const HostBuffer buffer = makeBuffer(count * sizeof(float), VK_BUFFER_USAGE_TRANSFER_DST_BIT);
  copy(target, layout, buffer);
  std::vector<float> texels(count);
  std::memcpy(texels.data(), buffer.mapped, count * sizeof(float));
  return texels;
}

void Engine::resolve(const Target& from, const Target& to) {
  run([&](VkCommandBuffer commands) {
    change(
        commands,
        {barrierOf(from, VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL),
         barrierOf(to, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL)});
    VkImageResolve region{};
    region.srcSubresource = region.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.extent = {from.extent.width, from.extent.height, 1};
    vkCmdResolveImage(commands, from.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to.image,
                      VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
    change(commands, {barrierOf(to, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                                VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL)});
  });
}

}  // namespace opaline::test
