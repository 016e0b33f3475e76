// Suns extracted from environments, against closed forms and the whole environment.

#include "environment/suns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "environment/lat_long.h"
#include "opaline/error.h"

namespace opaline {
namespace {

using std::numbers::pi;

double dot(const Vec3& a, const Vec3& b) {
  return double{a[0]} * double{b[0]} + double{a[1]} * double{b[1]} + double{a[2]} * double{b[2]};
}

double solidAngle(const Image& image, int y) {
  return 2 * pi / image.width *
         (std::cos(pi * y / image.height) - std::cos(pi * (y + 1) / image.height));
}

Vec3 directionAt(const Image& image, int x, int y) {
  return latLongDirection((x + 0.5) / image.width, (y + 0.5) / image.height);
}

struct Disc {
  Vec3 towards{};
  double radius = 0;
  float radiance = 0;
};

/// A slow gradient with discs of even radiance in front of it.
std::shared_ptr<const Image> skyWith(const std::vector<Disc>& discs, int width = 720) {
  auto image = std::make_shared<Image>(width, width / 2);
  for (int y = 0; y < image->height; ++y)
    for (int x = 0; x < width; ++x) {
      const Vec3 towards = directionAt(*image, x, y);
      float radiance = 1 + 0.5F * towards[1];
      for (const Disc& disc : discs)
        if (dot(towards, disc.towards) > std::cos(disc.radius)) radiance = disc.radiance;
      float* rgba = image->pixel(x, y);
      rgba[0] = radiance;
      rgba[1] = 0.8F * radiance;
      rgba[2] = 0.5F * radiance;
      rgba[3] = 1;
    }
  return image;
}

/// Red irradiance of a surface with that normal, summed over the pixels.
double irradianceOf(const Image& image, const Vec3& normal) {
  double sum = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      sum += solidAngle(image, y) * std::max(dot(directionAt(image, x, y), normal), 0.0) *
             double{image.pixel(x, y)[0]};
  return sum;
}

double allLightOf(const Image& image, std::size_t channel) {
  double sum = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      sum += solidAngle(image, y) * double{image.pixel(x, y)[channel]};
  return sum;
}

Vec3 unit(float x, float y, float z) {
  const float length = std::sqrt(x * x + y * y + z * z);
  return {x / length, y / length, z / length};
}

TEST(Suns, HaveTheLightOfADiscAboveItsSurroundings) {
  const double radius = pi / 90;  // 2°
  const Disc disc{unit(1, 2, -0.5F), radius, 5000};
  const Suns suns = findSuns(skyWith({disc}));
  ASSERT_EQ(suns.lights.size(), 1U);
  const DirectionalLight& sun = suns.lights[0];
  EXPECT_GT(dot(sun.directionToLight, disc.towards), std::cos(pi / 720));  // half a pixel
  const double around = 1 + 0.5 * double{disc.towards[1]};
  const double solidAngleOfDisc = 2 * pi * (1 - std::cos(radius));
  EXPECT_NEAR(double{sun.irradiance[0]} / ((5000 - around) * solidAngleOfDisc), 1, 0.03);
  EXPECT_NEAR(double{sun.irradiance[2] / sun.irradiance[0]}, 0.5, 1e-4);
}

// Also at the seam and at a pole.
TEST(Suns, WithTheRestGiveTheEnvironmentsLight) {
  const double radius = pi / 120;
  for (const Vec3& towards : {unit(1, 1, -1), unit(0, 0.2F, 1), unit(0, 1, 0)}) {
    const std::shared_ptr<const Image> sky = skyWith({{towards, radius, 20'000}}, 360);
    const Suns suns = findSuns(sky);
    ASSERT_EQ(suns.lights.size(), 1U);
    const DirectionalLight& sun = suns.lights[0];
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR((allLightOf(*suns.rest, c) + double{sun.irradiance[c]}) / allLightOf(*sky, c), 1,
                  1e-5);
    for (int i = 0; i < 50; ++i) {
      const Vec3 normal = latticeDirection(i, 50);
      const double whole = irradianceOf(*sky, normal);
      const double apart =
          irradianceOf(*suns.rest, normal) +
          double{sun.irradiance[0]} * std::max(dot(sun.directionToLight, normal), 0.0);
      // Half of a disc on the horizon is visible; the error is at most sin r of its light.
      EXPECT_NEAR(apart, whole, std::sin(radius) * double{sun.irradiance[0]}) << i;
      if (std::abs(dot(sun.directionToLight, normal)) > 2 * radius) {
        EXPECT_NEAR(apart / whole, 1, radius * radius) << i;
      }
    }
  }
}

TEST(Suns, AreTheBrightestFour) {
  std::vector<Disc> discs;
  for (int i = 0; i < 6; ++i)
    discs.push_back({latticeDirection(i, 6), pi / 90, 4000.0F + 1000.0F * static_cast<float>(i)});
  const Suns suns = findSuns(skyWith(discs));
  ASSERT_EQ(suns.lights.size(), maxSuns);
  for (std::size_t i = 0; i < maxSuns; ++i)
    EXPECT_GT(dot(suns.lights[i].directionToLight, discs[5 - i].towards), 0.999) << i;
}

// Not suns: even light, a bright spot with hardly any light, and a large lamp.
TEST(Suns, AreNothingElse) {
  const std::vector<std::shared_ptr<const Image>> without{
      nullptr, skyWith({}), skyWith({{unit(1, 0, 0), pi / 300, 60}}),
      skyWith({{unit(1, 0, 0), pi / 12, 2000}})};
  for (const std::shared_ptr<const Image>& sky : without) {
    const Suns suns = findSuns(sky);
    EXPECT_TRUE(suns.lights.empty());
    EXPECT_EQ(suns.rest, sky);
  }
}

TEST(Suns, AreNotSoughtWhereTheEnvironmentIsUnsound) {
  const auto whole = std::make_shared<Image>(16, 8);
  EXPECT_EQ(complaintAboutEnvironment(*whole), "");
  for (const float value :
       {-1.0F, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    const auto unsound = std::make_shared<Image>(*whole);
    unsound->rgba[5] = value;
    EXPECT_THROW(findSuns(unsound), Error) << value;
  }
  for (const std::size_t values : {0U, 4U, 511U, 516U}) {
    const auto unsound = std::make_shared<Image>(*whole);
    unsound->rgba.resize(values);
    EXPECT_THROW(findSuns(unsound), Error) << values;
    EXPECT_NE(complaintAbout(Lighting{.environment = unsound}), "") << values;
  }
  EXPECT_THROW(findSuns(std::make_shared<Image>()), Error);
}

// Each of many bright pixels gives too little light, and the search must end soon.
TEST(Suns, AreNotManySparks) {
  auto sky = std::make_shared<Image>(2048, 1024);
  for (int y = 0; y < sky->height; y += 16)
    for (int x = 0; x < sky->width; x += 16) {
      float* rgba = sky->pixel(x, y);
      rgba[0] = rgba[1] = rgba[2] = 1000;
    }
  EXPECT_TRUE(findSuns(sky).lights.empty());
}

TEST(Suns, JoinTheOtherLights) {
  Lighting lighting;
  lighting.directional.resize(2);
  lighting.environment = skyWith({{unit(1, 0, 0), pi / 90, 5000}});
  const Suns suns = findSuns(lighting.environment);
  separate(suns, lighting);
  ASSERT_EQ(lighting.directional.size(), 3U);
  EXPECT_EQ(lighting.environment, suns.rest);
}

}  // namespace
}  // namespace opaline
