#include "film/picture_stamp.h"

#include <gtest/gtest.h>

#include <string>

namespace opaline::app {
namespace {

constexpr const char* oldStamp =
    R"({"program":"opaline 0.1.0","scene":"bear","seconds":0.1,"digest":"0123456789abcdef"})";

TEST(PictureStamp, OldOnesAreComparedByWhatTheySay) {
  const std::string later =
      R"({"program":"opaline 0.1.0","scene":"bear","seconds":0.2,"digest":"fedcba9876543210"})";
  EXPECT_TRUE(isSameRow(oldStamp, later));
  const std::string newer =
      R"({"program":"opaline 0.1.0","scene":"bear","seconds":0.2,"digest":"1","fps":30,"row":"2"})";
  EXPECT_TRUE(isSameRow(oldStamp, newer));
  EXPECT_TRUE(isSameRow(newer, oldStamp));
  const std::string other =
      R"({"program":"opaline 0.1.0","scene":"bunny","seconds":0.2,"digest":"1"})";
  EXPECT_FALSE(isSameRow(oldStamp, other));
  EXPECT_FALSE(isSameRow(newer, other));
  EXPECT_FALSE(isSameRow(oldStamp, ""));
  EXPECT_TRUE(isSameRow("", ""));
  EXPECT_EQ(secondsOf(oldStamp), 0.1);
}

TEST(PictureStamp, ARowIsOfAllButTheTime) {
  const std::string a = R"({"scene":"bear","seconds":0.1,"digest":"1","fps":30,"row":"2"})";
  EXPECT_TRUE(isSameRow(a, R"({"scene":"bear","seconds":0.2,"digest":"3","fps":30,"row":"2"})"));
  EXPECT_FALSE(isSameRow(a, R"({"scene":"bear","seconds":0.1,"digest":"1","fps":30,"row":"4"})"));
}

}  // namespace
}  // namespace opaline::app
