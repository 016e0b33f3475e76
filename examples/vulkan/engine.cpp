#include "engine.h"

#include <cstdio>
#include <stdexcept>
#include <string>

namespace {

void check(VkResult result, const char* attempt) {
  if (result < 0) throw std::runtime_error(std::string("Vulkan could not ") + attempt);
}

constexpr std::uint32_t floorVertex[] = {
#include "compiled/floor.vert.inc"
};
constexpr std::uint32_t floorFragment[] = {
#include "compiled/floor.frag.inc"
};
constexpr std::uint32_t waveCode[] = {
#include "compiled/wave.comp.inc"
};

constexpr VkFormat colorFormat = VK_FORMAT_R16G16B16A16_SFLOAT;
constexpr VkFormat depthFormat = VK_FORMAT_D32_SFLOAT;

VKAPI_ATTR VkBool32 VKAPI_CALL complain(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                        VkDebugUtilsMessageTypeFlagsEXT,
                                        const VkDebugUtilsMessengerCallbackDataEXT* data,
                                        void* count) {
  std::fprintf(stderr, "%s\n", data->pMessage);
  ++*static_cast<std::atomic<int>*>(count);
  return VK_FALSE;
}

VkSemaphoreSubmitInfo at(const opaline::TimelinePoint& point) {
  VkSemaphoreSubmitInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO};
  info.semaphore = point.semaphore;
  info.value = point.value;
  info.stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  return info;
}

// Waits for all earlier work, which is good enough for an example.
void barrier(VkCommandBuffer commands, const Engine::Image& image, VkImageLayout from,
             VkImageLayout to) {
  VkImageMemoryBarrier2 change{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
  change.srcStageMask = change.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  change.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
  change.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
  change.oldLayout = from;
  change.newLayout = to;
  change.srcQueueFamilyIndex = change.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  change.image = image.image;
  change.subresourceRange = {image.aspect, 0, 1, 0, 1};
  VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  info.imageMemoryBarrierCount = 1;
  info.pImageMemoryBarriers = &change;
  vkCmdPipelineBarrier2(commands, &info);
}

}  // namespace

Engine::Engine(bool validation) {
  makeInstance(validation);
  makeDevice();
  makeWave();
  makeFloor();
}

Engine::~Engine() {
  vkDeviceWaitIdle(device_);
  for (const VkCommandPool pool : pools_) vkDestroyCommandPool(device_, pool, nullptr);
  for (const VkSemaphore semaphore : semaphores_) vkDestroySemaphore(device_, semaphore, nullptr);
  for (const Image& image : images_) {
    vkDestroyImageView(device_, image.view, nullptr);
    vkDestroyImage(device_, image.image, nullptr);
  }
  for (const VkBuffer buffer : buffers_) vkDestroyBuffer(device_, buffer, nullptr);
  for (const VkDeviceMemory memory : memories_) vkFreeMemory(device_, memory, nullptr);
  vkDestroyPipeline(device_, floor_, nullptr);
  vkDestroyPipelineLayout(device_, floorLayout_, nullptr);
  vkDestroyPipeline(device_, wave_, nullptr);
  vkDestroyPipelineLayout(device_, waveLayout_, nullptr);
  vkDestroyDescriptorSetLayout(device_, waveSet_, nullptr);
  vkDestroyDevice(device_, nullptr);
  if (messenger_ != VK_NULL_HANDLE)
    reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(vkGetInstanceProcAddr(
        instance_, "vkDestroyDebugUtilsMessengerEXT"))(instance_, messenger_, nullptr);
  vkDestroyInstance(instance_, nullptr);
}

void Engine::makeInstance(bool validation) {
  VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
  application.apiVersion = opaline::vulkanNeeds().apiVersion;
  const VkValidationFeatureEnableEXT too =
      VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
  VkValidationFeaturesEXT more{VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT};
  more.enabledValidationFeatureCount = 1;
  more.pEnabledValidationFeatures = &too;
  const char* const layer = "VK_LAYER_KHRONOS_validation";
  const char* const extension = VK_EXT_DEBUG_UTILS_EXTENSION_NAME;
  VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
  info.pApplicationInfo = &application;
  if (validation) {
    info.pNext = &more;
    info.enabledLayerCount = info.enabledExtensionCount = 1;
    info.ppEnabledLayerNames = &layer;
    info.ppEnabledExtensionNames = &extension;
  }
  check(vkCreateInstance(&info, nullptr, &instance_), "make an instance");
  if (!validation) return;
  VkDebugUtilsMessengerCreateInfoEXT listen{
      VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
  listen.messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT |
                           VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  listen.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
  listen.pfnUserCallback = complain;
  listen.pUserData = &complaints_;
  check(reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(vkGetInstanceProcAddr(
            instance_, "vkCreateDebugUtilsMessengerEXT"))(instance_, &listen, nullptr, &messenger_),
        "listen to the validation layer");
}

// The engine needs dynamic rendering and push descriptors, as the library does. An engine that
// needs more merges its chain of features with the library's.
void Engine::makeDevice() {
  std::uint32_t count = 16;
  VkPhysicalDevice devices[16];
  check(vkEnumeratePhysicalDevices(instance_, &count, devices), "list the devices");
  std::string missing = "There is no Vulkan device.";
  for (std::uint32_t i = 0; i < count && physical_ == VK_NULL_HANDLE; ++i) {
    missing = opaline::whatIsMissing(instance_, devices[i]);
    if (missing.empty()) physical_ = devices[i];
  }
  if (physical_ == VK_NULL_HANDLE) throw std::runtime_error(missing);
  VkQueueFamilyProperties families[16];
  count = 16;
  vkGetPhysicalDeviceQueueFamilyProperties(physical_, &count, families);
  constexpr VkQueueFlags both = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
  while ((families[family_].queueFlags & both) != both) ++family_;

  const opaline::VulkanNeeds& needs = opaline::vulkanNeeds();
  const float priority = 1;
  VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
  queue.queueFamilyIndex = family_;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
  info.pNext = needs.requiredFeatures;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.enabledExtensionCount = static_cast<std::uint32_t>(needs.requiredExtensions.size());
  info.ppEnabledExtensionNames = needs.requiredExtensions.data();
  check(vkCreateDevice(physical_, &info, nullptr, &device_), "open the device");
  vkGetDeviceQueue(device_, family_, 0, &queue_);
  pushDescriptors_ = reinterpret_cast<PFN_vkCmdPushDescriptorSetKHR>(
      vkGetDeviceProcAddr(device_, "vkCmdPushDescriptorSetKHR"));
}

opaline::GivenVulkan Engine::given() {
  const opaline::VulkanNeeds& needs = opaline::vulkanNeeds();
  return {.instance = instance_,
          .physicalDevice = physical_,
          .device = device_,
          .queueFamily = family_,
          .queue = queue_,
          .getInstanceProcAddr = vkGetInstanceProcAddr,
          .enabledExtensions = needs.requiredExtensions,
          .enabledFeatures = needs.requiredFeatures,
          .lockQueue = [this] { queueMutex_.lock(); },
          .unlockQueue = [this] { queueMutex_.unlock(); }};
}

VkDeviceMemory Engine::allocate(const VkMemoryRequirements& requirements,
                                VkMemoryPropertyFlags flags) {
  VkPhysicalDeviceMemoryProperties properties;
  vkGetPhysicalDeviceMemoryProperties(physical_, &properties);
  VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
  info.allocationSize = requirements.size;
  while ((requirements.memoryTypeBits >> info.memoryTypeIndex & 1) == 0 ||
         (properties.memoryTypes[info.memoryTypeIndex].propertyFlags & flags) != flags)
    ++info.memoryTypeIndex;
  VkDeviceMemory memory = VK_NULL_HANDLE;
  check(vkAllocateMemory(device_, &info, nullptr, &memory), "find memory");
  memories_.push_back(memory);
  return memory;
}

Engine::Buffer Engine::makeBuffer(std::size_t bytes, VkBufferUsageFlags usage) {
  VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  info.size = bytes;
  info.usage = usage;
  Buffer made;
  check(vkCreateBuffer(device_, &info, nullptr, &made.buffer), "make a buffer");
  buffers_.push_back(made.buffer);
  VkMemoryRequirements requirements;
  vkGetBufferMemoryRequirements(device_, made.buffer, &requirements);
  const VkDeviceMemory memory = allocate(
      requirements, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
  check(vkBindBufferMemory(device_, made.buffer, memory, 0), "bind memory");
  check(vkMapMemory(device_, memory, 0, VK_WHOLE_SIZE, 0, &made.mapped), "map memory");
  return made;
}

Engine::Image Engine::makeImage(VkFormat format, VkExtent2D extent, VkImageUsageFlags usage,
                                VkImageAspectFlags aspect) {
  Image made{.format = format, .aspect = aspect};
  VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = format;
  info.extent = {extent.width, extent.height, 1};
  info.mipLevels = info.arrayLayers = 1;
  info.samples = VK_SAMPLE_COUNT_1_BIT;
  info.usage = usage;
  check(vkCreateImage(device_, &info, nullptr, &made.image), "make an image");
  VkMemoryRequirements requirements;
  vkGetImageMemoryRequirements(device_, made.image, &requirements);
  check(vkBindImageMemory(device_, made.image, allocate(requirements, 0), 0), "bind memory");
  VkImageViewCreateInfo view{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
  view.image = made.image;
  view.viewType = VK_IMAGE_VIEW_TYPE_2D;
  view.format = format;
  view.subresourceRange = {aspect, 0, 1, 0, 1};
  check(vkCreateImageView(device_, &view, nullptr, &made.view), "make a view of an image");
  images_.push_back(made);
  return made;
}

VkSemaphore Engine::makeTimeline() {
  VkSemaphoreTypeCreateInfo type{VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO};
  type.semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE;
  VkSemaphoreCreateInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
  info.pNext = &type;
  VkSemaphore made = VK_NULL_HANDLE;
  check(vkCreateSemaphore(device_, &info, nullptr, &made), "make a timeline");
  semaphores_.push_back(made);
  return made;
}

Engine::Commands Engine::makeCommands() {
  VkCommandPoolCreateInfo info{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
  info.queueFamilyIndex = family_;
  Commands made;
  check(vkCreateCommandPool(device_, &info, nullptr, &made.pool), "make a command pool");
  pools_.push_back(made.pool);
  VkCommandBufferAllocateInfo buffer{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
  buffer.commandPool = made.pool;
  buffer.commandBufferCount = 1;
  check(vkAllocateCommandBuffers(device_, &buffer, &made.buffer), "make a command buffer");
  return made;
}

VkCommandBuffer Engine::begin(const Commands& commands) {
  check(vkResetCommandPool(device_, commands.pool, 0), "reset a command pool");
  VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  check(vkBeginCommandBuffer(commands.buffer, &begin), "begin a command buffer");
  return commands.buffer;
}

void Engine::submit(VkCommandBuffer commands, const opaline::TimelinePoint& wait,
                    const opaline::TimelinePoint& signal) {
  check(vkEndCommandBuffer(commands), "record commands");
  VkCommandBufferSubmitInfo buffer{VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO};
  buffer.commandBuffer = commands;
  const VkSemaphoreSubmitInfo before = at(wait);
  const VkSemaphoreSubmitInfo after = at(signal);
  VkSubmitInfo2 info{VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
  info.waitSemaphoreInfoCount = 1;
  info.pWaitSemaphoreInfos = &before;
  info.commandBufferInfoCount = 1;
  info.pCommandBufferInfos = &buffer;
  info.signalSemaphoreInfoCount = 1;
  info.pSignalSemaphoreInfos = &after;
  const std::lock_guard lock(queueMutex_);
  check(vkQueueSubmit2(queue_, 1, &info, VK_NULL_HANDLE), "submit");
}

void Engine::waitFor(const opaline::TimelinePoint& point) {
  VkSemaphoreWaitInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO};
  info.semaphoreCount = 1;
  info.pSemaphores = &point.semaphore;
  info.pValues = &point.value;
  check(vkWaitSemaphores(device_, &info, UINT64_MAX), "wait");
}

VkShaderModule Engine::makeModule(const std::uint32_t* code, std::size_t bytes) {
  VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  info.codeSize = bytes;
  info.pCode = code;
  VkShaderModule made = VK_NULL_HANDLE;
  check(vkCreateShaderModule(device_, &info, nullptr, &made), "load a shader");
  return made;
}

void Engine::makeWave() {
  VkDescriptorSetLayoutBinding bindings[2]{};
  for (std::uint32_t i = 0; i < 2; ++i)
    bindings[i] = {i, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr};
  VkDescriptorSetLayoutCreateInfo set{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  set.flags = VK_DESCRIPTOR_SET_LAYOUT_CREATE_PUSH_DESCRIPTOR_BIT_KHR;
  set.bindingCount = 2;
  set.pBindings = bindings;
  check(vkCreateDescriptorSetLayout(device_, &set, nullptr, &waveSet_), "describe bindings");
  const VkPushConstantRange push{VK_SHADER_STAGE_COMPUTE_BIT, 0, 8};
  VkPipelineLayoutCreateInfo layout{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  layout.setLayoutCount = 1;
  layout.pSetLayouts = &waveSet_;
  layout.pushConstantRangeCount = 1;
  layout.pPushConstantRanges = &push;
  check(vkCreatePipelineLayout(device_, &layout, nullptr, &waveLayout_), "make a layout");
  VkComputePipelineCreateInfo info{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
  info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
  info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
  info.stage.module = makeModule(waveCode, sizeof waveCode);
  info.stage.pName = "main";
  info.layout = waveLayout_;
  check(vkCreateComputePipelines(device_, VK_NULL_HANDLE, 1, &info, nullptr, &wave_),
        "make a pipeline");
  vkDestroyShaderModule(device_, info.stage.module, nullptr);
}

void Engine::makeFloor() {
  const VkPushConstantRange push{VK_SHADER_STAGE_VERTEX_BIT, 0,
                                 sizeof(opaline::Matrix) + sizeof(float)};
  VkPipelineLayoutCreateInfo layout{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  layout.pushConstantRangeCount = 1;
  layout.pPushConstantRanges = &push;
  check(vkCreatePipelineLayout(device_, &layout, nullptr, &floorLayout_), "make a layout");
  VkPipelineShaderStageCreateInfo stages[2]{};
  for (VkPipelineShaderStageCreateInfo& stage : stages) {
    stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    stage.pName = "main";
  }
  stages[0].stage = VK_SHADER_STAGE_VERTEX_BIT;
  stages[0].module = makeModule(floorVertex, sizeof floorVertex);
  stages[1].stage = VK_SHADER_STAGE_FRAGMENT_BIT;
  stages[1].module = makeModule(floorFragment, sizeof floorFragment);
  VkPipelineVertexInputStateCreateInfo vertices{
      VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  VkPipelineInputAssemblyStateCreateInfo assembly{
      VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP;
  VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
  viewport.viewportCount = viewport.scissorCount = 1;
  VkPipelineRasterizationStateCreateInfo raster{
      VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
  raster.lineWidth = 1;
  VkPipelineMultisampleStateCreateInfo samples{
      VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
  samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
  VkPipelineDepthStencilStateCreateInfo depth{
      VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
  depth.depthTestEnable = depth.depthWriteEnable = VK_TRUE;
  depth.depthCompareOp = VK_COMPARE_OP_GREATER;
  VkPipelineColorBlendAttachmentState plain{};
  plain.colorWriteMask = 0xf;
  VkPipelineColorBlendStateCreateInfo blend{
      VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
  blend.attachmentCount = 1;
  blend.pAttachments = &plain;
  const VkDynamicState states[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
  VkPipelineDynamicStateCreateInfo dynamic{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
  dynamic.dynamicStateCount = 2;
  dynamic.pDynamicStates = states;
  VkPipelineRenderingCreateInfo rendering{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
  rendering.colorAttachmentCount = 1;
  rendering.pColorAttachmentFormats = &colorFormat;
  rendering.depthAttachmentFormat = depthFormat;
  VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
  info.pNext = &rendering;
  info.stageCount = 2;
  info.pStages = stages;
  info.pVertexInputState = &vertices;
  info.pInputAssemblyState = &assembly;
  info.pViewportState = &viewport;
  info.pRasterizationState = &raster;
  info.pMultisampleState = &samples;
  info.pDepthStencilState = &depth;
  info.pColorBlendState = &blend;
  info.pDynamicState = &dynamic;
  info.layout = floorLayout_;
  check(vkCreateGraphicsPipelines(device_, VK_NULL_HANDLE, 1, &info, nullptr, &floor_),
        "make a pipeline");
  for (const VkPipelineShaderStageCreateInfo& stage : stages)
    vkDestroyShaderModule(device_, stage.module, nullptr);
}

void Engine::wave(VkCommandBuffer commands, VkBuffer rest, VkBuffer positions,
                  std::uint32_t vertices, float seconds) {
  const VkDescriptorBufferInfo infos[] = {{rest, 0, VK_WHOLE_SIZE}, {positions, 0, VK_WHOLE_SIZE}};
  VkWriteDescriptorSet writes[2]{};
  for (std::uint32_t i = 0; i < 2; ++i) {
    writes[i].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    writes[i].dstBinding = i;
    writes[i].descriptorCount = 1;
    writes[i].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    writes[i].pBufferInfo = &infos[i];
  }
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, wave_);
  pushDescriptors_(commands, VK_PIPELINE_BIND_POINT_COMPUTE, waveLayout_, 0, 2, writes);
  const struct {
    std::uint32_t vertices;
    float seconds;
  } push{vertices, seconds};
  vkCmdPushConstants(commands, waveLayout_, VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof push, &push);
  vkCmdDispatch(commands, (vertices + 63) / 64, 1, 1);
}

void Engine::drawFloor(VkCommandBuffer commands, const Image& color, const Image& depth,
                       VkExtent2D extent, const Camera& camera, float heightMm) {
  for (const Image& image : {color, depth})
    barrier(commands, image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL);
  VkRenderingAttachmentInfo targets[2]{};
  for (int i = 0; i < 2; ++i) {
    targets[i].sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
    targets[i].imageView = i == 0 ? color.view : depth.view;
    targets[i].imageLayout = VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL;
    targets[i].loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;  // depth 0 is infinitely far
    targets[i].storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  }
  targets[0].clearValue.color = {{0.02F, 0.025F, 0.035F, 1}};
  VkRenderingInfo info{VK_STRUCTURE_TYPE_RENDERING_INFO};
  info.renderArea.extent = extent;
  info.layerCount = 1;
  info.colorAttachmentCount = 1;
  info.pColorAttachments = &targets[0];
  info.pDepthAttachment = &targets[1];
  vkCmdBeginRendering(commands, &info);
  const VkViewport viewport{
      0, 0, static_cast<float>(extent.width), static_cast<float>(extent.height), 0, 1};
  vkCmdSetViewport(commands, 0, 1, &viewport);
  vkCmdSetScissor(commands, 0, 1, &info.renderArea);
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, floor_);
  vkCmdPushConstants(commands, floorLayout_, VK_SHADER_STAGE_VERTEX_BIT, 0,
                     sizeof camera.worldToClip, camera.worldToClip.data());
  vkCmdPushConstants(commands, floorLayout_, VK_SHADER_STAGE_VERTEX_BIT, sizeof camera.worldToClip,
                     sizeof heightMm, &heightMm);
  vkCmdDraw(commands, 4, 1, 0, 0);
  vkCmdEndRendering(commands);
}

void Engine::copy(VkCommandBuffer commands, const Image& color, VkExtent2D extent, VkBuffer to) {
  barrier(commands, color, VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL,
          VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
  VkBufferImageCopy region{};
  region.imageSubresource = {color.aspect, 0, 0, 1};
  region.imageExtent = {extent.width, extent.height, 1};
  vkCmdCopyImageToBuffer(commands, color.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to, 1,
                         &region);
}
