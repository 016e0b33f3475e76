#include "opaline/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "opaline/error.h"

namespace opaline::compare {
namespace {

/// One row of red values from left to right; green is twice, blue four times as large.
Image row(const std::vector<float>& reds) {
  Image image(static_cast<int>(reds.size()), 1);
  for (std::size_t i = 0; i < reds.size(); ++i) {
    float* const pixel = image.pixel(static_cast<int>(i), 0);
    pixel[0] = reds[i];
    pixel[1] = 2 * reds[i];
    pixel[2] = 4 * reds[i];
    pixel[3] = 1;
  }
  return image;
}

Image filled(int width, int height, float value) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.rgba.size(); ++i) image.rgba[i] = i % 4 == 3 ? 1.0F : value;
  return image;
}

TEST(Figures, RefusesWhatCannotBeCompared) {
  const Image a = row({1, 2, 3});
  const Image longer = row({1, 2, 3, 4});
  const Selection all{1, 1, 1};
  EXPECT_THROW(commonPixels(a, longer), UsageError);
  EXPECT_THROW(figuresOver(a, longer, all), UsageError);
  EXPECT_THROW(figuresOver(a, a, {1, 1}), UsageError);
  EXPECT_THROW(blockFiguresOver(a, a, all, 0), UsageError);
  EXPECT_THROW(relativeErrors(a, longer, all), UsageError);
  for (const float bad : {NAN, INFINITY}) {
    EXPECT_THROW(figuresOver(row({1, bad, 3}), a, all), UsageError);
    EXPECT_THROW(blockFiguresOver(a, row({1, 2, bad}), all, 2), UsageError);
    EXPECT_TRUE(figuresOver(row({1, bad, 3}), a, {1, 0, 1}).has_value()) << "where it counts";
  }
  EXPECT_THROW(flipMap(Image8(2, 1), Image8(1, 2)), UsageError);
  EXPECT_THROW(drawHeatmap(Plane(3, 1), {1, 1}, 0.2), UsageError);
  EXPECT_THROW(flipMap(Image8(2, 1), Image8(2, 1), NAN), UsageError);
}

TEST(Figures, EqualImagesDifferByNothing) {
  const Image a = row({1, 2, 3, 0.1F});
  const Figures figures = figuresOver(a, a, commonPixels(a, a)).value();
  EXPECT_EQ(figures.coveredPixels, 4U);
  EXPECT_EQ(figures.all.relRmse, 0);
  EXPECT_EQ(figures.all.relBias, 0);
  EXPECT_EQ(figures.all.p95Rel, 0);
  EXPECT_EQ(figures.all.maxAbs, 0);
  EXPECT_TRUE(std::isinf(figures.all.psnrDb));
}

// Red has errors 1, 0, 0, 3 with B = 1, 2, 3, 2: RMSE = √(10/4), mean of B = 2. The sorted errors
// are 0, 0, 1, 3, and the 95th percentile is at rank 0.95·3 = 2.85, thus 1 + 0.85·2. Green and blue
// only differ by a factor, so relative figures are equal, as is PSNR with a scaled peak.
TEST(Figures, KnownDifferences) {
  const Image b = row({1, 2, 3, 2});
  const Image a = row({2, 2, 3, 5});
  const Figures figures = figuresOver(a, b, commonPixels(a, b)).value();
  const double factors[] = {1, 2, 4};
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(figures.channels[c].relRmse, std::sqrt(2.5) / 2, 1e-12);
    EXPECT_NEAR(figures.channels[c].relBias, (1.0 + 3) / 4 / 2, 1e-12);
    EXPECT_NEAR(figures.channels[c].p95Rel, 2.7 / 2, 1e-12);
    EXPECT_DOUBLE_EQ(figures.channels[c].maxAbs, 3 * factors[c]);
    // The largest value of B in any channel is 12.
    EXPECT_NEAR(figures.channels[c].psnrDb, 10 * std::log10(144 / (2.5 * factors[c] * factors[c])),
                1e-12);
  }
  // All twelve values: squares 10·(1+4+16), sum of B 8·(1+2+4); ranks … 3, 4, 6, 12, and 0.95·11
  // = 10.45.
  EXPECT_NEAR(figures.all.relRmse, std::sqrt(210.0 / 12) / (56.0 / 12), 1e-12);
  EXPECT_NEAR(figures.all.relBias, 4.0 * 7 / 12 / (56.0 / 12), 1e-12);
  EXPECT_NEAR(figuresOver(b, a, commonPixels(a, b))->all.relBias, -4.0 / 12, 1e-12);
  EXPECT_NEAR(figures.all.p95Rel, (6 + 0.45 * 6) / (56.0 / 12), 1e-12);
  EXPECT_DOUBLE_EQ(figures.all.maxAbs, 12);
  EXPECT_NEAR(figures.all.psnrDb, 10 * std::log10(144 / 17.5), 1e-12);
  EXPECT_NEAR(figuresOver(a, b, commonPixels(a, b), 1.0)->all.psnrDb, -10 * std::log10(17.5),
              1e-12);
}

TEST(Figures, OnlyWhatBothCoverCounts) {
  Image a = row({1, 100, 3, 4});
  Image b = row({2, 2, 100, 4});
  a.pixel(2, 0)[3] = 0;
  b.pixel(1, 0)[3] = 0;
  const Figures figures = figuresOver(a, b, commonPixels(a, b)).value();
  EXPECT_EQ(figures.coveredPixels, 2U);
  EXPECT_NEAR(figures.channels[0].relRmse, std::sqrt(0.5) / 3, 1e-12);

  Image nothing = row({1, 1, 1, 1});
  for (int x = 0; x < 4; ++x) nothing.pixel(x, 0)[3] = 0;
  EXPECT_FALSE(figuresOver(nothing, b, commonPixels(nothing, b)).has_value());
  EXPECT_FALSE(blockFiguresOver(nothing, b, commonPixels(nothing, b), 2).has_value());
}

TEST(Figures, OnePixelIsEnough) {
  const Image a = row({3});
  const Image b = row({2});
  const Figures figures = figuresOver(a, b, commonPixels(a, b)).value();
  EXPECT_DOUBLE_EQ(figures.channels[0].relRmse, 0.5);
  EXPECT_DOUBLE_EQ(figures.channels[0].p95Rel, 0.5);
}

TEST(Figures, OverABlackReferenceErrorsAreInfiniteAndNeverNaN) {
  const Image black = row({0, 0});
  const Image light = row({0, 1});
  const ErrorFigures same = figuresOver(black, black, commonPixels(black, black))->all;
  EXPECT_EQ(same.relRmse, 0);
  EXPECT_EQ(same.p95Rel, 0);
  const ErrorFigures different = figuresOver(light, black, commonPixels(light, black))->all;
  EXPECT_TRUE(std::isinf(different.relRmse));
  EXPECT_FALSE(std::isnan(different.psnrDb));
}

TEST(Figures, TheMeanOfSignedValuesIsThatOfTheirSize) {
  const Image b = row({1, -1});
  const Image a = row({2, -1});
  EXPECT_NEAR(figuresOver(a, b, commonPixels(a, b))->channels[0].relRmse, std::sqrt(0.5), 1e-12);
}

TEST(Figures, TheMeanOverWhatIsCoveredLeavesTheRestOut) {
  Image image = row({1, 2, 6});
  EXPECT_EQ(meanOverCovered(image), 3);
  image.pixel(2, 0)[3] = 0;
  EXPECT_EQ(meanOverCovered(image), 1.5);
  EXPECT_EQ(meanOverCovered(Image(2, 2)), 0);
}

TEST(Figures, AMaskIsWhereItsLargestChannelIsAboveOneHalf) {
  Image mask = row({0.125F, 0.1251F, 0.5F, 1});
  mask.pixel(3, 0)[3] = 0;
  EXPECT_EQ(maskedPixels(mask), (Selection{0, 1, 1, 0}));
}

// 4×4 pixels in blocks of 2×2; B is 1 where covered. In the upper left block the errors +4 and -4
// cancel. In the upper right one of four pixels is off by 2. The lower left has a single covered
// pixel, which is off by 1. The lower right has none. Block errors are 0, 2/4, 1/4, none.
TEST(Blocks, AverageWhatCancels) {
  Image b = filled(4, 4, 1);
  Image a = filled(4, 4, 1);
  const auto set = [&](int x, int y, float value) { std::fill_n(a.pixel(x, y), 3, value); };
  const auto uncover = [&](int x, int y) { a.pixel(x, y)[3] = 0; };
  set(0, 0, 5);
  set(1, 1, -3);
  set(2, 1, 3);
  set(0, 2, 2);
  for (const auto& [x, y] : {std::pair{1, 2}, {0, 3}, {1, 3}, {2, 2}, {3, 2}, {2, 3}, {3, 3}}) {
    uncover(x, y);
    set(x, y, 1000);
  }
  const BlockFigures figures = blockFiguresOver(a, b, commonPixels(a, b), 2).value();
  EXPECT_EQ(figures.blocks, 4U);
  EXPECT_EQ(figures.coveredBlocks, 3U);
  const double squares = 0.25 + 0.0625;
  EXPECT_NEAR(figures.relRmse, std::sqrt(squares / 4), 1e-12);
  EXPECT_NEAR(figures.coveredRelRmse, std::sqrt(squares / 3), 1e-12);
  for (const double channel : figures.channelRelRmse) {
    EXPECT_NEAR(channel, std::sqrt(squares / 4), 1e-12);
  }
  const Plane errors = relativeBlockErrors(a, b, commonPixels(a, b), 2);
  EXPECT_NEAR(errors.values[0], 0, 1e-6);
  EXPECT_NEAR(errors.values[3], 0.5, 1e-6);
  EXPECT_NEAR(errors.values[8], 0.25, 1e-6);
  EXPECT_EQ(errors.values[15], 0.0F);
}

TEST(Blocks, OfOnePixelGiveTheFiguresOfPixels) {
  const Image b = row({1, 2, 3, 2, 7});
  const Image a = row({2, 2, 3, 5, 6});
  const Selection all = commonPixels(a, b);
  const BlockFigures blocks = blockFiguresOver(a, b, all, 1).value();
  const Figures pixels = figuresOver(a, b, all).value();
  EXPECT_NEAR(blocks.relRmse, pixels.all.relRmse, 1e-12);
  EXPECT_NEAR(blocks.channelRelRmse[1], pixels.channels[1].relRmse, 1e-12);
}

TEST(Blocks, ReachBeyondTheBorderWithTheirWholeArea) {
  const Image b = filled(3, 1, 1);
  const Image a = filled(3, 1, 2);
  // Blocks of 2×2 have 2 pixels and 1 pixel that are off by 1: 2/4 and 1/4.
  const BlockFigures figures = blockFiguresOver(a, b, commonPixels(a, b), 2).value();
  EXPECT_EQ(figures.blocks, 2U);
  EXPECT_NEAR(figures.relRmse, std::sqrt((0.25 + 0.0625) / 2), 1e-12);
  EXPECT_EQ(blockFiguresOver(a, b, commonPixels(a, b), 16384)->blocks, 1U);
}

}  // namespace
}  // namespace opaline::compare
