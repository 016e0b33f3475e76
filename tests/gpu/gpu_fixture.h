#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gpu/device.h"
#include "gpu/instance.h"
#include "opaline/error.h"

namespace opaline::gpu {

/// The device of all GPU tests in a process, opened at first use with the validation layer on, and
/// the layer's messages.
struct SharedDevice {
  DeviceOptions options{.validation = true};
  std::unique_ptr<Device> device;
  std::string reason;  ///< why there is no device
  bool opened = false;
  std::vector<std::string> messages;

  void open() {
    if (std::exchange(opened, true)) return;
    options.log = [this](LogLevel, std::string_view message) { messages.emplace_back(message); };
    try {
      device = std::make_unique<Device>(options);
      // Never closed: it keeps the driver loaded, whose globals the leak checker would otherwise
      // take for lost memory.
      static const Instance* const driver = new Instance;
      static_cast<void>(driver);
    } catch (const Error& error) {
      reason = error.what();
    }
  }
  /// Any message fails the current test.
  void reportMessages() {
    for (const std::string& message : std::exchange(messages, {})) ADD_FAILURE() << message;
  }
};

inline SharedDevice& sharedDevice() {
  static SharedDevice shared;
  return shared;
}

/// A device that casts rays by VK_KHR_ray_query, if there is one.
inline SharedDevice& sharedRayQueryDevice() {
  static SharedDevice shared{.options = {.validation = true, .rayQueries = true}};
  return shared;
}

/// Closes the devices after the last test; the layer then reports objects that were left behind.
class CloseSharedDevice : public testing::Environment {
 public:
  void TearDown() override {
    for (SharedDevice* shared : {&sharedDevice(), &sharedRayQueryDevice()}) {
      shared->device.reset();
      shared->reportMessages();
    }
  }
};

inline const testing::Environment* const closeSharedDevice =
    testing::AddGlobalTestEnvironment(new CloseSharedDevice);

/// A test that needs a device: fails where there is none, and on any validation message.
class GpuTest : public testing::Test {
 protected:
  void SetUp() override {
    sharedDevice().open();
    ASSERT_NE(sharedDevice().device, nullptr)
        << "GPU tests need a Vulkan device and the validation layer: " << sharedDevice().reason;
  }
  void TearDown() override { sharedDevice().reportMessages(); }

  static Device& device() { return *sharedDevice().device; }
};

}  // namespace opaline::gpu
