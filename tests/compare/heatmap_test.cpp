#include "opaline/compare.h"

#include <gtest/gtest.h>

#include "compare/color_map.h"
#include "compare/digits.h"

namespace opaline::compare {
namespace {

Rgb8 at(const Image8& picture, int x, int y) {
  const auto pixel = static_cast<std::size_t>(4 * (y * picture.width + x));
  EXPECT_EQ(picture.rgba[pixel + 3], 255);
  return {picture.rgba[pixel], picture.rgba[pixel + 1], picture.rgba[pixel + 2]};
}

Plane plane(int width, int height, const std::vector<float>& values) {
  Plane result(width, height);
  result.values = values;
  return result;
}

TEST(Heatmap, RelativeErrorsAreThoseOfTheChannelsOverTheMeanOfAll) {
  Image a(2, 1);
  Image b(2, 1);
  a.rgba = {1, 2, 3, 1, 9, 9, 9, 1};
  b.rgba = {2, 2, 5, 1, 3, 3, 3, 1};
  // The mean of B over both is (9 + 9) / 6 = 3; |A - B| is 1, 0, 2 and 6, 6, 6.
  const Plane errors = relativeErrors(a, b, {1, 1});
  EXPECT_FLOAT_EQ(errors.values[0], 1.0F / 3);
  EXPECT_FLOAT_EQ(errors.values[1], 2.0F);
  // Over the first alone the mean is 3 again.
  EXPECT_FLOAT_EQ(relativeErrors(a, b, {1, 0}).values[0], 1.0F / 3);
  EXPECT_EQ(relativeErrors(a, b, {1, 0}).values[1], 0.0F);
}

TEST(Heatmap, TheScaleEndsAtARoundNumberAboveNearlyAll) {
  EXPECT_DOUBLE_EQ(heatmapTop(plane(1, 1, {0.1F}), {1}), 0.1);
  EXPECT_DOUBLE_EQ(heatmapTop(plane(1, 1, {0.11F}), {1}), 0.2);
  EXPECT_DOUBLE_EQ(heatmapTop(plane(1, 1, {0.3F}), {1}), 0.5);
  EXPECT_DOUBLE_EQ(heatmapTop(plane(1, 1, {7.0F}), {1}), 10);
  EXPECT_DOUBLE_EQ(heatmapTop(plane(1, 1, {0.0F}), {1}), 1e-5);
  EXPECT_DOUBLE_EQ(heatmapTop(plane(2, 1, {0.3F, 80.0F}), {1, 0}), 0.5);
  std::vector<float> values(200, 0.04F);
  values[3] = values[150] = 9.0F;  // 1 %
  EXPECT_DOUBLE_EQ(heatmapTop(plane(20, 10, values), Selection(200, 1)), 0.05);
  values[77] = 9.0F;
  EXPECT_DOUBLE_EQ(heatmapTop(plane(20, 10, values), Selection(200, 1)), 10);
}

// The coverage of a picture of 7x5 pixels of which every third column and row was rendered.
TEST(Heatmap, PixelsOnAGridFillItsSquares) {
  Plane errors(7, 5);
  Selection selection(35);
  const auto select = [&](std::size_t x, std::size_t y, float error) {
    selection[7 * y + x] = 1;
    errors.values[7 * y + x] = error;
  };
  select(3, 0, 0.1F);
  select(6, 0, 0.2F);
  select(3, 3, 0.2F);
  const Image8 picture = drawHeatmap(errors, selection, 0.2);
  const Rgb8 white{255, 255, 255};
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 7; ++x) {
      const Rgb8 wanted = x < 3             ? white
                          : y < 3 && x < 6  ? perceptualColor(0.5)
                          : y >= 3 && x > 5 ? white
                                            : perceptualColor(1);
      EXPECT_EQ(at(picture, x, y), wanted) << x << ", " << y;
    }
  }
  // The rest of a mask may lie on a grid by chance.
  selection.assign(35, 0);
  select(3, 0, 0.1F);
  select(6, 3, 0.1F);
  EXPECT_EQ(at(drawHeatmap(errors, selection, 0.2), 4, 1), white);
}

TEST(Heatmap, ShowsErrorsInPlaceAndTheScaleBeside) {
  const Plane errors = plane(2, 2, {0.0F, 0.1F, 0.2F, 5.0F});
  const Image8 picture = drawHeatmap(errors, {1, 1, 0, 1}, 0.2);
  EXPECT_GE(picture.height, 64);
  EXPECT_EQ(at(picture, 0, 0), perceptualColor(0));
  EXPECT_EQ(at(picture, 1, 0), perceptualColor(0.5));
  EXPECT_EQ(at(picture, 0, 1), (Rgb8{255, 255, 255}));
  EXPECT_EQ(at(picture, 1, 1), perceptualColor(1));
  // The bar begins 8 pixels beside the map and below the top, and ends as much above the bottom.
  EXPECT_EQ(at(picture, 2 + 8, 8), perceptualColor(1));
  EXPECT_EQ(at(picture, 2 + 8, picture.height - 9), perceptualColor(0));
}

TEST(Digits, AreDrawnWhereTheyShouldBeAndClipped) {
  constexpr Rgb8 ink{1, 2, 3};
  Image8 picture{14, 7, std::vector<std::uint8_t>(14 * 7 * 4, 255)};
  drawNumber(picture, 0, 0, 1, "1?7", ink);
  EXPECT_EQ(at(picture, 2, 0), ink);  // the top of the 1
  EXPECT_EQ(at(picture, 0, 0), (Rgb8{255, 255, 255}));
  EXPECT_EQ(at(picture, 8, 3), (Rgb8{255, 255, 255}));  // no glyph
  EXPECT_EQ(at(picture, 12, 0), ink);                   // the left end of the 7, cut off
  drawNumber(picture, -100, -100, 20, "88", ink);
  drawNumber(picture, 13, 6, 3, "8", ink);
}

}  // namespace
}  // namespace opaline::compare
