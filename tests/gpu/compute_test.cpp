#include <gtest/gtest.h>

#include <numeric>

#include "gpu/command_list.h"
#include "gpu/gpu_fixture.h"
#include "gpu/helpers.h"
#include "gpu/pipeline.h"
#include "gpu/transfer.h"
#include "shaders/add.comp.h"
#include "shaders/fill_image.comp.h"
#include "shaders/invocations.comp.h"
#include "shaders/scale.comp.h"
#include "shaders/tiles.comp.h"

namespace opaline::gpu {
namespace {

using ComputeTest = GpuTest;

constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;

Buffer zeros(Device& device, const char* name, std::size_t count) {
  return makeBuffer(device, name, std::vector<std::uint32_t>(count, 0U), storage);
}

TEST_F(ComputeTest, PushConstantsSpecializationUniformsAndBuffersArrive) {
  constexpr std::uint32_t count = 1000;
  std::vector<std::uint32_t> values(count);
  std::iota(values.begin(), values.end(), 0U);
  Buffer input = makeBuffer(device(), "input", values, storage);
  Buffer output = zeros(device(), "output", count + 24);
  UploadRing ring(device(), "ring", 1024, 2, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
  ring.push(std::array<std::uint32_t, 4>{1, 1, 1, 1});
  const std::size_t offset = ring.push(std::array<std::uint32_t, 4>{100'000, 0, 0, 0});

  constexpr std::uint32_t groupSize = 32;
  const Compute<shaders::Scale> pipeline(device(), "scale", {.groupSize = groupSize, .addend = 7});

  CommandList list(device(), "compute");
  for (std::uint32_t frame = 1; frame <= 3; ++frame) {  // the list is used again and again
    list.begin();
    list.bind(pipeline, {.values = input, .results = output, .offset = {ring.buffer(), offset, 16}},
              {.factor = frame, .count = count});
    list.dispatch((count + groupSize - 1) / groupSize);
    list.submit();
    list.wait();
    const auto results = readAs<std::uint32_t>(device(), output);
    for (std::uint32_t i = 0; i < count; ++i) ASSERT_EQ(results[i], i * frame + 100'007U) << i;
    EXPECT_EQ(results[count], 0U);
  }
}

// Each dispatch reads what other invocations of the previous one wrote; n turns add n.
TEST_F(ComputeTest, DispatchesSeeWhatEarlierOnesWrote) {
  constexpr std::uint32_t count = 1U << 16;
  std::vector<std::uint32_t> values(count);
  std::iota(values.begin(), values.end(), 0U);
  Buffer a = makeBuffer(device(), "a", values, storage);
  Buffer b = zeros(device(), "b", count);
  const Compute<shaders::Add> pipeline(device(), "turn around");

  CommandList list(device(), "chain");
  list.begin();
  constexpr std::uint32_t turns = 10;
  for (std::uint32_t i = 0; i < turns; ++i) {
    Buffer& from = i % 2 == 0 ? a : b;
    Buffer& to = i % 2 == 0 ? b : a;
    list.bind(pipeline, {.values = from, .results = to}, {.count = count});
    list.dispatch(count / 64);
  }
  list.submit();
  // Without a wait: the tracker orders across submissions too.
  const auto results = readAs<std::uint32_t>(device(), a);
  for (std::uint32_t i = 0; i < count; ++i) ASSERT_EQ(results[i], i + turns) << i;
}

TEST_F(ComputeTest, OneBufferMayStandAtTwoSlots) {
  Buffer input = makeBuffer(device(), "both", std::vector<std::uint32_t>(64, 3U), storage);
  Buffer output = zeros(device(), "output", 64);
  const Compute<shaders::Scale> pipeline(device(), "scale in place",
                                         {.groupSize = 64, .addend = 0});
  Buffer offset = makeBuffer(device(), "offset", std::vector<std::uint32_t>(4, 1U),
                             storage | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
  CommandList list(device(), "twice");
  list.begin();
  list.bind(pipeline, {.values = input, .results = input, .offset = offset},
            {.factor = 2, .count = 64});
  list.dispatch(1);
  list.bind(pipeline, {.values = input, .results = output, .offset = offset},
            {.factor = 2, .count = 64});
  list.dispatch(1);
  list.submit();
  list.wait();
  EXPECT_EQ(readAs<std::uint32_t>(device(), input), std::vector<std::uint32_t>(64, 7U));
  EXPECT_EQ(readAs<std::uint32_t>(device(), output), std::vector<std::uint32_t>(64, 15U));
}

// However many dispatches long work is cut into, each invocation runs once.
TEST_F(ComputeTest, LongWorkIsCutWithoutGapsOrOverlaps) {
  const Compute<shaders::Invocations> invocations(device(), "invocations");
  const Compute<shaders::Tiles> tiles(device(), "tiles");
  for (const std::uint32_t rounds : {1U, 1U << 12U, 1U << 20U, ~0U}) {
    constexpr std::uint32_t count = 100'001;
    Buffer runs = zeros(device(), "runs", count);
    GpuImage image(device(),
                   {.name = "runs",
                    .width = 250,
                    .height = 131,
                    .format = VK_FORMAT_R32_SFLOAT,
                    .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                             VK_IMAGE_USAGE_TRANSFER_DST_BIT});
    uploadImage(device(), image, bytesOf(std::vector<float>(std::size_t{250} * 131)));
    CommandList list(device(), "cut");
    list.begin();
    list.bind(invocations, {.runs = runs}, {.count = count});
    list.dispatchLinear(count, rounds);
    list.bind(tiles, {.runs = image});
    list.dispatchTiles(image, rounds);
    list.submit();
    EXPECT_EQ(readAs<std::uint32_t>(device(), runs), std::vector<std::uint32_t>(count, 1U));
    EXPECT_EQ(readAs<float>(device(), image, 4), std::vector<float>(std::size_t{250} * 131, 1.0F));
  }
}

TEST_F(ComputeTest, StorageImageIsWritten) {
  ImageOptions options;
  options.name = "written";
  options.width = 20;
  options.height = 12;
  options.mipLevels = 2;
  options.format = VK_FORMAT_R32G32B32A32_SFLOAT;
  options.usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  GpuImage image(device(), options);
  const Compute<shaders::FillImage> pipeline(device(), "fill image");
  CommandList list(device(), "fill");
  list.begin();
  list.bind(pipeline, {.result = image});
  list.dispatch(3, 2);
  list.bind(pipeline, {.result = {image, 1}});
  list.dispatch(2, 1);
  list.submit();
  for (std::uint32_t level = 0; level < 2; ++level) {
    const auto texels = readAs<float>(device(), image, 16, 0, level);
    const std::size_t width = 20U >> level;
    const std::size_t height = 12U >> level;
    ASSERT_EQ(texels.size(), 4 * width * height);
    for (std::size_t y = 0; y < height; ++y) {
      for (std::size_t x = 0; x < width; ++x) {
        EXPECT_EQ(texels[4 * (y * width + x)], static_cast<float>(x));
        EXPECT_EQ(texels[4 * (y * width + x) + 1], static_cast<float>(y));
      }
    }
  }
}

}  // namespace
}  // namespace opaline::gpu
