// Buffers read as texels.

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

#include "gpu/command_list.h"
#include "gpu/gpu_fixture.h"
#include "gpu/helpers.h"
#include "gpu/pipeline.h"
#include "gpu/transfer.h"
#include "shaders/texels.comp.h"

namespace opaline::gpu {
namespace {

using TexelTest = GpuTest;
using Texel = std::array<float, 4>;

constexpr VkBufferUsageFlags texelUsage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
constexpr VkBufferUsageFlags texels = VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT;

using TurnAround = Compute<shaders::Texels>;

TurnAround turnAround() {
  return {*sharedDevice().device, "turn texels around"};
}

void record(CommandList& list, const TurnAround& pipeline, Buffer& from, Buffer& to,
            std::uint32_t count) {
  list.bind(pipeline, {.values = from, .results = to}, {.count = count});
  list.dispatch((count + 63) / 64);
}

TEST_F(TexelTest, EveryTexelArrives) {
  constexpr std::uint32_t count = 100'001;
  std::vector<Texel> values;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto number = static_cast<float>(i);
    // Numbers, and bits made to look like numbers: one set bit makes any others a normal float.
    values.push_back({number, -number, std::bit_cast<float>(0x20000000U | i),
                      std::bit_cast<float>(0xA0000000U | i)});
  }
  Buffer from = makeBuffer(device(), "from", values, texelUsage | texels);
  Buffer to = makeBuffer(device(), "to", std::vector<Texel>(count + 1), texelUsage);
  const TurnAround pipeline = turnAround();
  CommandList list(device(), "texels");
  list.begin();
  record(list, pipeline, from, to, count);
  list.submit();
  const auto results = readAs<Texel>(device(), to);
  for (std::uint32_t i = 0; i < count; ++i) {
    const Texel& expected = values[count - 1 - i];
    ASSERT_EQ(results[i][0], expected[0] + 1) << i;
    for (std::size_t c = 1; c < 4; ++c)
      ASSERT_EQ(std::bit_cast<std::uint32_t>(results[i][c]),
                std::bit_cast<std::uint32_t>(expected[c]))
          << i;
  }
  EXPECT_EQ(results[count], Texel{});
}

// Each dispatch reads as texels what others of the previous one wrote as texelUsage, and the next
// dispatch overwrites it.
TEST_F(TexelTest, DispatchesReadWhatEarlierOnesWrote) {
  constexpr std::uint32_t count = 1U << 15U;
  std::vector<Texel> values;
  for (std::uint32_t i = 0; i < count; ++i)
    values.push_back({static_cast<float>(i), 1, 2, static_cast<float>(i)});
  Buffer a = makeBuffer(device(), "a", values, texelUsage | texels);
  Buffer b = makeBuffer(device(), "b", std::vector<Texel>(count), texelUsage | texels);
  const TurnAround pipeline = turnAround();
  CommandList list(device(), "chain");
  constexpr int turns = 10;
  list.begin();
  for (int i = 0; i < turns; ++i)
    record(list, pipeline, i % 2 == 0 ? a : b, i % 2 == 0 ? b : a, count);
  list.submit();
  const auto results = readAs<Texel>(device(), a);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto number = static_cast<float>(i);
    ASSERT_EQ(results[i], (Texel{number + turns, 1, 2, number})) << i;
  }
}

// The rest of a buffer after its last whole texel is not read.
TEST_F(TexelTest, ABufferMayEndWithinATexel) {
  Buffer from =
      makeBuffer(device(), "odd", std::vector<float>(4 * 64 + 3, 7.0F), texelUsage | texels);
  Buffer to = makeBuffer(device(), "to", std::vector<Texel>(64), texelUsage);
  const TurnAround pipeline = turnAround();
  CommandList list(device(), "texels");
  list.begin();
  record(list, pipeline, from, to, 64);
  list.submit();
  for (const Texel& texel : readAs<Texel>(device(), to)) EXPECT_EQ(texel, (Texel{8, 7, 7, 7}));
}

TEST_F(TexelTest, ABufferThatMovesKeepsItsTexels) {
  Buffer made =
      makeBuffer(device(), "moved", std::vector<Texel>(64, Texel{1, 2, 3, 4}), texelUsage | texels);
  Buffer from = std::move(made);
  Buffer other = makeBuffer(device(), "other", std::vector<Texel>(1), texelUsage | texels);
  other = std::move(from);
  Buffer to = makeBuffer(device(), "to", std::vector<Texel>(64), texelUsage);
  const TurnAround pipeline = turnAround();
  CommandList list(device(), "texels");
  list.begin();
  record(list, pipeline, other, to, 64);
  list.submit();
  for (const Texel& texel : readAs<Texel>(device(), to)) EXPECT_EQ(texel, (Texel{2, 2, 3, 4}));
}

}  // namespace
}  // namespace opaline::gpu
