#include "cli/measures.h"

#include <gtest/gtest.h>

#include <limits>

namespace opaline::app {
namespace {

TEST(Measures, LengthsAsPeopleWriteThem) {
  EXPECT_EQ(lengthText(1.76e5), "176 m");
  EXPECT_EQ(lengthText(500), "500 mm");
  EXPECT_EQ(lengthText(35.35), "35.4 mm");
  EXPECT_EQ(lengthText(50), "50 mm");
  EXPECT_EQ(lengthText(0.5), "0.5 mm");
  EXPECT_EQ(lengthText(0.05), "50 \u00b5m");
  EXPECT_EQ(lengthText(2.5e-6), "2.5 nm");
  EXPECT_EQ(lengthText(1234567), "1.23 km");
  EXPECT_EQ(lengthText(0), "0 mm");
  EXPECT_EQ(lengthText(-1500), "-1.5 m");
}

TEST(Measures, RoundingMayChangeTheUnit) {
  EXPECT_EQ(lengthText(999.4), "999 mm");
  EXPECT_EQ(lengthText(999.7), "1 m");
  EXPECT_EQ(lengthText(0.09999), "0.1 mm");
}

TEST(Measures, NoExponentHoweverLargeOrSmall) {
  for (double mm = 1e-15; mm < 1e19; mm *= 7) {
    EXPECT_EQ(lengthText(mm).find_first_of("eE"), std::string::npos) << mm;
  }
  EXPECT_EQ(lengthText(std::numeric_limits<double>::infinity()), "endless");
}

TEST(Measures, ManyInOneUnit) {
  const LengthUnit unit = lengthUnitFor(176'000);
  EXPECT_EQ(lengthNumber(176'000, unit), "176");
  EXPECT_EQ(lengthNumber(1500, unit), "1.5");
  EXPECT_EQ(lengthNumber(86.6025, lengthUnitFor(86.6025), 4), "86.6");
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
