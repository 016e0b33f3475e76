#include "viewer/picture/label_layout.h"

#include <gtest/gtest.h>

namespace opaline::app::viewer {
namespace {

TEST(LabelLayout, StaysWhereNothingIsInTheWay) {
  LabelLayout layout({0, 0, 300, 200});
  layout.take({0, 150, 100, 50});
  const Box box = layout.place({120, 160, 60, 20});
  EXPECT_EQ(box.x, 120);
  EXPECT_EQ(box.y, 160);
}

TEST(LabelLayout, GoesAboveWhatIsThere) {
  LabelLayout layout({0, 0, 300, 200});
  layout.take({0, 150, 100, 50});
  const Box box = layout.place({20, 170, 60, 20});
  EXPECT_EQ(box.x, 20);
  EXPECT_EQ(box.y, 130);
}

TEST(LabelLayout, StaysWithinTheBounds) {
  LabelLayout layout({10, 10, 300, 200});
  const Box box = layout.place({-40, 400, 60, 20});
  EXPECT_EQ(box.x, 10);
  EXPECT_EQ(box.y, 190);
}

// What the two names of the divider do wherever it stands, beside the scale bar's.
TEST(LabelLayout, NoTwoMeetAsLongAsThereIsRoom) {
  for (float divider = 0; divider <= 300; divider += 7) {
    LabelLayout layout({0, 0, 300, 200});
    layout.take({0, 130, 180, 70});
    layout.take({0, 0, 300, 30});
    const Box left = layout.place({divider - 130, 178, 120, 20});
    const Box right = layout.place({divider + 10, 178, 60, 20});
    EXPECT_FALSE(left.meets(right));
    for (const Box& box : {left, right}) {
      EXPECT_FALSE(box.meets({0, 130, 180, 70}));
      EXPECT_FALSE(box.meets({0, 0, 300, 30}));
      EXPECT_GE(box.x, 0);
      EXPECT_LE(box.x + box.width, 300);
    }
  }
}

}  // namespace
}  // namespace opaline::app::viewer
