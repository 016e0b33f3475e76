#include "viewer/window/presenter.h"

#include <algorithm>

#include "opaline/error.h"
#include "viewer/window/vulkan_check.h"
#include "viewer/window/vulkan_objects.h"

namespace opaline::app::viewer {

namespace {

template <typename T, typename Call, typename... Arguments>
std::vector<T> listOf(Call call, Arguments... arguments) {
  std::uint32_t count = 0;
  check(call(arguments..., &count, nullptr), "ask what its surface can do");
  std::vector<T> list(count);
  check(call(arguments..., &count, list.data()), "ask what its surface can do");
  list.resize(count);
  return list;
}

}  // namespace

Presenter::Presenter(const VulkanDevice& device, const Window& window)
    : device_(device), window_(window), surface_(window.makeSurface(device.instance)) {
  try {
    requirePresenting();
    chooseFormat();
    makeRenderPass();
    makeSlots();
  } catch (...) {
    destroy();
    throw;
  }
}

Presenter::~Presenter() {
  vkDeviceWaitIdle(device_.device);
  destroy();
}

void Presenter::destroy() {
  dropSwapchain();
  for (const Slot& slot : slots_) {
    vkDestroyFence(device_.device, slot.done, nullptr);
    vkDestroySemaphore(device_.device, slot.acquired, nullptr);
  }
  vkDestroyCommandPool(device_.device, pool_, nullptr);
  vkDestroyRenderPass(device_.device, renderPass_, nullptr);
  vkDestroySurfaceKHR(device_.instance, surface_, nullptr);
}

void Presenter::dropSwapchain() {
  dropImages();
  if (swapchain_ != VK_NULL_HANDLE) vkDestroySwapchainKHR(device_.device, swapchain_, nullptr);
  swapchain_ = VK_NULL_HANDLE;
}

// Needed for example when a display is taken from a graphics card.
void Presenter::remakeSurface() {
  waitIdle();
  dropSwapchain();
  vkDestroySurfaceKHR(device_.instance, surface_, nullptr);
  surface_ = VK_NULL_HANDLE;
  surface_ = window_.makeSurface(device_.instance);
  requirePresenting();
  outdated_ = true;
}

void Presenter::requirePresenting() const {
  VkBool32 presents = VK_FALSE;
  check(vkGetPhysicalDeviceSurfaceSupportKHR(device_.physicalDevice, device_.queueFamily, surface_,
                                             &presents),
        "ask whether the device can draw into it");
  if (presents == VK_FALSE) {
    throw Error("this device cannot draw into the window; choose another with --device");
  }
}

void Presenter::chooseFormat() {
  const auto formats = listOf<VkSurfaceFormatKHR>(vkGetPhysicalDeviceSurfaceFormatsKHR,
                                                  device_.physicalDevice, surface_);
  // Whoever draws encodes to sRGB, as Dear ImGui's colours are encoded already.
  const auto encoded = [](const VkSurfaceFormatKHR& format) {
    return (format.format == VK_FORMAT_B8G8R8A8_UNORM ||
            format.format == VK_FORMAT_R8G8B8A8_UNORM) &&
           format.colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR;
  };
  const auto found = std::find_if(formats.begin(), formats.end(), encoded);
  if (found == formats.end()) throw Error("the window has no 8-bit sRGB surface to draw on");
  format_ = *found;
}

void Presenter::makeRenderPass() {
  VkAttachmentDescription color{};
  color.format = format_.format;
  color.samples = VK_SAMPLE_COUNT_1_BIT;
  color.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
  color.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  color.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
  color.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
  color.initialLayout = VK_IMAGE_LAYOUT_UNDEFINED;
  color.finalLayout = VK_IMAGE_LAYOUT_PRESENT_SRC_KHR;
  const VkAttachmentReference reference{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
  VkSubpassDescription subpass{};
  subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
  subpass.colorAttachmentCount = 1;
  subpass.pColorAttachments = &reference;
  // Starts once the image was acquired; the submission waits for that at the same stage.
  VkSubpassDependency dependency{};
  dependency.srcSubpass = VK_SUBPASS_EXTERNAL;
  dependency.srcStageMask = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
  dependency.dstStageMask = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
  dependency.dstAccessMask = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;
  VkRenderPassCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO;
  info.attachmentCount = 1;
  info.pAttachments = &color;
  info.subpassCount = 1;
  info.pSubpasses = &subpass;
  info.dependencyCount = 1;
  info.pDependencies = &dependency;
  check(vkCreateRenderPass(device_.device, &info, nullptr, &renderPass_), "prepare its drawing");
}

void Presenter::makeSlots() {
  constexpr const char* attempt = "prepare its drawing";
  pool_ = makeCommandPool(device_, VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT, attempt);
  for (Slot& slot : slots_) {
    slot.commands = makeCommands(device_.device, pool_, attempt);
    VkFenceCreateInfo fence{};
    fence.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
    fence.flags = VK_FENCE_CREATE_SIGNALED_BIT;
    check(vkCreateFence(device_.device, &fence, nullptr, &slot.done), attempt);
    VkSemaphoreCreateInfo semaphore{};
    semaphore.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO;
    check(vkCreateSemaphore(device_.device, &semaphore, nullptr, &slot.acquired), attempt);
  }
}

bool Presenter::makeSwapchain() {
  VkSurfaceCapabilitiesKHR can{};
  check(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device_.physicalDevice, surface_, &can),
        "ask what its surface can do");
  constexpr std::uint32_t chosenByUs = 0xFFFFFFFFU;
  VkExtent2D extent = can.currentExtent.width == chosenByUs ? window_.pixels() : can.currentExtent;
  extent.width = std::min(extent.width, can.maxImageExtent.width);
  extent.height = std::min(extent.height, can.maxImageExtent.height);
  if (extent.width == 0 || extent.height == 0) return false;
  check(vkDeviceWaitIdle(device_.device), "wait for the device");
  dropImages();

  VkSwapchainCreateInfoKHR info{};
  info.sType = VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR;
  info.surface = surface_;
  // One image is shown and one is drawn. More would only be older when they are seen.
  info.minImageCount = std::max(2U, can.minImageCount);
  info.imageFormat = format_.format;
  info.imageColorSpace = format_.colorSpace;
  info.imageExtent = extent;
  info.imageArrayLayers = 1;
  info.imageUsage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
  info.imageSharingMode = VK_SHARING_MODE_EXCLUSIVE;
  info.preTransform = can.currentTransform;
  info.compositeAlpha = (can.supportedCompositeAlpha & VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR) != 0
                            ? VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR
                            : VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR;
  info.presentMode = VK_PRESENT_MODE_FIFO_KHR;
  info.clipped = VK_TRUE;
  info.oldSwapchain = swapchain_;
  VkSwapchainKHR made = VK_NULL_HANDLE;
  const VkResult result = vkCreateSwapchainKHR(device_.device, &info, nullptr, &made);
  if (swapchain_ != VK_NULL_HANDLE) vkDestroySwapchainKHR(device_.device, swapchain_, nullptr);
  swapchain_ = made;
  check(result, "take its new size");
  extent_ = extent;
  makeImages();
  outdated_ = false;
  return true;
}

void Presenter::makeImages() {
  constexpr const char* attempt = "take its new size";
  for (const VkImage image : listOf<VkImage>(vkGetSwapchainImagesKHR, device_.device, swapchain_)) {
    Image& made = images_.emplace_back();
    made.view = makeView(device_.device, image, format_.format, attempt);
    VkFramebufferCreateInfo framebuffer{};
    framebuffer.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO;
    framebuffer.renderPass = renderPass_;
    framebuffer.attachmentCount = 1;
    framebuffer.pAttachments = &made.view;
    framebuffer.width = extent_.width;
    framebuffer.height = extent_.height;
    framebuffer.layers = 1;
    check(vkCreateFramebuffer(device_.device, &framebuffer, nullptr, &made.framebuffer), attempt);
    VkSemaphoreCreateInfo semaphore{};
    semaphore.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO;
    check(vkCreateSemaphore(device_.device, &semaphore, nullptr, &made.rendered), attempt);
  }
}

void Presenter::dropImages() {
  for (const Image& image : images_) {
    vkDestroyFramebuffer(device_.device, image.framebuffer, nullptr);
    vkDestroyImageView(device_.device, image.view, nullptr);
    vkDestroySemaphore(device_.device, image.rendered, nullptr);
  }
  images_.clear();
}

// False where there is no image yet, or the surface must be made again first.
bool Presenter::acquire() {
  const VkExtent2D pixels = window_.pixels();
  if (pixels.width != extent_.width || pixels.height != extent_.height) outdated_ = true;
  if (outdated_ && !makeSwapchain()) return false;
  const VkResult result = vkAcquireNextImageKHR(device_.device, swapchain_, UINT64_MAX,
                                                slots_[slot_].acquired, VK_NULL_HANDLE, &image_);
  if (result == VK_ERROR_OUT_OF_DATE_KHR) {
    outdated_ = true;
    return false;
  }
  if (result == VK_ERROR_SURFACE_LOST_KHR) {
    remakeSurface();
    return false;
  }
  if (result == VK_TIMEOUT || result == VK_NOT_READY) return false;
  check(result, "take its next picture");
  if (result == VK_SUBOPTIMAL_KHR) outdated_ = true;  // the image can still be drawn
  return true;
}

std::optional<VkCommandBuffer> Presenter::begin() {
  const VkExtent2D pixels = window_.pixels();
  if (pixels.width == 0 || pixels.height == 0) return std::nullopt;
  Slot& slot = slots_[slot_];
  VkResult waited = VK_TIMEOUT;  // some drivers end the longest wait early
  while (waited == VK_TIMEOUT)
    waited = vkWaitForFences(device_.device, 1, &slot.done, VK_TRUE, UINT64_MAX);
  check(waited, "wait for a picture");
  // Tries again where the size has just changed; if that fails too, the next frame tries.
  if (!acquire() && !acquire()) return std::nullopt;
  check(vkResetFences(device_.device, 1, &slot.done), "begin a picture");
  beginCommands(slot.commands, "begin a picture");
  const VkClearValue clear{};
  VkRenderPassBeginInfo pass{};
  pass.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO;
  pass.renderPass = renderPass_;
  pass.framebuffer = images_[image_].framebuffer;
  pass.renderArea = {{0, 0}, extent_};
  pass.clearValueCount = 1;
  pass.pClearValues = &clear;
  vkCmdBeginRenderPass(slot.commands, &pass, VK_SUBPASS_CONTENTS_INLINE);
  return slot.commands;
}

void Presenter::end() {
  Slot& slot = slots_[slot_];
  vkCmdEndRenderPass(slot.commands);
  check(vkEndCommandBuffer(slot.commands), "draw a picture");
  const VkPipelineStageFlags stage = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
  VkSubmitInfo submit{};
  submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
  submit.waitSemaphoreCount = 1;
  submit.pWaitSemaphores = &slot.acquired;
  submit.pWaitDstStageMask = &stage;
  submit.commandBufferCount = 1;
  submit.pCommandBuffers = &slot.commands;
  submit.signalSemaphoreCount = 1;
  submit.pSignalSemaphores = &images_[image_].rendered;
  check(vkQueueSubmit(device_.queue, 1, &submit, slot.done), "draw a picture");
  VkPresentInfoKHR present{};
  present.sType = VK_STRUCTURE_TYPE_PRESENT_INFO_KHR;
  present.waitSemaphoreCount = 1;
  present.pWaitSemaphores = &images_[image_].rendered;
  present.swapchainCount = 1;
  present.pSwapchains = &swapchain_;
  present.pImageIndices = &image_;
  const VkResult result = vkQueuePresentKHR(device_.queue, &present);
  if (result == VK_ERROR_OUT_OF_DATE_KHR || result == VK_SUBOPTIMAL_KHR) {
    outdated_ = true;
  } else if (result == VK_ERROR_SURFACE_LOST_KHR) {
    remakeSurface();
  } else {
    check(result, "show a picture");
  }
  slot_ = (slot_ + 1) % framesInFlight;
}

void Presenter::waitIdle() const {
  check(vkDeviceWaitIdle(device_.device), "wait for the device");
}

}  // namespace opaline::app::viewer
