#include "gpu/vulkan_functions.h"

#include <fmt/core.h>

#include <type_traits>

#include "opaline/error.h"

namespace opaline::gpu {

namespace {

template <typename Function>
void take(Function& function, PFN_vkVoidFunction loaded, const char* name) {
  if (loaded == nullptr)
    throw Error(fmt::format("Vulkan has no {}; update the driver or the Vulkan loader", name));
  function = reinterpret_cast<Function>(loaded);
}

}  // namespace

InstanceFunctions loadInstanceFunctions(PFN_vkGetInstanceProcAddr load, VkInstance instance) {
  InstanceFunctions functions;
#define OPALINE_LOAD(name) take(functions.name, load(instance, #name), #name);
  OPALINE_INSTANCE_FUNCTIONS(OPALINE_LOAD)
#undef OPALINE_LOAD
  return functions;
}

DeviceFunctions loadDeviceFunctions(const InstanceFunctions& instance, VkDevice device) {
  DeviceFunctions functions;
#define OPALINE_LOAD(name) take(functions.name, instance.vkGetDeviceProcAddr(device, #name), #name);
  OPALINE_DEVICE_FUNCTIONS(OPALINE_LOAD)
#undef OPALINE_LOAD
  return functions;
}

}  // namespace opaline::gpu
