#include <gtest/gtest.h>

#include "gpu/command_list.h"
#include "gpu/gpu_fixture.h"
#include "gpu/helpers.h"
#include "gpu/transfer.h"
#include "opaline/error.h"

namespace opaline::gpu {
namespace {

using TimingTest = GpuTest;

TEST_F(TimingTest, PassesOfOneNameAreSummedInOrderOfAppearance) {
  Buffer buffer(device(), {"filled", 16U << 20, 0, Memory::Device});
  CommandList list(device(), "frame", 3);
  EXPECT_TRUE(list.timings().empty());
  for (int frame = 0; frame < 2; ++frame) {
    list.begin();
    for (const char* name : {"first", "second", "first"}) {
      list.beginPass(name);
      list.fill({buffer}, 1);
      list.endPass();
    }
    list.submit();
    list.wait();
    ASSERT_EQ(list.timings().size(), 2U);
    EXPECT_EQ(list.timings()[0].name, "first");
    EXPECT_EQ(list.timings()[1].name, "second");
    double sum = 0;
    for (const PassTiming& pass : list.timings()) {
      EXPECT_GT(pass.milliseconds, 0);
      sum += pass.milliseconds;
    }
    // Passes do not overlap, so they take no longer than the whole; a second is far beyond it.
    EXPECT_LE(sum, list.frameMilliseconds() * (1 + 1e-9));
    EXPECT_LT(list.frameMilliseconds(), 60'000);
  }
}

TEST_F(TimingTest, TimingsAreThoseOfTheLastFinishedSubmission) {
  CommandList list(device(), "frame", 2);
  list.begin();
  list.beginPass("one");
  list.endPass();
  list.submit();
  list.wait();
  list.begin();
  list.beginPass("two");
  list.endPass();
  ASSERT_EQ(list.timings().size(), 1U);
  EXPECT_EQ(list.timings()[0].name, "one");
  list.submit();
  list.wait();
  ASSERT_EQ(list.timings().size(), 1U);
  EXPECT_EQ(list.timings()[0].name, "two");
  list.begin();
  list.submit();
  list.wait();
  EXPECT_TRUE(list.timings().empty());
  EXPECT_EQ(list.frameMilliseconds(), 0);
}

// A large picture has thousands of bands, and the next frame may have fewer or more.
TEST_F(TimingTest, ManyPassesAreTimed) {
  constexpr int most = 150;
  Buffer buffer(device(), {"filled", 1U << 16, 0, Memory::Device});
  CommandList list(device(), "frame", most);
  for (const int passes : {most, 1, 64, 65, most}) {
    list.begin();
    for (int pass = 0; pass < passes; ++pass) {
      list.beginPass("band");
      list.fill({buffer}, 1);
      list.endPass();
    }
    list.submit();
    list.wait();
    ASSERT_EQ(list.timings().size(), 1U);
    EXPECT_GT(list.timings()[0].milliseconds, 0) << passes;
    EXPECT_LE(list.timings()[0].milliseconds, list.frameMilliseconds() * (1 + 1e-9)) << passes;
  }
}

TEST_F(TimingTest, MorePassesThanAskedForAreRefused) {
  CommandList list(device(), "frame", 1);
  list.begin();
  list.beginPass("one");
  list.endPass();
  EXPECT_THROW(list.beginPass("two"), Error);
}

}  // namespace
}  // namespace opaline::gpu
