#include "cli/measures.h"

#include <gtest/gtest.h>

#include <limits>

namespace opaline::app {
namespace {

TEST(Measures, LengthsAreMillimetres) {
  EXPECT_EQ(lengthText(1.76e5), "176000 mm");
  EXPECT_EQ(lengthText(500), "500 mm");
  EXPECT_EQ(lengthText(35.35), "35.4 mm");
  EXPECT_EQ(lengthText(50), "50 mm");
  EXPECT_EQ(lengthText(0.05), "0.05 mm");
  EXPECT_EQ(lengthText(2.5e-6), "0.0000025 mm");
  EXPECT_EQ(lengthText(1234567), "1230000 mm");
  EXPECT_EQ(lengthText(0), "0 mm");
  EXPECT_EQ(lengthText(-1500), "-1500 mm");
  EXPECT_EQ(lengthText(999.7), "1000 mm");
  EXPECT_EQ(lengthText(86.6025, 4), "86.6 mm");
  EXPECT_EQ(lengthText(std::numeric_limits<double>::infinity()), "infinite");
}

TEST(Measures, NoExponentHoweverLargeOrSmall) {
  for (double mm = 1e-15; mm < 1e19; mm *= 7) {
    EXPECT_EQ(lengthText(mm).find_first_of("eE"), std::string::npos) << mm;
  }
}

// 569.1 mm have one decimal.
TEST(Measures, CoordinatesAreAsExactAsTheSizeOfTheirScene) {
  EXPECT_EQ(coordinateNumber(-131.04, 569.1), "-131");
  EXPECT_EQ(coordinateNumber(0.0000485, 569.1), "0");
  EXPECT_EQ(coordinateNumber(-0.04, 569.1), "0");
  EXPECT_EQ(coordinateNumber(1000000.12, 569.1), "1000000.1");
  EXPECT_EQ(coordinateNumber(0.12346, 0.5), "0.1235");
  EXPECT_EQ(coordinateNumber(123456, 1e6), "123000");
}

TEST(Measures, Stops) {
  EXPECT_EQ(stopsText(1.5), "+1.5 stops");
  EXPECT_EQ(stopsText(-0.25), "-0.25 stops");
  EXPECT_EQ(stopsText(1), "+1 stop");
  EXPECT_EQ(stopsText(-1), "-1 stop");
  EXPECT_EQ(stopsText(0), "0 stops");
  EXPECT_EQ(stopsText(-0.001), "0 stops");
}

}  // namespace
}  // namespace opaline::app
