#include "environment/sky_irradiance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include "bssrdf/fresnel.h"
#include "environment/lat_long.h"

namespace opaline {
namespace {

using std::numbers::pi;

using Direction = std::array<double, 3>;

Vec3 toVec3(const Direction& d) {
  return {static_cast<float>(d[0]), static_cast<float>(d[1]), static_cast<float>(d[2])};
}

Direction toDirection(const Vec3& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

double dot(const Direction& a, const Direction& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

std::vector<Vec3> someDirections(int count) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::vector<Vec3> directions = {{1, 0, 0},  {0, 1, 0},  {0, 0, 1},
                                  {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  while (static_cast<int>(directions.size()) < count) {
    const Direction d = {normal(random), normal(random), normal(random)};
    const double length = std::sqrt(dot(d, d));
    directions.push_back(toVec3({d[0] / length, d[1] / length, d[2] / length}));
  }
  return directions;
}

/// A latitude-longitude image with `radiance` at the pixels' centres: once in R, twice in G, thrice
/// in B.
Image imageOf(const std::function<double(const Direction&)>& radiance, int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double value =
          radiance(toDirection(latLongDirection((x + 0.5) / width, (y + 0.5) / height)));
      for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = static_cast<float>((c + 1) * value);
      image.pixel(x, y)[3] = 1;
    }
  }
  return image;
}

SkyParts partsOf(Image image) {
  Lighting lighting;
  lighting.environment = std::make_shared<const Image>(std::move(image));
  return partsOfSky(lighting);
}

TEST(LatLong, FollowsTheConvention) {
  const auto expectNear = [](const Vec3& a, const Vec3& b) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-6F);
  };
  expectNear(latLongDirection(0.3, 0.0), {0, 1, 0});
  expectNear(latLongDirection(0.5, 0.5), {0, 0, -1});
  expectNear(latLongDirection(0.75, 0.5), {1, 0, 0});
  expectNear(latLongDirection(0.25, 0.5), {-1, 0, 0});
  expectNear(latLongDirection(0.3, 1.0), {0, -1, 0});
}

TEST(LatLong, ThereAndBack) {
  for (const double u : {0.01, 0.3, 0.5, 0.77, 0.99}) {
    for (const double v : {0.001, 0.2, 0.5, 0.9, 0.999}) {
      const auto back = latLongCoordinates(latLongDirection(u, v));
      EXPECT_NEAR(back[0], u, 1e-5);
      EXPECT_NEAR(back[1], v, 1e-6);
    }
  }
}

TEST(SkyParts, ConserveLightAtAnySize) {
  for (const int height : {1, 2, 5, 48, 100}) {
    for (const int width : {1, 3, 96, 250}) {
      const auto radiance = [](const Direction& d) { return 1 + 0.5 * d[0] + 0.3 * d[1] * d[2]; };
      const Image image = imageOf(radiance, width, height);
      std::array<double, 3> expected{};
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
          for (std::size_t c = 0; c < 3; ++c)
            expected[c] += double{image.pixel(x, y)[c]} * 2 * pi / width *
                           (std::cos(pi * y / height) - std::cos(pi * (y + 1) / height));
      std::array<double, 3> found{};
      double whole = 0;
      for (const SkyParts::Part& part : partsOf(image).parts) {
        whole += double{part.solidAngle};
        for (std::size_t c = 0; c < 3; ++c)
          found[c] += double{part.solidAngle} * double{part.radiance[c]};
      }
      EXPECT_NEAR(whole, 4 * pi, 1e-5);
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(found[c] / expected[c], 1, 1e-5) << width << 'x' << height;
    }
  }
}

TEST(SkyParts, AnImageWithoutPixelsIsDark) {
  EXPECT_TRUE(partsOf(Image()).parts.empty());
  EXPECT_EQ(SkyIrradiance::entering(partsOf(Image()), 1.3).at({0, 1, 0}),
            (std::array<double, 3>{}));
}

TEST(SkyParts, AreFoundByDirection) {
  const SkyParts sky = partsOf(imageOf([](const Direction& d) { return 2 + d[1]; }, 192, 96));
  for (const Vec3& direction : someDirections(30))
    EXPECT_NEAR(sky.radianceAt(direction)[0], 2 + direction[1], 0.04);
}

// An even environment equals ambient light of that radiance, however few pixels it has.
TEST(SkyIrradiance, OfAnEvenSkyIsPiTimesTheMeanTransmittance) {
  Lighting ambient;
  ambient.ambient = {0.5F, 1.0F, 1.5F};
  for (const double eta : {1.01, 1.3, 1.5}) {
    const double expected = 0.5 * pi * bssrdf::meanTransmittance(eta);
    std::vector<SkyParts> skies{partsOfSky(ambient)};
    for (const int height : {1, 3, 64})
      skies.push_back(partsOf(imageOf([](const Direction&) { return 0.5; }, 2 * height, height)));
    for (const SkyParts& sky : skies)
      for (const Vec3& normal : someDirections(20)) {
        const auto irradiance = SkyIrradiance::entering(sky, eta).at(normal);
        for (std::size_t c = 0; c < 3; ++c)
          EXPECT_NEAR(irradiance[c] / expected, static_cast<double>(c + 1), 1e-5);
      }
  }
  EXPECT_NEAR(SkyIrradiance::arriving(partsOfSky(ambient)).at({0, 0, 1})[1], pi, 1e-6);
}

/// ∫ over the hemisphere of L F_t cos, about the normal: azimuth and μ = s².
double hemisphereIrradiance(const std::function<double(const Direction&)>& radiance,
                            const Vec3& normalFloat, double eta) {
  const Direction n = toDirection(normalFloat);
  const Direction other = std::abs(n[0]) < 0.5 ? Direction{1, 0, 0} : Direction{0, 1, 0};
  Direction t = {n[1] * other[2] - n[2] * other[1], n[2] * other[0] - n[0] * other[2],
                 n[0] * other[1] - n[1] * other[0]};
  const double length = std::sqrt(dot(t, t));
  for (double& value : t) value /= length;
  const Direction b = {n[1] * t[2] - n[2] * t[1], n[2] * t[0] - n[0] * t[2],
                       n[0] * t[1] - n[1] * t[0]};
  const int polarSteps = 600;
  const int azimuthSteps = 720;
  double sum = 0;
  for (int i = 0; i < polarSteps; ++i) {
    const double s = (i + 0.5) / polarSteps;
    const double mu = s * s;
    const double sine = std::sqrt(1 - mu * mu);
    double ring = 0;
    for (int j = 0; j < azimuthSteps; ++j) {
      const double azimuth = 2 * pi * j / azimuthSteps;
      Direction d{};
      for (std::size_t k = 0; k < 3; ++k) {
        d[k] = mu * n[k] + sine * (std::cos(azimuth) * t[k] + std::sin(azimuth) * b[k]);
      }
      ring += radiance(d);
    }
    sum += ring * (1 - bssrdf::fresnelReflectance(eta, mu)) * mu * 2 * s;
  }
  return sum * 2 * pi / (azimuthSteps * polarSteps);
}

// A slowly varying environment, and a bright window in a dark wall, which spherical harmonics of
// bands 0 to 2 miss by more than a tenth.
TEST(SkyIrradiance, IsTheIntegralOverTheHemisphere) {
  const auto smooth = [](const Direction& d) {
    const auto [x, y, z] = d;
    return 4 + x - 2 * y + 0.5 * z + x * y + 0.7 * y * z - x * z + z * z + 0.5 * (x * x - y * y);
  };
  const auto window = [](const Direction& d) {
    return d[0] > 0.7 && std::abs(d[1]) < 0.3 ? 20.0 : 0.5;
  };
  for (const double eta : {1.1, 1.3, 1.5}) {
    const SkyIrradiance ofSmooth = SkyIrradiance::entering(partsOf(imageOf(smooth, 512, 256)), eta);
    const SkyIrradiance ofWindow =
        SkyIrradiance::entering(partsOf(imageOf(window, 1024, 512)), eta);
    for (const Vec3& normal : someDirections(40)) {
      const double even = hemisphereIrradiance(smooth, normal, eta);
      EXPECT_NEAR(ofSmooth.at(normal)[0] / even, 1, 1e-3);
      const double uneven = hemisphereIrradiance(window, normal, eta);
      EXPECT_NEAR(ofWindow.at(normal)[0], uneven, 0.01 * uneven + 0.01);
    }
  }
}

}  // namespace
}  // namespace opaline
