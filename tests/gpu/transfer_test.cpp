#include "gpu/transfer.h"

#include <gtest/gtest.h>

#include <numeric>
#include <utility>

#include "gpu/gpu_fixture.h"
#include "gpu/helpers.h"
#include "opaline/error.h"

namespace opaline::gpu {
namespace {

using TransferTest = GpuTest;

TEST_F(TransferTest, BufferComesBackAsItWent) {
  std::vector<std::uint32_t> values(100'003);
  std::iota(values.begin(), values.end(), 7U);
  Buffer buffer = makeBuffer(device(), "values", values, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  EXPECT_EQ(buffer.bytes(), values.size() * 4);
  EXPECT_EQ(readAs<std::uint32_t>(device(), buffer), values);

  Buffer moved = std::move(buffer);
  EXPECT_FALSE(buffer);  // NOLINT(bugprone-use-after-move): moved from is empty
  EXPECT_EQ(readAs<std::uint32_t>(device(), moved), values);
}

TEST_F(TransferTest, EmptyDataGivesABufferThatCanBeBound) {
  Buffer buffer =
      makeBuffer(device(), "nothing", std::vector<float>{}, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  EXPECT_EQ(readAs<std::uint32_t>(device(), buffer), std::vector<std::uint32_t>(4, 0U));
}

TEST_F(TransferTest, FillAndPartialCopy) {
  Buffer to = makeBuffer(device(), "to", std::vector<std::uint32_t>(8, 1U), 0);
  Buffer from = makeBuffer(device(), "from", std::vector<std::uint32_t>{10, 11, 12, 13}, 0);
  CommandList list(device(), "copy");
  list.begin();
  list.fill({to}, 5);
  list.copyBuffer(from, to, 8, 4, 16);
  list.submit();
  list.wait();
  EXPECT_EQ(readAs<std::uint32_t>(device(), to),
            (std::vector<std::uint32_t>{5, 5, 5, 5, 11, 12, 5, 5}));
}

TEST_F(TransferTest, EveryLayerAndLevelOfAnImageKeepsItsOwnTexels) {
  ImageOptions options;
  options.name = "layers";
  options.width = 13;
  options.height = 6;
  options.layers = 3;
  options.mipLevels = 3;
  options.format = VK_FORMAT_R16G16B16A16_UNORM;
  options.usage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  options.kind = ImageKind::Array;
  GpuImage image(device(), options);
  const auto texels = [](std::uint32_t layer, std::uint32_t level) {
    // 13 x 6, 6 x 3 and 3 x 1 texels: halves are rounded down.
    const std::size_t sizes[] = {78, 18, 3};
    std::vector<std::uint16_t> values(4 * sizes[level]);
    std::iota(values.begin(), values.end(), static_cast<std::uint16_t>(1000 * layer + 400 * level));
    return values;
  };
  for (std::uint32_t layer = 0; layer < 3; ++layer) {
    for (std::uint32_t level = 0; level < 3; ++level) {
      uploadImage(device(), image, bytesOf(texels(layer, level)), layer, level);
    }
  }
  GpuImage moved;
  moved = std::move(image);
  for (std::uint32_t layer = 0; layer < 3; ++layer) {
    for (std::uint32_t level = 0; level < 3; ++level) {
      EXPECT_EQ(readAs<std::uint16_t>(device(), moved, 8, layer, level), texels(layer, level))
          << "layer " << layer << ", level " << level;
    }
  }
}

TEST_F(TransferTest, RingGivesAlignedOffsetsInSlicesThatDoNotOverlap) {
  UploadRing ring(device(), "ring", 1000, 2, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
  const VkPhysicalDeviceLimits& limits = device().limits();
  const std::size_t first = ring.push(std::uint32_t{1});
  const std::size_t second = ring.push(std::uint32_t{2});
  EXPECT_GE(second, first + 4);
  for (const std::size_t offset : {first, second}) {
    EXPECT_EQ(offset % limits.minUniformBufferOffsetAlignment, 0U);
    EXPECT_EQ(offset % limits.minStorageBufferOffsetAlignment, 0U);
  }
  ring.nextFrame();
  const std::size_t other = ring.push(std::uint32_t{3});
  EXPECT_GE(other, 1000U);
  ring.nextFrame();
  EXPECT_EQ(ring.push(std::uint32_t{4}), first);
  const auto words = ring.buffer().mappedAs<std::uint32_t>();
  EXPECT_EQ(words[first / 4], 4U);
  EXPECT_EQ(words[second / 4], 2U);
  EXPECT_EQ(words[other / 4], 3U);
}

TEST_F(TransferTest, FullRingThrowsAndStaysWhole) {
  UploadRing ring(device(), "small ring", 512, 2, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
  const std::vector<std::byte> all(512, std::byte{1});
  EXPECT_EQ(ring.push(std::span<const std::byte>(all)), 0U);
  // What is left of the slice is at most its rounding up to the alignment.
  const std::vector<std::byte> more(512, std::byte{2});
  try {
    ring.push(std::span<const std::byte>(more));
    FAIL() << "a full ring took more";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("small ring"), std::string::npos) << error.what();
  }
  EXPECT_EQ(ring.buffer().mapped()[0], std::byte{1});
  EXPECT_EQ(ring.buffer().mapped()[511], std::byte{1});
  ring.nextFrame();
  EXPECT_NO_THROW(ring.push(std::span<const std::byte>(more)));
}

}  // namespace
}  // namespace opaline::gpu
