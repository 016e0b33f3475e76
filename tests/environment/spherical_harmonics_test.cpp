#include "environment/spherical_harmonics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "bssrdf/fresnel.h"
#include "bssrdf/quadrature.h"

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

/// Quadrature over the sphere that is exact for polynomials up to degree 9.
double integrateSphere(const std::function<double(const Direction&)>& function) {
  const int steps = 16;
  return test::integrate(
      [&](double z) {
        const double radius = std::sqrt(1 - z * z);
        double ring = 0;
        for (int j = 0; j < steps; ++j) {
          const double azimuth = 2 * pi * j / steps;
          ring += function({radius * std::cos(azimuth), radius * std::sin(azimuth), z});
        }
        return ring * 2 * pi / steps;
      },
      -1, 1, 1);
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

/// A latitude-longitude image whose pixels are `radiance` at their centres, the same in R, twice in
/// G, thrice in B.
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

TEST(SphericalHarmonics, AreOrthonormal) {
  for (std::size_t i = 0; i < 9; ++i) {
    for (std::size_t j = i; j < 9; ++j) {
      const double product = integrateSphere([&](const Direction& d) {
        const auto basis = sphericalHarmonics(toVec3(d));
        return basis[i] * basis[j];
      });
      EXPECT_NEAR(product, i == j ? 1 : 0, 1e-6) << i << ' ' << j;
    }
  }
}

// Ramamoorthi and Hanrahan 2001, Eq. 3, with its constants.
TEST(SphericalHarmonics, AreThePublishedPolynomials) {
  for (const Vec3& v : someDirections(20)) {
    const auto [x, y, z] = toDirection(v);
    const std::array<double, 9> expected = {0.282095,
                                            0.488603 * y,
                                            0.488603 * z,
                                            0.488603 * x,
                                            1.092548 * x * y,
                                            1.092548 * y * z,
                                            0.315392 * (3 * z * z - 1),
                                            1.092548 * x * z,
                                            0.546274 * (x * x - y * y)};
    const auto basis = sphericalHarmonics(v);
    for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(basis[i], expected[i], 2e-6) << i;
  }
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

TEST(Projection, UniformIsExactAtAnySize) {
  for (const int height : {1, 2, 3, 64}) {
    for (const int width : {1, 2, 5, 128}) {
      const auto coefficients =
          projectEnvironment(imageOf([](const Direction&) { return 0.5; }, width, height));
      const auto expected = projectUniform({0.5F, 1.0F, 1.5F});
      for (std::size_t i = 0; i < 9; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
          EXPECT_NEAR(coefficients[i][c], expected[i][c], 1e-12) << width << 'x' << height;
        }
      }
    }
  }
  // √(4π) times the radiance.
  EXPECT_NEAR(projectUniform({1, 2, 3})[0][1], 2 * 3.5449077018110318, 1e-14);
}

TEST(Projection, AnImageWithoutPixelsIsDark) {
  for (const auto& coefficient : projectEnvironment(Image())) {
    for (const double value : coefficient) EXPECT_EQ(value, 0.0);
  }
}

// Known by hand: ∫ x² dω = 4π/3, ∫ x²y² dω = 4π/15, ∫ x⁴ dω = 4π/5, hence for
// L = 3 + x - 2y + 0.5z + xy + yz - xz + z² + (x² - y²)/2 the coefficients below.
TEST(Projection, PolynomialsHaveKnownCoefficients) {
  const auto radiance = [](const Direction& d) {
    const auto [x, y, z] = d;
    return 3 + x - 2 * y + 0.5 * z + x * y + y * z - x * z + z * z + 0.5 * (x * x - y * y);
  };
  const double first = std::sqrt(4 * pi / 3);
  const double second = std::sqrt(4 * pi / 15);
  const std::array<double, 9> expected = {
      std::sqrt(4 * pi) * (3 + 1.0 / 3), -2 * first, 0.5 * first, first, second, second,
      2.0 / 3 * std::sqrt(4 * pi / 5),   -second,    second};
  const auto coefficients = projectEnvironment(imageOf(radiance, 512, 256));
  for (std::size_t i = 0; i < 9; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(coefficients[i][c], static_cast<double>(c + 1) * expected[i], 1e-3)
          << i << ' ' << c;
    }
  }
}

// One bright pixel is a solid angle of constant radiance: compared with quadrature over it.
TEST(Projection, OnePixelIsExact) {
  const int width = 8;
  const int height = 4;
  Image image(width, height);
  image.pixel(5, 1)[0] = 2;
  image.pixel(5, 1)[1] = 70000;
  const auto coefficients = projectEnvironment(image);
  const int steps = 200;
  std::array<double, 9> expected{};
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      const double u = (5 + (i + 0.5) / steps) / width;
      const double v = (1 + (j + 0.5) / steps) / height;
      const double area = 2 * pi * pi * std::sin(pi * v) / (width * height * steps * steps);
      const auto basis = sphericalHarmonics(latLongDirection(u, v));
      for (std::size_t k = 0; k < 9; ++k) expected[k] += basis[k] * area;
    }
  }
  for (std::size_t k = 0; k < 9; ++k) {
    EXPECT_NEAR(coefficients[k][0], 2 * expected[k], 1e-5) << k;
    EXPECT_NEAR(coefficients[k][1], 70000 * expected[k], 0.35) << k;
    EXPECT_EQ(coefficients[k][2], 0.0);
  }
}

TEST(Kernel, IsTheClampedCosineWithoutRefraction) {
  // Ramamoorthi and Hanrahan 2001, Eq. 8: π, 2π/3, π/4.
  const auto kernel = irradianceKernel(1.0);
  EXPECT_NEAR(kernel[0], pi, 1e-9);
  EXPECT_NEAR(kernel[1], 2 * pi / 3, 1e-9);
  EXPECT_NEAR(kernel[2], pi / 4, 1e-9);
}

TEST(Kernel, ZerothCoefficientIsTheMeanTransmittance) {
  for (const double eta : {1.01, 1.1, 1.3, 1.5, 3.0}) {
    EXPECT_NEAR(irradianceKernel(eta)[0], pi * bssrdf::meanTransmittance(eta), 1e-9);
  }
}

TEST(AmbientIrradiance, UniformEnvironment) {
  for (const double eta : {1.3, 1.5}) {
    const auto coefficients = projectUniform({1.0F, 0.5F, 0.0F});
    for (const Vec3& normal : someDirections(20)) {
      const auto irradiance = ambientIrradiance(coefficients, irradianceKernel(eta), normal);
      EXPECT_NEAR(irradiance[0], pi * bssrdf::meanTransmittance(eta), 1e-9);
      EXPECT_NEAR(irradiance[1], 0.5 * pi * bssrdf::meanTransmittance(eta), 1e-9);
      EXPECT_EQ(irradiance[2], 0.0);
    }
  }
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
  const int azimuthSteps = 16;  // exact for polynomials of degree 2
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

// L ≥ 0 everywhere, so nothing is clamped.
TEST(AmbientIrradiance, SmoothEnvironmentAgainstQuadrature) {
  const auto radiance = [](const Direction& d) {
    const auto [x, y, z] = d;
    return 4 + x - 2 * y + 0.5 * z + x * y + 0.7 * y * z - x * z + z * z + 0.5 * (x * x - y * y);
  };
  const auto coefficients = projectEnvironment(imageOf(radiance, 1024, 512));
  for (const double eta : {1.1, 1.3, 1.5}) {
    const auto kernel = irradianceKernel(eta);
    for (const Vec3& normal : someDirections(12)) {
      const auto irradiance = ambientIrradiance(coefficients, kernel, normal);
      const double expected = hemisphereIrradiance(radiance, normal, eta);
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(irradiance[c] / (static_cast<double>(c + 1) * expected), 1, 5e-5);
      }
    }
  }
}

ShCoefficients sunAt(const Vec3& direction, double power) {
  ShCoefficients coefficients{};
  const auto basis = sphericalHarmonics(direction);
  for (std::size_t i = 0; i < 9; ++i) coefficients[i] = {power * basis[i], 0, power * basis[i] / 3};
  return coefficients;
}

TEST(AmbientIrradiance, IsNeverNegative) {
  const auto kernel = irradianceKernel(1.3);
  const auto coefficients = sunAt({0, 0, 1}, 70000);
  for (const Vec3& normal : someDirections(500)) {
    for (const double value : ambientIrradiance(coefficients, kernel, normal)) EXPECT_GE(value, 0);
  }
}

TEST(Window, LeavesSmoothEnvironmentsAlone) {
  const auto kernel = irradianceKernel(1.3);
  const auto coefficients =
      projectEnvironment(imageOf([](const Direction& d) { return 1 + 0.5 * d[1]; }, 32, 16));
  EXPECT_EQ(windowed(coefficients, kernel), coefficients);
  EXPECT_EQ(windowed(ShCoefficients{}, kernel), ShCoefficients{});
}

// A sun under the clamped cosine: with bands times s^l irradiance in units of its power is
// 1/4 + s/2 c + s² 5/32 (3c² - 1), c the cosine to the sun. It touches zero where the discriminant
// s²/4 - 15/8 s² (1/4 - 5/32 s²) vanishes: s² = 56/75.
TEST(Window, DampsASunNoMoreThanNeeded) {
  const std::array<double, 3> kernel = {pi, 2 * pi / 3, pi / 4};
  const double keep = std::sqrt(56.0 / 75.0);
  for (const Vec3& sun : someDirections(8)) {
    const auto original = sunAt(sun, 1000);
    const auto result = windowed(original, kernel);
    for (std::size_t i = 0; i < 9; ++i) {
      const double window = i == 0 ? 1 : i < 4 ? keep : keep * keep;
      EXPECT_NEAR(result[i][0], original[i][0] * window, 0.3) << i;
      EXPECT_NEAR(result[i][2], result[i][0] / 3, 1e-9);
    }
    double least = 1000;
    for (const Vec3& normal : someDirections(3000)) {
      // Unclamped, by a large constant that is taken off again.
      auto lifted = result;
      lifted[0][0] += 1e4;
      const double offset = 1e4 * kernel[0] * sphericalHarmonics(normal)[0];
      least = std::min(least, ambientIrradiance(lifted, kernel, normal)[0] - offset);
    }
    EXPECT_GT(least, -0.01);  // of 250 in the mean; without the window -40
    EXPECT_LT(least, 1);
  }
}

TEST(Window, IsDeterministic) {
  const auto kernel = irradianceKernel(1.3);
  EXPECT_EQ(windowed(sunAt({0, 0, 1}, 7), kernel), windowed(sunAt({0, 0, 1}, 7), kernel));
}

}  // namespace
}  // namespace opaline
