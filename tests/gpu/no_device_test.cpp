#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "gpu/device.h"
#include "opaline/error.h"

namespace opaline::gpu {
namespace {

// The loader keeps what it has found for the life of the process, so a search that finds no driver
// needs its own process.
void exitWithZeroIfThereIsNoDevice() {
  for (const char* name : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES"}) {
    setenv(name, "/nonexistent/driver.json", 1);
  }
  unsetenv("VK_ADD_DRIVER_FILES");
  if (!Device::list().empty()) std::exit(2);
  try {
    const Device device;
  } catch (const UsageError&) {
    std::exit(3);
  } catch (const Error& error) {
    const bool clear =
        std::string(error.what()) ==
        "no Vulkan device was found; install a Vulkan driver (Mesa's software device will do: "
        "package mesa-vulkan-drivers), or set VK_LOADER_DEBUG=error to see why one that is "
        "installed does not start";
    std::exit(clear ? 0 : 4);
  }
  std::exit(5);
}

void exitWithZeroIfThereIsNoValidationLayer() {
  setenv("VK_LAYER_PATH", "/nonexistent", 1);
  try {
    const Device device({"", true, {}});
  } catch (const Error& error) {
    const bool clear =
        std::string(error.what()).find("vulkan-validationlayers") != std::string::npos;
    std::exit(clear ? 0 : 4);
  }
  std::exit(5);
}

// "^$": nothing may be printed.
TEST(NoDeviceDeathTest, IsAnEmptyListAndAClearError) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(exitWithZeroIfThereIsNoDevice(), testing::ExitedWithCode(0), "^$");
}

TEST(NoDeviceDeathTest, ValidationThatIsNotInstalledIsAClearError) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(exitWithZeroIfThereIsNoValidationLayer(), testing::ExitedWithCode(0), "^$");
}

}  // namespace
}  // namespace opaline::gpu
