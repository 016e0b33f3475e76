#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "gpu/command_list.h"
#include "gpu/gpu_fixture.h"
#include "gpu/helpers.h"
#include "gpu/transfer.h"

namespace opaline::gpu {
namespace {

// Which submissions are recorded. The validation layer reports command buffers whose objects are
// gone, and any message fails the test.
class RecordingTest : public GpuTest {
 protected:
  template <typename Fill>
  std::uint32_t recordingsOf(CommandList& list, const Fill& fill) {
    list.begin();
    fill();
    list.submit();
    list.wait();
    return list.counts().recordings;
  }
  static std::vector<std::uint32_t> four(std::uint32_t value) {
    return std::vector<std::uint32_t>(4, value);
  }
};

TEST_F(RecordingTest, TheSameCommandsAreRecordedOnce) {
  Buffer buffer = makeBuffer(device(), "filled", four(0), 0);
  CommandList list(device(), "fill", 1);
  const auto filledWith = [&](std::uint32_t value) {
    return recordingsOf(list, [&] {
      list.beginPass("fill");
      list.fill({buffer}, value);
      list.endPass();
    });
  };
  // The first waits for the buffer's initialization, every other for the previous one.
  EXPECT_EQ(filledWith(1), 1U);
  EXPECT_EQ(list.counts().barriers, 1U);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(filledWith(1), 0U);
  EXPECT_EQ(filledWith(2), 1U);
  EXPECT_EQ(filledWith(2), 0U);
  EXPECT_EQ(list.timings().size(), 1U);
  EXPECT_EQ(readAs<std::uint32_t>(device(), buffer), four(2));
}

TEST_F(RecordingTest, WhatOneCommandWaitsForIsOneBarrier) {
  Buffer a = makeBuffer(device(), "a", four(0), 0);
  Buffer b = makeBuffer(device(), "b", four(0), 0);
  Buffer to = makeBuffer(device(), "to", four(0), 0);
  CommandList list(device(), "fill and copy", 0);
  recordingsOf(list, [&] {
    list.fill({a, b}, 5);
    list.use(b, Access::TransferRead);
    list.copyBuffer(a, to, 16);
    list.copyBuffer(b, to, 16);
  });
  // Before the fills; before the first copy; before the second, which writes where that wrote.
  EXPECT_EQ(list.counts().barriers, 3U);
  EXPECT_EQ(readAs<std::uint32_t>(device(), to), four(5));
}

TEST_F(RecordingTest, OtherBarriersAreRecorded) {
  Buffer from = makeBuffer(device(), "from", four(3), 0);
  Buffer to = makeBuffer(device(), "to", four(0), 0);
  CommandList list(device(), "copy", 0);
  CommandList other(device(), "other", 0);
  const auto copied = [&] { return recordingsOf(list, [&] { list.copyBuffer(from, to, 16); }); };
  copied();
  copied();
  EXPECT_EQ(copied(), 0U);
  recordingsOf(other, [&] { other.use(from, Access::Index); });
  recordingsOf(other, [&] { other.fill({from}, 4); });
  EXPECT_EQ(copied(), 1U);
  EXPECT_EQ(readAs<std::uint32_t>(device(), to), four(4));
}

// Drivers reuse the handle of a destroyed object for the next one.
TEST_F(RecordingTest, WhatTakesThePlaceOfAnotherIsRecorded) {
  Buffer kept = makeBuffer(device(), "kept", four(0), 0);
  CommandList list(device(), "copy", 0);
  for (std::uint32_t i = 0; i < 8; ++i) {
    Buffer passing = makeBuffer(device(), "passing", four(i), 0);
    EXPECT_EQ(recordingsOf(list, [&] { list.copyBuffer(passing, kept, 16); }), 1U);
    EXPECT_EQ(readAs<std::uint32_t>(device(), kept), four(i));
  }
}

TEST_F(RecordingTest, PartsAreRecordedApartAndBorrowedBuffersAlways) {
  Buffer lent = makeBuffer(device(), "lent", four(5), 0);
  Buffer buffer = makeBuffer(device(), "copy", four(0), 0);
  Buffer last = makeBuffer(device(), "copy of the copy", four(0), 0);
  CommandList list(device(), "copies", 2);
  const auto copied = [&](std::uint32_t value) {
    return recordingsOf(list, [&] {
      list.fill({last}, value);
      Buffer borrowed = Buffer::borrowed(lent.handle(), lent.bytes());
      list.beginPass("borrow");
      list.copyBuffer(borrowed, buffer, 16);
      list.endPass();
      list.cut();
      list.beginPass("copy");
      list.copyBuffer(buffer, last, 16);
      list.endPass();
    });
  };
  EXPECT_EQ(copied(1), 2U);
  copied(1);
  EXPECT_EQ(copied(1), 1U);
  EXPECT_EQ(copied(2), 1U);
  EXPECT_EQ(list.timings().size(), 2U);
  EXPECT_EQ(readAs<std::uint32_t>(device(), last), four(5));
}

}  // namespace
}  // namespace opaline::gpu
