// What files of every awkward family take grows with their size, and hardly faster. Memory and the
// number of allocations are the same on every machine, which times are not; opaline_growth_bench
// shows those.

#include "growth.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace opaline {
namespace {

class Growth : public testing::TestWithParam<bench::Family> {};

TEST_P(Growth, OfMemoryAndAllocationsIsNearlyLinear) {
  constexpr std::uint32_t small = 1024;
  constexpr std::uint32_t factor = 4;
  constexpr double mostOfExponent = 1.2;
  // Less than this says nothing: lists double their room as they grow.
  constexpr double noticeableBytes = 4e6;
  constexpr double noticeableAllocations = 10'000;
  const auto few = bench::costsOf(GetParam(), small);
  const auto many = bench::costsOf(GetParam(), factor * small);
  ASSERT_EQ(few.size(), many.size());
  for (std::size_t i = 0; i < few.size(); ++i) {
    const auto growth = [&](double bench::Cost::*cost) {
      return bench::exponent(std::array{few[i].*cost, many[i].*cost}, factor);
    };
    if (many[i].peakBytes > noticeableBytes) {
      EXPECT_LE(growth(&bench::Cost::peakBytes), mostOfExponent) << few[i].stage;
    }
    if (many[i].allocations > noticeableAllocations) {
      EXPECT_LE(growth(&bench::Cost::allocations), mostOfExponent) << few[i].stage;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Families, Growth, testing::ValuesIn(bench::families()),
                         [](const auto& family) { return std::string(family.param.name); });

}  // namespace
}  // namespace opaline
