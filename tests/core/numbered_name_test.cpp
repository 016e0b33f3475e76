#include "opaline/numbered_name.h"

#include <gtest/gtest.h>

#include <optional>

namespace opaline {
namespace {

TEST(NumberedNameTest, NumberStandsInItsPlace) {
  const auto padded = NumberedName::parse("walk_%04d.ply");
  ASSERT_TRUE(padded);
  EXPECT_EQ(padded->with(7), "walk_0007.ply");
  EXPECT_EQ(padded->with(123456), "walk_123456.ply");
  EXPECT_EQ(padded->before(), "walk_");
  EXPECT_EQ(padded->after(), ".ply");
  EXPECT_EQ(NumberedName::parse("%d")->with(0), "0");
  EXPECT_EQ(NumberedName::parse("100%_%02d%.png")->with(7), "100%_07%.png");
}

TEST(NumberedNameTest, OneMarkAndOfThisKind) {
  for (const char* text :
       {"", "a", "%", "%0d", "%4d", "%00d", "%012d", "%s", "%i", "%04", "%0", "a%d%d", "%d_%04d"}) {
    EXPECT_FALSE(NumberedName::parse(text)) << text;
  }
}

TEST(NumberedNameTest, OnlyNamesItMakesHaveANumber) {
  const auto padded = NumberedName::parse("m_%03d.obj").value();
  EXPECT_EQ(padded.numberOf("m_012.obj"), 12);
  EXPECT_EQ(padded.numberOf("m_1234.obj"), 1234);
  const auto plain = NumberedName::parse("m_%d.obj").value();
  EXPECT_EQ(plain.numberOf("m_12.obj"), 12);
  for (const char* name : {"m_12.obj", "m_0012.obj", "m_-12.obj", "m_01x.obj", "m_.obj",
                           "m_012.ply", "n_012.obj", "m_99999999999.obj", ""}) {
    EXPECT_EQ(padded.numberOf(name), std::nullopt) << name;
  }
  EXPECT_EQ(plain.numberOf("m_012.obj"), std::nullopt);
  // The parts around the number must not overlap.
  EXPECT_EQ(NumberedName::parse("aa%da").value().numberOf("aa"), std::nullopt);
}

}  // namespace
}  // namespace opaline
