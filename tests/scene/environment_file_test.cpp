#include "scene/environment_file.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace opaline {
namespace {

TEST(EnvironmentFile, TurnsWholeColumnsExactly) {
  Image image(4, 1);
  for (int x = 0; x < 4; ++x) image.pixel(x, 0)[0] = static_cast<float>(x);
  // The columns face +z/-x, -x/-z, -z/+x and +x/+z; a quarter turn takes -z to -x.
  const Image quarter = turned(image, 90);
  for (int x = 0; x < 4; ++x) EXPECT_EQ(quarter.pixel(x, 0)[0], static_cast<float>((x + 1) % 4));
  for (const double whole : {0.0, 360.0, -720.0}) {
    EXPECT_EQ(turned(image, whole).rgba, image.rgba);
  }
  EXPECT_EQ(turned(image, -270).rgba, quarter.rgba);
  // Turned by half a column, each pixel is the mean of neighbours.
  EXPECT_FLOAT_EQ(turned(image, 45).pixel(3, 0)[0], 1.5F);
}

// After the turn, light from d comes from R d, where R rotates about +y by the right-hand rule.
TEST(EnvironmentFile, TurnsAboutTheVerticalAxis) {
  constexpr int width = 256;
  constexpr int height = 8;
  using Direction = std::array<double, 3>;
  const auto direction = [](int x, int y) -> Direction {
    const double phi = 2 * std::numbers::pi * ((x + 0.5) / width - 0.5);
    const double theta = std::numbers::pi * (y + 0.5) / height;
    return {std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)};
  };
  const auto radiance = [](const Direction& d) {
    return 2 + d[0] + 0.5 * d[2] + 0.3 * d[0] * d[1] - 0.2 * d[1] * d[2];
  };
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.pixel(x, y)[1] = static_cast<float>(radiance(direction(x, y)));
    }
  }
  constexpr double degrees = 37.3;
  const double angle = degrees * std::numbers::pi / 180;
  const Image turned = opaline::turned(image, degrees);
  for (int y = 0; y < height; ++y) {
    double before = 0;
    double after = 0;
    for (int x = 0; x < width; ++x) {
      const Direction d = direction(x, y);
      const Direction from{std::cos(angle) * d[0] - std::sin(angle) * d[2], d[1],
                           std::sin(angle) * d[0] + std::cos(angle) * d[2]};
      EXPECT_NEAR(turned.pixel(x, y)[1], radiance(from), 3e-4);
      before += double{image.pixel(x, y)[1]};
      after += double{turned.pixel(x, y)[1]};
    }
    EXPECT_NEAR(after, before, 1e-5 * before);
  }
}

}  // namespace
}  // namespace opaline
