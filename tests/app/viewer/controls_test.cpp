#include "viewer/panels/controls.h"

#include <gtest/gtest.h>

namespace opaline::app::viewer {
namespace {

TEST(WholeNumber, IsTheNearestToWhatWasTypedInItsRange) {
  const auto typed = [](const char* text) { return controls::wholeNumber(text, 16, 5000); };
  EXPECT_EQ(typed("64"), 64);
  EXPECT_EQ(typed("1e3"), 1000);
  EXPECT_EQ(typed("1919.6"), 1920);
  EXPECT_EQ(typed("3000000000"), 5000);
  EXPECT_EQ(typed("1e999"), 5000);
  EXPECT_EQ(typed("-1e999"), 16);
  EXPECT_EQ(typed("1e-999"), 16);
}

TEST(WholeNumber, IsNoneWhereNoNumberWasTyped) {
  for (const char* text : {"", "e", "12e", "1/2", "6-4", "nan", "."})
    EXPECT_FALSE(controls::wholeNumber(text, 16, 5000)) << text;
}

}  // namespace
}  // namespace opaline::app::viewer
