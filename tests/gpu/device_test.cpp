#include <gtest/gtest.h>
#include <link.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <string>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/device_choice.h"
#include "gpu/gpu_fixture.h"
#include "gpu/image.h"
#include "opaline/error.h"

namespace opaline::gpu {
namespace {

DeviceInfo made(std::uint32_t index, const char* name, DeviceType type, const char* missing = "") {
  DeviceInfo info;
  info.index = index;
  info.name = name;
  info.type = type;
  info.missing = missing;
  return info;
}

std::vector<DeviceInfo> machine() {
  return {made(0, "llvmpipe", DeviceType::Software),
          made(1, "Virtio-GPU", DeviceType::Virtual),
          made(2, "Old Card 4090", DeviceType::Discrete, "dynamicRendering"),
          made(3, "Intel Iris", DeviceType::Integrated),
          made(4, "Big Card", DeviceType::Discrete),
          made(5, "Second Big Card", DeviceType::Discrete)};
}

template <typename Thrown, typename Action>
std::string messageOf(Action action) {
  try {
    action();
  } catch (const Thrown& error) {
    return error.what();
  }
  return {};
}

TEST(DeviceChoice, PrefersDiscreteThenIntegratedThenVirtualThenSoftware) {
  std::vector<DeviceInfo> devices = machine();
  EXPECT_EQ(choose(devices, ""), 4U);
  devices.resize(4);
  EXPECT_EQ(choose(devices, ""), 3U);
  devices.resize(2);
  EXPECT_EQ(choose(devices, ""), 1U);
  devices.resize(1);
  EXPECT_EQ(choose(devices, ""), 0U);
}

TEST(DeviceChoice, TakesAnIndexOrAPartOfTheNameInAnyCase) {
  EXPECT_EQ(choose(machine(), "1"), 1U);
  EXPECT_EQ(choose(machine(), "LLVM"), 0U);
  EXPECT_EQ(choose(machine(), "iris"), 3U);
  EXPECT_EQ(choose(machine(), "second"), 5U);
}

TEST(DeviceChoice, RefusesADeviceThatLacksSomethingAndSaysWhat) {
  for (const char* selector : {"2", "old card", "4090"}) {
    const std::string message = messageOf<Error>([&] { choose(machine(), selector); });
    EXPECT_NE(message.find("Old Card 4090"), std::string::npos) << message;
    EXPECT_NE(message.find("dynamicRendering"), std::string::npos) << message;
  }
}

TEST(DeviceChoice, NamesTheDevicesWhenNoneFits) {
  for (const char* selector : {"nvidia", "6", "99999999999999999999999", "-1"}) {
    const std::string message = messageOf<UsageError>([&] { choose(machine(), selector); });
    EXPECT_NE(message.find(selector), std::string::npos) << message;
    for (const DeviceInfo& device : machine()) {
      EXPECT_NE(message.find(device.name), std::string::npos) << message;
    }
  }
}

TEST(DeviceChoice, SaysWhatToInstallWhenThereIsNoDevice) {
  EXPECT_NE(messageOf<Error>([] { choose({}, "0"); }).find("mesa-vulkan-drivers"),
            std::string::npos);
}

// The limits that Vulkan guarantees for every device are too low.
TEST(DeviceChoice, SaysWhichLimitsAreTooLow) {
  VkPhysicalDeviceLimits limits{};
  limits.maxPerStageDescriptorStorageBuffers = 4;
  EXPECT_EQ(lackOfRoom(limits), "16 storage buffers in one shader (it has 4)");
  limits.maxPerStageDescriptorStorageBuffers = 16;
  EXPECT_EQ(lackOfRoom(limits), "");
}

TEST(DeviceChoice, SaysWhichUsesOfFormatsAreMissing) {
  constexpr VkFormatFeatureFlags everything = ~VkFormatFeatureFlags{0};
  EXPECT_EQ(lackOfFormats([](VkFormat) { return everything; }), "");
  const auto without = [](VkFormat lacking, VkFormatFeatureFlags feature) {
    return lackOfFormats(
        [=](VkFormat format) { return format == lacking ? everything & ~feature : everything; });
  };
  EXPECT_EQ(
      without(VK_FORMAT_R32G32B32A32_SFLOAT, VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT),
      "linear filtering of images of 32-bit floats");
  EXPECT_EQ(without(VK_FORMAT_D32_SFLOAT, VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT),
            "depth maps of 32-bit floats");
  // Blending is not needed.
  EXPECT_EQ(without(VK_FORMAT_R32G32B32A32_SFLOAT, VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT),
            "");
}

using DeviceTest = GpuTest;

TEST_F(DeviceTest, ListsTheDeviceThatItOpens) {
  const std::vector<DeviceInfo> all = Device::list();
  const DeviceInfo& mine = device().info();
  ASSERT_LT(mine.index, all.size());
  EXPECT_EQ(all[mine.index].name, mine.name);
  EXPECT_EQ(all[mine.index].driver, mine.driver);
  EXPECT_FALSE(mine.name.empty());
  EXPECT_FALSE(mine.driver.empty());
  EXPECT_TRUE(mine.missing.empty());
}

TEST_F(DeviceTest, OpensByIndexAndByName) {
  const DeviceInfo& mine = device().info();
  EXPECT_EQ(Device({std::to_string(mine.index), false, {}}).info().name, mine.name);
  std::string upper = mine.name.substr(0, 5);
  std::transform(upper.begin(), upper.end(), upper.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  EXPECT_EQ(Device({upper, false, {}}).info().name, mine.name);
  EXPECT_THROW(Device({"no such device", false, {}}), UsageError);
}

std::vector<std::string> loadedLibraries() {
  std::vector<std::string> names;
  dl_iterate_phdr(
      [](dl_phdr_info* info, std::size_t, void* list) {
        static_cast<std::vector<std::string>*>(list)->emplace_back(info->dlpi_name);
        return 0;
      },
      &names);
  std::sort(names.begin(), names.end());
  return names;
}

void exitWithZeroIfADriverStaysOpen() {
  { const Device first; }
  const std::vector<std::string> closed = loadedLibraries();
  const Device second;
  std::exit(loadedLibraries() == closed ? 0 : 2);
}

// A process can load drivers only so often. This one has its own process, since devices of other
// tests are open.
TEST(DriversDeathTest, AreNotClosedWithADevice) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(exitWithZeroIfADriverStaysOpen(), testing::ExitedWithCode(0), "^$");
}

TEST_F(DeviceTest, CountsMemory) {
  const std::size_t before = device().peakMemoryBytes();
  constexpr std::size_t bytes = 8U << 20;
  // Larger than whatever was alive before, so that the peak must rise.
  const Buffer first(device(), {"first", before + bytes, 0, Memory::Device});
  EXPECT_GE(device().peakMemoryBytes(), before + bytes);
}

TEST_F(DeviceTest, RefusesWhatIsLargerThanTheDeviceCanDo) {
  const VkPhysicalDeviceLimits& limits = device().limits();
  ImageOptions wide;
  wide.name = "wide map";
  wide.width = limits.maxImageDimension2D + 1;
  wide.format = VK_FORMAT_R8G8B8A8_UNORM;
  wide.usage = VK_IMAGE_USAGE_SAMPLED_BIT;
  EXPECT_NE(messageOf<Error>([&] { GpuImage(device(), wide); }).find("wide map"),
            std::string::npos);

  ImageOptions deep = wide;
  deep.width = 1;
  deep.kind = ImageKind::Array;
  deep.layers = limits.maxImageArrayLayers + 1;
  EXPECT_THROW(GpuImage(device(), deep), Error);

  BufferOptions storage;
  storage.name = "too many vertices";
  storage.bytes = std::size_t{limits.maxStorageBufferRange} + 1;
  storage.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  const std::string message = messageOf<Error>([&] { Buffer(device(), storage); });
  EXPECT_NE(message.find("too many vertices"), std::string::npos) << message;
  EXPECT_NE(message.find(" MB"), std::string::npos) << message;

  EXPECT_THROW(Buffer(device(), {"endless", std::size_t{1} << 60, 0, Memory::Device}), Error);
}

TEST_F(DeviceTest, SaysWhenMemoryRunsOut) {
  const std::size_t before = device().peakMemoryBytes();
  VkMemoryRequirements requirements{};
  requirements.size = std::size_t{1} << 50;
  requirements.memoryTypeBits = ~0U;
  const std::string message =
      messageOf<Error>([&] { device().allocate(requirements, 0, 0, "huge map"); });
  EXPECT_NE(message.find("huge map"), std::string::npos) << message;
  EXPECT_NE(message.find("MB"), std::string::npos) << message;
  EXPECT_EQ(device().peakMemoryBytes(), before);
}

TEST_F(DeviceTest, CountsAndLogsValidationMessages) {
  std::vector<std::string> said;
  DeviceOptions options;
  options.validation = true;
  options.log = [&](LogLevel level, std::string_view message) {
    EXPECT_EQ(level, LogLevel::Warning);
    said.emplace_back(message);
  };
  Device own(options);
  EXPECT_EQ(own.validationMessages(), 0U);
  VkSamplerCreateInfo info{};  // without its sType
  VkSampler sampler = VK_NULL_HANDLE;
  vkCreateSampler(own.handle(), &info, nullptr, &sampler);
  EXPECT_GE(own.validationMessages(), 1U);
  EXPECT_EQ(said.size(), own.validationMessages());
  ASSERT_FALSE(said.empty());
  EXPECT_NE(said.front().find("VkSamplerCreateInfo"), std::string::npos) << said.front();
  vkDestroySampler(own.handle(), sampler, nullptr);
}

}  // namespace
}  // namespace opaline::gpu
