// Colours of balls in even light, against light traced from collision to collision in a ball.

#include "bssrdf/ball.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <random>

#include "bssrdf/fresnel.h"
#include "bssrdf/paint.h"
#include "opaline/medium.h"

namespace opaline::bssrdf {
namespace {

/// A ball with isotropic scattering, Fresnel's interface and an absorbing layer: the share of even
/// light that entered through the interface and leaves again.
class FollowedBall {
 public:
  FollowedBall(double radius, double albedo, double eta, double layer)
      : radius_(radius), albedo_(albedo), eta_(eta), layer_(layer) {}

  double leaves(int particles) {
    double sum = 0;
    for (int i = 0; i < particles; ++i) sum += follow();
    return sum / particles;
  }

 private:
  using Vector = std::array<double, 3>;

  static double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  double number() { return uniform_(random_); }

  // A direction of light that was even outside and has entered, at (0, 0, R) and downwards.
  Vector entered() {
    for (;;) {
      const double outside = std::sqrt(number());
      if (number() < fresnelReflectance(eta_, outside)) continue;
      const double sine = std::sqrt(1 - outside * outside) / eta_;
      return {sine, 0, -std::sqrt(1 - sine * sine)};
    }
  }

  Vector anyDirection() {
    const double z = 2 * number() - 1;
    const double angle = 2 * std::numbers::pi * number();
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
  }

  double follow() {
    Vector at{0, 0, radius_};
    Vector way = entered();
    double weight = std::exp(-layer_ / -way[2]);
    double left = 0;
    while (weight > 0) {
      const double b = dot(at, way);
      const double toSurface =
          -b + std::sqrt(std::max(b * b + radius_ * radius_ - dot(at, at), 0.0));
      const double toCollision = -std::log(1 - number());
      const bool leaves = toCollision >= toSurface;
      for (std::size_t k = 0; k < 3; ++k) at[k] += way[k] * (leaves ? toSurface : toCollision);
      if (leaves) {
        const double cosine = std::min(dot(at, way) / radius_, 1.0);
        const double mirrored = fresnelReflectanceInside(eta_, cosine);
        left += weight * (1 - mirrored) * std::exp(-layer_ / cosine);
        weight *= mirrored * std::exp(-2 * layer_ / cosine);
        for (std::size_t k = 0; k < 3; ++k) way[k] -= 2 * cosine * at[k] / radius_;
      } else {
        weight *= albedo_;
        way = anyDirection();
      }
      // Russian roulette.
      if (weight < 0.05) weight = number() < 0.5 ? 2 * weight : 0;
    }
    return left;
  }

  double radius_;
  double albedo_;
  double eta_;
  double layer_;
  std::mt19937 random_{7};
  std::uniform_real_distribution<double> uniform_{0, 1};
};

constexpr int particles = 20'000;  // precise to about 0.002

double albedoOf(const Medium& medium) {
  return medium.sigmaSPrimePerMm[0] / (medium.sigmaSPrimePerMm[0] + medium.sigmaAPerMm[0]);
}

TEST(BallTest, LargeOnesAreThickAndSmallOnesWhite) {
  for (const double eta : {1.3, 1.5}) {
    EXPECT_NEAR(colorOfBall(0.4, eta, 1e6), 0.4, 1e-5);
    EXPECT_NEAR(colorOfBall(0.4, eta, 1e-6), 1, 1e-5);
    EXPECT_NEAR(colorOfBall(1, eta, 1), 1, 1e-12);
  }
}

TEST(BallTest, MediaOfAnAppearanceGiveBallsItsColor) {
  for (const double eta : {1.3, 1.4, 1.5})
    for (const double color : {0.9, 0.4})
      for (const double meanFreePaths : {20.0, 60.0}) {
        Appearance appearance{{color, color, color}, {1, 1, 1}, 0, eta};
        appearance.ballMm = meanFreePaths;
        FollowedBall ball(meanFreePaths / 2, albedoOf(mediumOf(appearance)), eta, 0);
        EXPECT_NEAR(ball.leaves(particles), color, 0.02) << eta << " " << meanFreePaths;
      }
}

TEST(BallTest, MeanFreePathsStayAndScatteringForwardCountsAsReduced) {
  Appearance appearance{{0.8, 0.6, 0.4}, {1, 2, 3}, 0.7, 1.4};
  appearance.ballMm = 30;
  const Medium medium = mediumOf(appearance);
  for (std::size_t c = 0; c < 3; ++c) {
    const double scattering = medium.sigmaSPrimePerMm[c] / (1 - 0.7);
    EXPECT_NEAR(scattering + medium.sigmaAPerMm[c], 1 / appearance.meanFreePathMm[c], 1e-12);
    Appearance isotropic{{}, {}, 0, 1.4};
    isotropic.color.fill(appearance.color[c]);
    isotropic.meanFreePathMm.fill(1 / (medium.sigmaSPrimePerMm[c] + medium.sigmaAPerMm[c]));
    isotropic.ballMm = appearance.ballMm;
    EXPECT_NEAR(mediumOf(isotropic).sigmaAPerMm[c], medium.sigmaAPerMm[c], 1e-9);
  }
}

TEST(BallTest, LayersGiveBallsTheColorsThatTheyAreFor) {
  for (const double eta : {1.3, 1.5}) {
    Appearance appearance{{0.8, 0.8, 0.8}, {1, 1, 1}, 0, eta};
    appearance.ballMm = 20;
    const Medium medium = mediumOf(appearance);
    const LayerColors colors = layerColors(medium, appearance.ballMm)[0];
    for (const double wanted : {0.6, 0.3, 0.1}) {
      std::size_t i = 0;
      while (colors.ball[i] > wanted) ++i;
      // As fineTable of paint.cpp has them.
      const double part = static_cast<double>(i) / static_cast<double>(colors.ball.size() - 1);
      FollowedBall ball(10, albedoOf(medium), eta, thickestPaint * part * part);
      EXPECT_NEAR(ball.leaves(particles), colors.ball[i], 0.02) << eta << " " << wanted;
    }
  }
}

}  // namespace
}  // namespace opaline::bssrdf
