#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

#include "core/memory.h"
#include "gpu/buffer.h"
#include "gpu/device.h"
#include "gpu/host_room.h"
#include "opaline/error.h"

namespace opaline::gpu {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr std::size_t megabyte = 1'000'000;

#ifndef __SANITIZE_ADDRESS__  // it takes terabytes of address space itself

/// The address space in use, to which the limit applies.
std::size_t bytesTaken() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return 4096 * pages;
}

void leaveOnly(std::size_t bytes) {
  rlimit limit{};
  getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = bytesTaken() + bytes;
  setrlimit(RLIMIT_AS, &limit);
}

void exitWithZeroIfRoomIsToldTrulyWith(std::size_t bytes) {
  leaveOnly(bytes);
  std::exit(core::hasRoomFor(bytes / 2) && !core::hasRoomFor(2 * bytes) ? 0 : 1);
}

void exitWithZeroIfNoDeviceIsOpenedWith(std::size_t bytes) {
  leaveOnly(bytes);
  try {
    const Device device;
  } catch (const Error& error) {
    std::cerr << error.what();
    std::exit(0);
  }
  std::exit(1);
}

// A limit of address space cannot always be undone, so each test has its own process.
TEST(HostMemoryDeathTest, IsAskedForWithoutTakingIt) {
  EXPECT_EXIT(exitWithZeroIfRoomIsToldTrulyWith(200 * megabyte), testing::ExitedWithCode(0), "");
  EXPECT_TRUE(core::hasRoomFor(megabyte));
}

TEST(HostMemoryDeathTest, AnErrorSaysThatThereIsTooLittleForADevice) {
  EXPECT_EXIT(exitWithZeroIfNoDeviceIsOpenedWith(roomToOpenDevice / 2), testing::ExitedWithCode(0),
              "raise the limit of its memory");
}
#endif

TEST(MemoryLimit, HoldsForAllBuffersTogetherUntilTheyAreGone) {
  Device device({.mostMemoryBytes = 10 * megabyte});
  const auto buffer = [&](const char* name) {
    return Buffer(device, {name, 4 * megabyte, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, Memory::Device});
  };
  Buffer first = buffer("first");
  const Buffer second = buffer("second");
  try {
    buffer("third");
    FAIL() << "more memory than may be taken";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(),
                AllOf(HasSubstr("\"third\" needs 4.0 MB"), HasSubstr("8.0 MB of the 10 MB"),
                      HasSubstr("raise the memory limit")));
  }
  first = Buffer();
  EXPECT_NO_THROW(buffer("third"));
}

}  // namespace
}  // namespace opaline::gpu
