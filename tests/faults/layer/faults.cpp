#include "faults.h"

#include <vulkan/vk_layer.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <initializer_list>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <type_traits>

#include "state.h"

namespace {

using namespace opaline::faults;

PFN_vkGetInstanceProcAddr nextOfInstance = nullptr;
PFN_vkGetDeviceProcAddr nextOfDevice = nullptr;
// Queried early: later the loader would answer with the first layer. Instances differ in their
// layers.
std::map<VkInstance, PFN_vkDestroyInstance> nextDestroyInstance;
PFN_vkDestroyDevice nextDestroyDevice = nullptr;
PFN_vkGetPhysicalDeviceProperties nextGetProperties = nullptr;
PFN_vkGetPhysicalDeviceProperties2 nextGetProperties2 = nullptr;
std::atomic<VkDevice> device = VK_NULL_HANDLE;  // the latest device
std::mutex queueMutex;  // the program synchronizes its queues, but not with the layer's waits

void waitForDevice() {
  if (device == VK_NULL_HANDLE) return;
  const std::lock_guard lock(queueMutex);
  const auto wait =
      reinterpret_cast<PFN_vkDeviceWaitIdle>(nextOfDevice(device, "vkDeviceWaitIdle"));
  wait(device);
}

/// Wraps a function that can fail.
template <typename Function, Call& call>
struct Failing;
template <typename... Arguments, Call& call>
struct Failing<VkResult(VKAPI_PTR*)(Arguments...), call> {
  static VKAPI_ATTR VkResult VKAPI_CALL run(Arguments... arguments) {
    if (state().fails(call, waitForDevice)) return state().result();
    const auto next = reinterpret_cast<VkResult(VKAPI_PTR*)(Arguments...)>(call.next);
    std::unique_lock lock(queueMutex, std::defer_lock);
    if constexpr ((std::is_same_v<Arguments, VkQueue> || ...)) lock.lock();
    const VkResult result = next(arguments...);
    if (result >= 0 && call.living != nullptr) ++*call.living;
    return result;
  }
};

/// Wraps a function that destroys an object.
template <typename Function, Call& call>
struct Destroying;
template <typename Parent, typename Object, Call& call>
struct Destroying<void(VKAPI_PTR*)(Parent, Object, const VkAllocationCallbacks*), call> {
  static VKAPI_ATTR void VKAPI_CALL run(Parent parent, Object object,
                                        const VkAllocationCallbacks* allocator) {
    if (object != VK_NULL_HANDLE) --*call.living;
    const auto next =
        reinterpret_cast<void(VKAPI_PTR*)(Parent, Object, const VkAllocationCallbacks*)>(call.next);
    next(parent, object, allocator);
  }
};

// name, failures, kind of object created
#define OPALINE_FAILING(X)                                                                      \
  X(vkEnumeratePhysicalDevices, ofMemory | ofInitialization, nullptr)                           \
  X(vkEnumerateDeviceExtensionProperties, ofMemory, nullptr)                                    \
  X(vkGetPhysicalDeviceImageFormatProperties, ofMemory, nullptr)                                \
  X(vkGetPhysicalDeviceSurfaceSupportKHR, ofMemory | ofSurface, nullptr)                        \
  X(vkGetPhysicalDeviceSurfaceCapabilitiesKHR, ofMemory | ofSurface, nullptr)                   \
  X(vkGetPhysicalDeviceSurfaceFormatsKHR, ofMemory | ofSurface, nullptr)                        \
  X(vkCreateDebugUtilsMessengerEXT, ofMemory, "VkDebugUtilsMessengerEXT")                       \
  X(vkSetDebugUtilsObjectNameEXT, ofMemory, nullptr)                                            \
  X(vkCreateBuffer, ofMemory, "VkBuffer")                                                       \
  X(vkCreateBufferView, ofMemory, "VkBufferView")                                               \
  X(vkCreateImage, ofMemory, "VkImage")                                                         \
  X(vkCreateImageView, ofMemory, "VkImageView")                                                 \
  X(vkAllocateMemory, ofMemory, "VkDeviceMemory")                                               \
  X(vkBindBufferMemory, ofMemory, nullptr)                                                      \
  X(vkBindImageMemory, ofMemory, nullptr)                                                       \
  X(vkMapMemory, ofMemory | ofMapping, nullptr)                                                 \
  X(vkCreateSampler, ofMemory, "VkSampler")                                                     \
  X(vkCreateShaderModule, ofMemory, "VkShaderModule")                                           \
  X(vkCreateDescriptorSetLayout, ofMemory, "VkDescriptorSetLayout")                             \
  X(vkCreateDescriptorPool, ofMemory, "VkDescriptorPool")                                       \
  X(vkAllocateDescriptorSets, ofMemory, nullptr)                                                \
  X(vkCreatePipelineCache, ofMemory, "VkPipelineCache")                                         \
  X(vkCreatePipelineLayout, ofMemory, "VkPipelineLayout")                                       \
  X(vkCreateComputePipelines, ofMemory, "VkPipeline")                                           \
  X(vkCreateGraphicsPipelines, ofMemory, "VkPipeline")                                          \
  X(vkCreateRenderPass, ofMemory, "VkRenderPass")                                               \
  X(vkCreateFramebuffer, ofMemory, "VkFramebuffer")                                             \
  X(vkCreateQueryPool, ofMemory, "VkQueryPool")                                                 \
  X(vkCreateSemaphore, ofMemory, "VkSemaphore")                                                 \
  X(vkCreateFence, ofMemory, "VkFence")                                                         \
  X(vkCreateCommandPool, ofMemory, "VkCommandPool")                                             \
  X(vkAllocateCommandBuffers, ofMemory, nullptr)                                                \
  X(vkBeginCommandBuffer, ofMemory, nullptr)                                                    \
  X(vkEndCommandBuffer, ofMemory, nullptr)                                                      \
  X(vkQueueSubmit, ofMemory | ofDevice, nullptr)                                                \
  X(vkQueueSubmit2, ofMemory | ofDevice, nullptr)                                               \
  X(vkQueueWaitIdle, ofMemory | ofDevice, nullptr)                                              \
  X(vkDeviceWaitIdle, ofMemory | ofDevice, nullptr)                                             \
  X(vkResetFences, ofMemory, nullptr)                                                           \
  X(vkWaitForFences, ofMemory | ofDevice | ofTime, nullptr)                                     \
  X(vkGetFenceStatus, ofMemory | ofDevice, nullptr)                                             \
  X(vkWaitSemaphores, ofMemory | ofDevice | ofTime, nullptr)                                    \
  X(vkGetSemaphoreCounterValue, ofMemory | ofDevice, nullptr)                                   \
  X(vkGetQueryPoolResults, ofMemory | ofDevice, nullptr)                                        \
  X(vkCreateAccelerationStructureKHR, ofMemory, "VkAccelerationStructureKHR")                   \
  X(vkCreateSwapchainKHR, ofMemory | ofDevice | ofSurface | ofInitialization, "VkSwapchainKHR") \
  X(vkGetSwapchainImagesKHR, ofMemory, nullptr)                                                 \
  X(vkAcquireNextImageKHR, ofMemory | ofDevice | ofSurface | ofTime | ofAge, nullptr)           \
  X(vkQueuePresentKHR, ofMemory | ofDevice | ofSurface | ofAge, nullptr)

// name, kind of object
#define OPALINE_DESTROYING(X)                                        \
  X(vkDestroyDebugUtilsMessengerEXT, "VkDebugUtilsMessengerEXT")     \
  X(vkDestroyBuffer, "VkBuffer")                                     \
  X(vkDestroyBufferView, "VkBufferView")                             \
  X(vkDestroyImage, "VkImage")                                       \
  X(vkDestroyImageView, "VkImageView")                               \
  X(vkFreeMemory, "VkDeviceMemory")                                  \
  X(vkDestroySampler, "VkSampler")                                   \
  X(vkDestroyShaderModule, "VkShaderModule")                         \
  X(vkDestroyDescriptorSetLayout, "VkDescriptorSetLayout")           \
  X(vkDestroyDescriptorPool, "VkDescriptorPool")                     \
  X(vkDestroyPipelineCache, "VkPipelineCache")                       \
  X(vkDestroyPipelineLayout, "VkPipelineLayout")                     \
  X(vkDestroyPipeline, "VkPipeline")                                 \
  X(vkDestroyRenderPass, "VkRenderPass")                             \
  X(vkDestroyFramebuffer, "VkFramebuffer")                           \
  X(vkDestroyQueryPool, "VkQueryPool")                               \
  X(vkDestroySemaphore, "VkSemaphore")                               \
  X(vkDestroyFence, "VkFence")                                       \
  X(vkDestroyCommandPool, "VkCommandPool")                           \
  X(vkDestroyAccelerationStructureKHR, "VkAccelerationStructureKHR") \
  X(vkDestroySwapchainKHR, "VkSwapchainKHR")

#define OPALINE_CALL(function, kinds, object) \
  Call call_##function{.name = #function, .failures = kinds, .makes = object};
OPALINE_FAILING(OPALINE_CALL)
#undef OPALINE_CALL
#define OPALINE_CALL(function, object) \
  Call call_##function{.name = #function, .failures = 0, .makes = object};
OPALINE_DESTROYING(OPALINE_CALL)
#undef OPALINE_CALL

Call createInstance{.name = "vkCreateInstance", .failures = ofMemory | ofInitialization};
Call createDevice{.name = "vkCreateDevice", .failures = ofMemory | ofInitialization | ofDevice};

struct Entry {
  Call* call;
  PFN_vkVoidFunction run;
};

#define OPALINE_ENTRY(function, kinds, object) \
  Entry{&call_##function,                      \
        reinterpret_cast<PFN_vkVoidFunction>(&Failing<PFN_##function, call_##function>::run)},
#define OPALINE_END(function, object) \
  Entry{&call_##function,             \
        reinterpret_cast<PFN_vkVoidFunction>(&Destroying<PFN_##function, call_##function>::run)},
const Entry entries[] = {OPALINE_FAILING(OPALINE_ENTRY) OPALINE_DESTROYING(OPALINE_END)};
#undef OPALINE_ENTRY
#undef OPALINE_END

/// The link of the chain that the loader prepared for this layer.
template <typename Info>
Info* linkIn(const void* chain, VkStructureType type) {
  for (auto* info = static_cast<const VkBaseInStructure*>(chain); info != nullptr;
       info = info->pNext) {
    if (info->sType != type) continue;
    auto* link = const_cast<Info*>(reinterpret_cast<const Info*>(info));
    if (link->function == VK_LAYER_LINK_INFO) return link;
  }
  std::abort();
}

template <typename Find>
void find(const Find& next) {
  for (const Entry& entry : entries) {
    if (const PFN_vkVoidFunction found = next(entry.call->name); found != nullptr)
      entry.call->next = found;
    if (entry.call->makes != nullptr) entry.call->living = &state().living(entry.call->makes);
  }
}

VKAPI_ATTR VkResult VKAPI_CALL makeInstance(const VkInstanceCreateInfo* info,
                                            const VkAllocationCallbacks* allocator,
                                            VkInstance* instance) {
  auto* link =
      linkIn<VkLayerInstanceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
  nextOfInstance = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
  link->u.pLayerInfo = link->u.pLayerInfo->pNext;
  if (state().fails(createInstance, [] {})) return state().result();
  const auto create =
      reinterpret_cast<PFN_vkCreateInstance>(nextOfInstance(VK_NULL_HANDLE, "vkCreateInstance"));
  const VkResult result = create(info, allocator, instance);
  if (result < 0) return result;
  ++state().living("VkInstance");
  nextDestroyInstance[*instance] =
      reinterpret_cast<PFN_vkDestroyInstance>(nextOfInstance(*instance, "vkDestroyInstance"));
  nextGetProperties = reinterpret_cast<PFN_vkGetPhysicalDeviceProperties>(
      nextOfInstance(*instance, "vkGetPhysicalDeviceProperties"));
  nextGetProperties2 = reinterpret_cast<PFN_vkGetPhysicalDeviceProperties2>(
      nextOfInstance(*instance, "vkGetPhysicalDeviceProperties2"));
  find([&](const char* name) { return nextOfInstance(*instance, name); });
  return result;
}

VKAPI_ATTR void VKAPI_CALL destroyInstance(VkInstance instance,
                                           const VkAllocationCallbacks* allocator) {
  const auto next = nextDestroyInstance.extract(instance);
  if (next.empty()) return;
  next.mapped()(instance, allocator);
  --state().living("VkInstance");
}

VKAPI_ATTR VkResult VKAPI_CALL makeDevice(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                          const VkAllocationCallbacks* allocator, VkDevice* made) {
  auto* link =
      linkIn<VkLayerDeviceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
  const PFN_vkGetInstanceProcAddr instances = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
  nextOfDevice = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
  link->u.pLayerInfo = link->u.pLayerInfo->pNext;
  if (state().fails(createDevice, [] {})) return state().result();
  const auto create =
      reinterpret_cast<PFN_vkCreateDevice>(instances(VK_NULL_HANDLE, "vkCreateDevice"));
  const VkResult result = create(physical, info, allocator, made);
  if (result < 0) return result;
  ++state().living("VkDevice");
  device = *made;
  nextDestroyDevice = reinterpret_cast<PFN_vkDestroyDevice>(nextOfDevice(*made, "vkDestroyDevice"));
  find([&](const char* name) { return nextOfDevice(*made, name); });
  return result;
}

VKAPI_ATTR void VKAPI_CALL destroyDevice(VkDevice gone, const VkAllocationCallbacks* allocator) {
  if (device == gone) device = VK_NULL_HANDLE;
  nextDestroyDevice(gone, allocator);
  if (gone != VK_NULL_HANDLE) --state().living("VkDevice");
}

PFN_vkVoidFunction ours(std::string_view name);

std::string hiddenFunction;
std::string hiddenExtension;

VKAPI_ATTR VkResult VKAPI_CALL listExtensions(VkPhysicalDevice physical, const char* layer,
                                              std::uint32_t* count, VkExtensionProperties* list) {
  const VkResult result =
      Failing<PFN_vkEnumerateDeviceExtensionProperties,
              call_vkEnumerateDeviceExtensionProperties>::run(physical, layer, count, list);
  if (result < 0 || list == nullptr) return result;
  VkExtensionProperties* end =
      std::remove_if(list, list + *count, [](const VkExtensionProperties& extension) {
        return hiddenExtension == extension.extensionName;
      });
  *count = static_cast<std::uint32_t>(end - list);
  return result;
}

bool claimsHardware = std::getenv("OPALINE_CLAIM_HARDWARE") != nullptr;
std::uint32_t claimedTexels = 0;

void claim(VkPhysicalDeviceProperties& properties) {
  if (claimsHardware) properties.deviceType = VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU;
  if (claimedTexels > 0) properties.limits.maxTexelBufferElements = claimedTexels;
}

VKAPI_ATTR void VKAPI_CALL getProperties(VkPhysicalDevice physical,
                                         VkPhysicalDeviceProperties* properties) {
  nextGetProperties(physical, properties);
  claim(*properties);
}

VKAPI_ATTR void VKAPI_CALL getProperties2(VkPhysicalDevice physical,
                                          VkPhysicalDeviceProperties2* properties) {
  nextGetProperties2(physical, properties);
  claim(properties->properties);
}

}  // namespace

#define OPALINE_EXPORT extern "C" __attribute__((visibility("default")))

OPALINE_EXPORT VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL opalineGetDeviceProcAddr(VkDevice of,
                                                                                 const char* name) {
  if (hiddenFunction == name) return nullptr;
  const PFN_vkVoidFunction next = nextOfDevice(of, name);
  const PFN_vkVoidFunction here = ours(name);
  return here != nullptr && next != nullptr ? here : next;
}

OPALINE_EXPORT VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL
opalineGetInstanceProcAddr(VkInstance of, const char* name) {
  if (const PFN_vkVoidFunction here = ours(name); here != nullptr) return here;
  return nextOfInstance == nullptr ? nullptr : nextOfInstance(of, name);
}

OPALINE_EXPORT VKAPI_ATTR VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* version) {
  version->loaderLayerInterfaceVersion = 2;
  version->pfnGetInstanceProcAddr = opalineGetInstanceProcAddr;
  version->pfnGetDeviceProcAddr = opalineGetDeviceProcAddr;
  version->pfnGetPhysicalDeviceProcAddr = nullptr;
  return VK_SUCCESS;
}

namespace {

PFN_vkVoidFunction ours(std::string_view name) {
  const auto as = [](auto* function) { return reinterpret_cast<PFN_vkVoidFunction>(function); };
  if (name == "vkCreateInstance") return as(makeInstance);
  if (name == "vkDestroyInstance") return as(destroyInstance);
  if (name == "vkCreateDevice") return as(makeDevice);
  if (name == "vkDestroyDevice") return as(destroyDevice);
  if (name == "vkEnumerateDeviceExtensionProperties") return as(listExtensions);
  if (name == "vkGetPhysicalDeviceProperties") return as(getProperties);
  if (name == "vkGetPhysicalDeviceProperties2") return as(getProperties2);
  if (name == "vkGetInstanceProcAddr") return as(opalineGetInstanceProcAddr);
  if (name == "vkGetDeviceProcAddr") return as(opalineGetDeviceProcAddr);
  for (const Entry& entry : entries)
    if (name == entry.call->name) return entry.run;
  return nullptr;
}

}  // namespace

OPALINE_EXPORT void opalineArmFault(std::int32_t result, std::uint64_t nth, const char* function) {
  state().arm(static_cast<VkResult>(result), nth, function);
}

OPALINE_EXPORT void opalineHideFunction(const char* function) {
  hiddenFunction = function == nullptr ? "" : function;
}

OPALINE_EXPORT void opalineHideExtension(const char* extension) {
  hiddenExtension = extension == nullptr ? "" : extension;
}

OPALINE_EXPORT void opalineClaimHardware(bool claims) {
  claimsHardware = claims;
}

OPALINE_EXPORT void opalineClaimTexels(std::uint32_t most) {
  claimedTexels = most;
}

OPALINE_EXPORT std::uint64_t opalineCallsSinceArmed() {
  return state().calls();
}

OPALINE_EXPORT const char* opalineFaultedFunction() {
  return state().faulted();
}

OPALINE_EXPORT std::int64_t opalineLivingObjects() {
  return state().living();
}

OPALINE_EXPORT const char* opalineDescribeLivingObjects() {
  static std::string text;
  text = state().describe();
  return text.c_str();
}
