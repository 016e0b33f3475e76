#include "cli/field_names.h"

#include <gtest/gtest.h>

namespace opaline::app {
namespace {

TEST(FieldNames, AreOptionsInTheProgramsSentences) {
  EXPECT_EQ(withOptionNames("x.toml: LoadOptions::morphTo is for one model"),
            "x.toml: --morph-to is for one model");
  EXPECT_EQ(withOptionNames("LoadOptions::diagonalMm or LoadOptions::diagonalMm"),
            "--diagonal-mm or --diagonal-mm");
  EXPECT_EQ(withOptionNames("nothing of the kind"), "nothing of the kind");
}

}  // namespace
}  // namespace opaline::app
