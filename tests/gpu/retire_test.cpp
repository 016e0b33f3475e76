#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "gpu/command_list.h"
#include "gpu/gpu_fixture.h"
#include "gpu/helpers.h"
#include "gpu/transfer.h"

namespace opaline::gpu {
namespace {

// The validation layer reports objects that are destroyed while the device uses them, and any
// message fails the test.
using RetireTest = GpuTest;

constexpr std::size_t megabytes = 16;

Buffer bigBuffer(Device& device) {
  return Buffer(device, {.name = "big", .bytes = megabytes << 20U});
}

TEST_F(RetireTest, ResourcesMayGoWhileTheDeviceWorksWithThem) {
  Buffer kept = makeBuffer(device(), "kept", std::vector<std::uint32_t>(4, 0U), 0);
  for (std::uint32_t i = 1; i <= 4; ++i) {
    CommandList list(device(), "fill", 1);
    Buffer buffer = bigBuffer(device());
    GpuImage image(device(), {.name = "image",
                              .width = 256,
                              .height = 256,
                              .format = VK_FORMAT_R32G32B32A32_SFLOAT,
                              .usage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                                       VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_SAMPLED_BIT,
                              .lent = i % 2 == 0});
    list.begin();
    list.beginPass("fill");
    list.fill({buffer}, i);
    list.copyToImage(buffer, image);
    list.copyBuffer(buffer, kept, 16);
    list.endPass();
    list.submit();
  }
  EXPECT_EQ(readAs<std::uint32_t>(device(), kept), std::vector<std::uint32_t>(4, 4U));
}

TEST_F(RetireTest, MemoryComesBackWhenTheDeviceHasFinished) {
  Device fresh;
  for (int i = 0; i < 6; ++i) {
    CommandList list(fresh, "fill", 0);
    Buffer buffer = bigBuffer(fresh);
    list.begin();
    list.fill({buffer}, 1);
    list.submit();
    list.wait();
  }
  EXPECT_LT(fresh.peakMemoryBytes(), 2 * (megabytes << 20U));
}

TEST_F(RetireTest, SubmissionsAreNumberedAndWaitedForByNumber) {
  const std::uint64_t before = device().submitted();
  std::vector<std::unique_ptr<CommandList>> lists;
  Buffer buffer = bigBuffer(device());
  for (std::uint32_t i = 1; i <= 3; ++i) {
    lists.push_back(std::make_unique<CommandList>(device(), "fill", 0));
    lists.back()->begin();
    lists.back()->fill({buffer}, i);
    lists.back()->submit();
    EXPECT_EQ(device().submitted(), before + i);
  }
  device().waitFor(before + 2);
  device().waitFor(before + 3);
  lists.clear();
  EXPECT_EQ(readAs<std::uint32_t>(device(), buffer)[7], 3U);
}

// A slice is not overwritten before the device has read it.
TEST_F(RetireTest, SlicesOfAnUploadRingWaitForTheirReaders) {
  constexpr std::uint32_t rounds = 12;
  UploadRing ring(device(), "ring", 16, 2, 0);
  Buffer big = bigBuffer(device());
  Buffer found = makeBuffer(device(), "found", std::vector<std::uint32_t>(rounds, 0U), 0);
  std::vector<std::unique_ptr<CommandList>> lists;
  for (std::uint32_t i = 0; i < rounds; ++i) {
    ring.nextFrame();
    const std::size_t offset = ring.push(i + 100);
    lists.push_back(std::make_unique<CommandList>(device(), "copy", 0));
    lists.back()->begin();
    lists.back()->fill({big}, i);  // takes a while
    lists.back()->copyBuffer(ring.buffer(), found, 4, offset, i * std::size_t{4});
    lists.back()->submit();
  }
  const std::vector<std::uint32_t> values = readAs<std::uint32_t>(device(), found);
  for (std::uint32_t i = 0; i < rounds; ++i) EXPECT_EQ(values[i], i + 100);
}

}  // namespace
}  // namespace opaline::gpu
