#include "opaline/compare.h"
#include "opaline/error.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

#include "compare/cie_color.h"

namespace opaline::compare {
namespace {

using Pixel = std::array<int, 3>;

template <typename Function>
Image8 drawn(int width, int height, Function pixelAt) {
  Image8 picture{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (const int channel : Pixel(pixelAt(x, y))) {
        picture.rgba.push_back(static_cast<std::uint8_t>(channel));
      }
      picture.rgba.push_back(255);
    }
  }
  return picture;
}

Image8 plain(const Pixel& color) {
  return drawn(5, 3, [&](int, int) { return color; });
}

double mean(const Plane& plane) {
  return std::accumulate(plane.values.begin(), plane.values.end(), 0.0) /
         static_cast<double>(plane.values.size());
}

double plainFlip(const Pixel& a, const Pixel& b) {
  const Plane map = flipMap(plain(a), plain(b));
  const auto [least, most] = std::minmax_element(map.values.begin(), map.values.end());
  EXPECT_NEAR(*least, *most, 1e-5);
  return mean(map);
}

Image8 patternA() {
  return drawn(24, 18, [](int x, int y) {
    return Pixel{(37 * x + 11 * y) % 256, (x * x + 3 * y) % 256, (200 - 5 * x + 2 * y) % 256};
  });
}

Image8 patternB() {
  return drawn(24, 18, [](int x, int y) {
    return Pixel{(37 * x + 11 * y + (x > 12 ? 40 : 0)) % 256, (x * x + 3 * y) % 256,
                 (200 - 5 * x + 2 * y + y * y) % 256};
  });
}

TEST(Flip, TheUsualViewerIsThatOfThePaper) {
  // 0.7 m in front of a screen of 3840 pixels on 0.7 m; the paper says 67.
  EXPECT_NEAR(usualPixelsPerDegree, 0.7 * 3840 / 0.7 * std::acos(-1.0) / 180, 1e-6);
}

TEST(Flip, EqualPicturesDifferByNothing) {
  for (const float value : flipMap(patternA(), patternA()).values) EXPECT_EQ(value, 0.0F);
}

TEST(Flip, IsSymmetric) {
  EXPECT_EQ(flipMap(patternA(), patternB()).values, flipMap(patternB(), patternA()).values);
}

// Without variation in space only the color term remains, which can be computed by hand. L* is 100
// for white and 0 for black, so their HyAB distance is 100, which to the power 0.7 is 25.119. The
// largest distance is between green, Hunt-adjusted L*a*b* (87.735, -75.61, 72.98), and blue
// (32.297, 25.57, -34.83): (55.44 + √(101.18² + 107.81²))^0.7 = 203.29^0.7 = 41.277, 0.4 of which
// is 16.511.
TEST(Flip, PlainColorsByHand) {
  EXPECT_NEAR(plainFlip({0, 0, 0}, {255, 255, 255}), 0.95 + 0.05 * (25.1189 - 16.511) / 24.766,
              1e-4);
  EXPECT_NEAR(plainFlip({0, 255, 0}, {0, 0, 255}), 1, 1e-5);
  // L* of the grey levels 100 and 110 is 42.375 and 46.426: (4.051^0.7) · 0.95 / 16.511.
  EXPECT_NEAR(plainFlip({100, 100, 100}, {110, 110, 110}), 0.15346, 1e-4);
}

TEST(Flip, GrowsWithTheDifferenceOfLightnessAndHue) {
  double last = 0;
  for (int level = 101; level < 256; level += 11) {
    const double flip = plainFlip({100, 100, 100}, {level, level, level});
    EXPECT_GT(flip, last);
    last = flip;
  }
  last = 0;
  for (int turned = 10; turned <= 150; turned += 20) {
    const double flip = plainFlip({200, 50, 50}, {200 - turned, 50 + turned, 50});
    EXPECT_GT(flip, last);
    last = flip;
  }
  EXPECT_LE(last, 1);
}

// The expected values are from a separate program, which filters with two-dimensional kernels in
// double precision, as the paper does.
TEST(Flip, PatternsAgreeWithTwoDimensionalKernels) {
  const Plane usual = flipMap(patternA(), patternB());
  EXPECT_NEAR(mean(usual), 0.364048416, 2e-5);
  EXPECT_NEAR(usual.values[0], 0.036483134, 2e-5);
  EXPECT_NEAR(usual.values[9 * 24 + 12], 0.384177290, 2e-5);
  EXPECT_NEAR(usual.values[17 * 24 + 23], 0.466010962, 2e-5);
  const Plane far = flipMap(patternA(), patternB(), 20);
  EXPECT_NEAR(mean(far), 0.483593892, 2e-5);
  EXPECT_NEAR(far.values[5 * 24 + 13], 0.395440111, 2e-5);
}

TEST(Flip, ALineOnBlackIsAnEdgeAsWell) {
  const Image8 black = drawn(24, 18, [](int, int) { return Pixel{}; });
  const Image8 line = drawn(24, 18, [](int x, int) {
    return x == 12 ? Pixel{255, 255, 255} : Pixel{};
  });
  const Plane map = flipMap(line, black);
  EXPECT_NEAR(mean(map), 0.220100729, 2e-5);
  EXPECT_NEAR(map.values[9 * 24 + 12], 0.975738400, 2e-5);
  EXPECT_NEAR(map.values[9 * 24 + 9], 0.357563713, 2e-5);
  // Nothing varies between rows, so all rows are equal.
  for (int y = 0; y < 18; ++y) {
    EXPECT_EQ(map.values[static_cast<std::size_t>(y) * 24 + 12], map.values[12]);
  }
}

TEST(Flip, OnePixelIsAPictureToo) {
  const Image8 black{1, 1, {0, 0, 0, 255}};
  const Image8 white{1, 1, {255, 255, 255, 255}};
  EXPECT_NEAR(mean(flipMap(black, white, 1000)), 0.967379, 1e-5);
  EXPECT_NEAR(mean(flipMap(black, white, 1)), 0.967379, 1e-5);
}

TEST(Flip, NeedsFourValuesAPixel) {
  const Image8 torn{400, 400, {0, 0, 0, 255}};
  EXPECT_THROW(flipMap(torn, torn, 67), UsageError);
}

}  // namespace
}  // namespace opaline::compare
