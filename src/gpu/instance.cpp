#include "gpu/instance.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include "gpu/vulkan_result.h"
#include "opaline/error.h"

namespace opaline::gpu {

const char* const noDeviceMessage =
    "no Vulkan device was found; install a Vulkan driver (Mesa's software device will do: package "
    "mesa-vulkan-drivers), or set VK_LOADER_DEBUG=error to see why one that is installed does not "
    "start";

namespace {

constexpr const char* validationLayer = "VK_LAYER_KHRONOS_validation";

bool hasLayer(const char* name) {
  std::uint32_t count = 0;
  check(vkEnumerateInstanceLayerProperties(&count, nullptr), "list its layers");
  std::vector<VkLayerProperties> layers(count);
  check(vkEnumerateInstanceLayerProperties(&count, layers.data()), "list its layers");
  return std::any_of(layers.begin(), layers.end(),
                     [&](const auto& layer) { return std::strcmp(layer.layerName, name) == 0; });
}

bool hasExtension(const char* name, const char* layer) {
  std::uint32_t count = 0;
  check(vkEnumerateInstanceExtensionProperties(layer, &count, nullptr), "list its extensions");
  std::vector<VkExtensionProperties> extensions(count);
  check(vkEnumerateInstanceExtensionProperties(layer, &count, extensions.data()),
        "list its extensions");
  return std::any_of(extensions.begin(), extensions.end(), [&](const auto& extension) {
    return std::strcmp(extension.extensionName, name) == 0;
  });
}

VKAPI_ATTR VkBool32 VKAPI_CALL onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                                         VkDebugUtilsMessageTypeFlagsEXT /*types*/,
                                         const VkDebugUtilsMessengerCallbackDataEXT* data,
                                         void* instance) {
  static_cast<Instance*>(instance)->report(severity, data->pMessage);
  return VK_FALSE;
}

VkApplicationInfo applicationInfo() {
  VkApplicationInfo info{};
  info.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
  info.pApplicationName = "Opaline";
  info.pEngineName = "Opaline";
  info.apiVersion = VK_API_VERSION_1_3;
  return info;
}

VkInstance start(const VkInstanceCreateInfo& info) {
  VkInstance instance = VK_NULL_HANDLE;
  const VkResult result = vkCreateInstance(&info, nullptr, &instance);
  if (result == VK_ERROR_INCOMPATIBLE_DRIVER) throw Error(noDeviceMessage);
  check(result, "start");
  return instance;
}

// The loader closes drivers with the last instance and opens them again with the next. A process
// can do that only so often: with NVIDIA's driver 580 the 32nd instance found no device. So one
// instance stays until the process ends. It is made after drivers have registered their exit
// handlers, and so is destroyed before these run.
class KeptInstance {
 public:
  KeptInstance() {
    const VkApplicationInfo application = applicationInfo();
    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pApplicationInfo = &application;
    instance_ = start(info);
  }
  ~KeptInstance() { vkDestroyInstance(instance_, nullptr); }
  KeptInstance(const KeptInstance&) = delete;
  KeptInstance& operator=(const KeptInstance&) = delete;

 private:
  VkInstance instance_ = VK_NULL_HANDLE;
};

VkDebugUtilsMessengerCreateInfoEXT messengerInfo(Instance* instance) {
  VkDebugUtilsMessengerCreateInfoEXT info{};
  info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
  info.messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT |
                         VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  // Not GENERAL, by which the loader reports on other drivers of the machine.
  info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT |
                     VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
  info.pfnUserCallback = onMessage;
  info.pUserData = instance;
  return info;
}

}  // namespace

Instance::Instance(bool validation, LogCallback log, const std::vector<std::string>& extensions)
    : log_(std::move(log)) {
  create(validation, extensions);
  if (!validation) return;
  const auto createMessenger = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
      vkGetInstanceProcAddr(instance_, "vkCreateDebugUtilsMessengerEXT"));
  const VkDebugUtilsMessengerCreateInfoEXT info = messengerInfo(this);
  const VkResult result = createMessenger(instance_, &info, nullptr, &messenger_);
  if (result < 0) {
    vkDestroyInstance(instance_, nullptr);
    check(result, "listen to the validation layer");
  }
}

void Instance::create(bool validation, const std::vector<std::string>& wanted) {
  std::uint32_t version = 0;
  check(vkEnumerateInstanceVersion(&version), "say its version");
  if (version < VK_API_VERSION_1_3) {
    throw Error("the Vulkan loader is older than version 1.3; install a newer libvulkan1");
  }
  if (validation && !hasLayer(validationLayer)) {
    throw Error(
        "the Vulkan validation layer is not installed; install the package "
        "vulkan-validationlayers, or do without validation");
  }
  const bool debugUtils =
      hasExtension(VK_EXT_DEBUG_UTILS_EXTENSION_NAME, nullptr) ||
      (validation && hasExtension(VK_EXT_DEBUG_UTILS_EXTENSION_NAME, validationLayer));

  const VkApplicationInfo application = applicationInfo();
  std::vector<const char*> extensions;
  if (debugUtils) extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
  for (const std::string& name : wanted) extensions.push_back(name.c_str());
  const VkDebugUtilsMessengerCreateInfoEXT messenger = messengerInfo(this);
  VkInstanceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
  info.pNext = validation ? &messenger : nullptr;  // receives messages of vkCreateInstance and
                                                   // vkDestroyInstance
  info.pApplicationInfo = &application;
  info.enabledLayerCount = validation ? 1 : 0;
  info.ppEnabledLayerNames = &validationLayer;
  info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
  info.ppEnabledExtensionNames = extensions.data();
  static const KeptInstance kept;
  instance_ = start(info);
}

Instance::~Instance() {
  if (messenger_ != VK_NULL_HANDLE) {
    const auto destroyMessenger = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(instance_, "vkDestroyDebugUtilsMessengerEXT"));
    destroyMessenger(instance_, messenger_, nullptr);
  }
  vkDestroyInstance(instance_, nullptr);
}

std::vector<VkPhysicalDevice> Instance::physicalDevices() const {
  std::uint32_t count = 0;
  const VkResult result = vkEnumeratePhysicalDevices(instance_, &count, nullptr);
  // A driver that fails to start, for example for lack of its hardware, counts as no device.
  if (result == VK_ERROR_INITIALIZATION_FAILED) return {};
  check(result, "list the devices");
  std::vector<VkPhysicalDevice> devices(count);
  check(vkEnumeratePhysicalDevices(instance_, &count, devices.data()), "list the devices");
  devices.resize(count);
  return devices;
}

void Instance::report(VkDebugUtilsMessageSeverityFlagBitsEXT severity, const char* message) {
  ++messages_;
  if (!log_) return;
  std::string text = severity >= VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT
                         ? "Vulkan validation error: "
                         : "Vulkan validation warning: ";
  text += message != nullptr ? message : "(no text)";
  while (!text.empty() && text.back() == '\n') text.pop_back();
  log_(LogLevel::Warning, text);
}

}  // namespace opaline::gpu
