#include "gpu/pipeline.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <map>
#include <utility>
#include <vector>

#include "gpu/command_list.h"
#include "gpu/gpu_fixture.h"
#include "gpu/helpers.h"
#include "shaders/add.comp.h"

namespace {

int compiled = 0;
PFN_vkGetDeviceProcAddr loadOfDevice = nullptr;
std::map<VkDevice, PFN_vkCreateComputePipelines> createPipelines;

VKAPI_ATTR VkResult VKAPI_CALL count(VkDevice device, VkPipelineCache cache, std::uint32_t count,
                                     const VkComputePipelineCreateInfo* infos,
                                     const VkAllocationCallbacks* allocator,
                                     VkPipeline* pipelines) {
  ++compiled;
  return createPipelines.at(device)(device, cache, count, infos, allocator, pipelines);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL loadCounting(VkDevice device, const char* name) {
  const PFN_vkVoidFunction loaded = loadOfDevice(device, name);
  if (std::strcmp(name, "vkCreateComputePipelines") != 0) return loaded;
  createPipelines[device] = reinterpret_cast<PFN_vkCreateComputePipelines>(loaded);
  return reinterpret_cast<PFN_vkVoidFunction>(count);
}

}  // namespace

// Replaces the loader's function in this program, to count calls.
extern "C" VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL vkGetInstanceProcAddr(VkInstance instance,
                                                                          const char* name) {
  static const auto load =
      reinterpret_cast<PFN_vkGetInstanceProcAddr>(dlsym(RTLD_NEXT, "vkGetInstanceProcAddr"));
  const PFN_vkVoidFunction loaded = load(instance, name);
  if (std::strcmp(name, "vkGetDeviceProcAddr") != 0) return loaded;
  loadOfDevice = reinterpret_cast<PFN_vkGetDeviceProcAddr>(loaded);
  return reinterpret_cast<PFN_vkVoidFunction>(loadCounting);
}

namespace opaline::gpu {
namespace {

using PipelineTest = GpuTest;

TEST_F(PipelineTest, IsCompiledWhenItIsFirstBoundAndOnlyThen) {
  const std::vector<std::uint32_t> values(64, 3U);
  Buffer input = makeBuffer(device(), "input", values, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  Buffer output = makeBuffer(device(), "output", values, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  const int before = compiled;
  const Compute<shaders::Add> unused(device(), "unused");
  Compute<shaders::Add> made(device(), "add");
  const Compute<shaders::Add> pipeline(std::move(made));
  EXPECT_EQ(compiled, before);

  CommandList list(device(), "twice");
  for (int i = 0; i < 2; ++i) {
    list.begin();
    list.bind(pipeline, {.values = input, .results = output}, {.count = 64});
    list.dispatch(1);
    list.submit();
    EXPECT_EQ(compiled, before + 1);
  }
  list.wait();
}

}  // namespace
}  // namespace opaline::gpu
