#include "bssrdf/profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "bssrdf/fresnel.h"
#include "bssrdf/quadrature.h"
#include "opaline/media.h"

namespace opaline::bssrdf {
namespace {

using test::integrate;

using std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<Profile> allProfiles(Model model) {
  std::vector<Profile> profiles;
  const auto add = [&](const Medium& medium) {
    for (int c = 0; c < 3; ++c) profiles.push_back(makeProfile(model, coefficients(medium, c)));
  };
  for (const MeasuredMedium& row : measuredMedia()) add(row.medium);
  for (const Medium& medium : artisticMedia()) add(medium);
  add({"extreme", {1000, 1e-3, 5}, {1e-9, 10, 1e-6}, 3.0});
  return profiles;
}

std::vector<Profile> allProfiles() {
  std::vector<Profile> profiles = allProfiles(Model::Dipole);
  for (const Profile& profile : allProfiles(Model::BetterDipole)) profiles.push_back(profile);
  return profiles;
}

/// R_d as the papers write it, in long double, where the cancellation of the fluence costs less.
long double writtenOut(const Profile& p, long double r) {
  const long double four = 4 * std::numbers::pi_v<long double>;
  const long double sigma = p.sigmaTrPerMm;
  long double flux = 0;
  for (const long double z :
       {static_cast<long double>(p.zRealMm), static_cast<long double>(p.zVirtualMm)}) {
    const long double d = std::hypot(r, z);
    flux += z * (1 + sigma * d) * std::exp(-sigma * d) / (four * d * d * d);
  }
  if (p.model == Model::Dipole) return p.albedo * flux;
  const long double dr = std::hypot(r, static_cast<long double>(p.zRealMm));
  const long double dv = std::hypot(r, static_cast<long double>(p.zVirtualMm));
  const long double fluence =
      (std::exp(-sigma * dr) / dr - std::exp(-sigma * dv) / dv) / (four * p.diffusionMm);
  return p.albedo * (p.cPhi * fluence + p.cE * flux);
}

// Joseph, Wiscombe and Weinman 1976, Eqs. 4 to 6: f = g², g' = g / (1 + g), and the scattering that
// remains.
TEST(ScaledScatteringTest, TakesTheForwardPeakAway) {
  for (const double g : {0.0, 0.3, 0.9, 0.99}) {
    Medium medium{"", {0.74, 2, 1e-3}, {0.032, 0, 10}, 1.3};
    medium.g = g;
    for (int c = 0; c < 3; ++c) {
      const auto i = static_cast<std::size_t>(c);
      const ScaledScattering scaled = scaledScattering(medium, c);
      const double scattering = medium.sigmaSPrimePerMm[i] / (1 - g) * (1 - g * g);
      EXPECT_NEAR(scaled.sigmaTPerMm, scattering + medium.sigmaAPerMm[i],
                  1e-12 * scaled.sigmaTPerMm);
      EXPECT_NEAR(scaled.albedo * scaled.sigmaTPerMm, scattering, 1e-12 * scattering);
      EXPECT_NEAR(scaled.g, (g - g * g) / (1 - g * g), 1e-12);
    }
  }
}

TEST(ScaledScatteringTest, LeavesWhatScattersBackwards) {
  Medium medium{"", {1, 1, 1}, {0.1, 0.1, 0.1}, 1.3};
  medium.g = -0.5;
  const ScaledScattering scaled = scaledScattering(medium, 0);
  EXPECT_EQ(scaled.g, -0.5);
  EXPECT_NEAR(scaled.sigmaTPerMm, 1 / 1.5 + 0.1, 1e-12);
}

TEST(Profile, IsThePublishedFormula) {
  for (const Profile& profile : allProfiles()) {
    const double longest =
        profile.sigmaTrPerMm > 0 ? 700 / profile.sigmaTrPerMm : 1e4 * profile.zRealMm;
    EXPECT_NEAR(profile(0) / static_cast<double>(writtenOut(profile, 0)), 1, 1e-12);
    for (double r = 1e-6 * profile.zRealMm; r < longest; r *= 1.3) {
      const auto expected = static_cast<double>(writtenOut(profile, static_cast<long double>(r)));
      // Beyond 10⁴ mean free paths even the reference lacks the digits that the test needs.
      if (profile.model == Model::BetterDipole && r > 1e4 * profile.zRealMm) break;
      if (expected < std::numeric_limits<double>::min()) break;
      ASSERT_NEAR(profile(r) / expected, 1, 1e-12) << r << ' ' << profile.sigmaTrPerMm;
    }
    EXPECT_EQ(profile(infinity), 0.0);
    EXPECT_GE(profile(1e200), 0.0);
  }
}

/// ∫ R_d 2π r dr over [from, to], r = z_r sinh t.
double discByQuadrature(const Profile& profile, double from, double to) {
  const double scale = profile.zRealMm;
  return integrate(
      [&](double t) {
        const double r = scale * std::sinh(t);
        return profile(r) * 2 * pi * r * scale * std::cosh(t);
      },
      std::asinh(from / scale), std::asinh(to / scale), 400);
}

TEST(Disc, IsTheIntegralOfTheProfile) {
  for (const Profile& profile : allProfiles()) {
    for (const double radius : {1e-3, 0.1, 0.99, 1.01, 3.0, 30.0, 1000.0}) {
      const double r = radius * profile.zRealMm;
      const double expected = discByQuadrature(profile, 0, r);
      EXPECT_NEAR(profile.disc(r) / expected, 1, 1e-9) << radius << ' ' << profile.sigmaTrPerMm;
    }
  }
}

TEST(Disc, RingIsADifference) {
  for (const Profile& profile : allProfiles()) {
    const double inner = 2 * profile.zRealMm;
    const double outer = 5 * profile.zRealMm;
    EXPECT_NEAR(
        (profile.disc(outer) - profile.disc(inner)) / discByQuadrature(profile, inner, outer), 1,
        1e-9);
  }
}

TEST(Disc, SmallDiscsAreAccurate) {
  for (const Profile& profile : allProfiles()) {
    const double r = 1e-7 * profile.zRealMm;
    EXPECT_NEAR(profile.disc(r) / (pi * r * r * profile(0)), 1, 1e-12);
    EXPECT_EQ(profile.disc(0), 0.0);
  }
}

TEST(Disc, GrowsToTheTotalReflectance) {
  for (const Profile& profile : allProfiles()) {
    double last = 0;
    for (double r = 1e-3 * profile.zRealMm; r < 1e7 * profile.zRealMm; r *= 1.1) {
      const double now = profile.disc(r);
      EXPECT_GE(now, last * (1 - 1e-14));
      last = now;
    }
    EXPECT_LE(last, profile.totalReflectance() * (1 + 1e-12));
    EXPECT_NEAR(profile.disc(1e12 * profile.zRealMm), profile.totalReflectance(), 1e-11);
    EXPECT_EQ(profile.disc(infinity), profile.totalReflectance());
    EXPECT_LE(profile.totalReflectance(), 1 + 1e-12);
  }
}

// Without absorption all light returns.
TEST(TotalReflectance, IsOneWithoutAbsorption) {
  for (const Model model : {Model::Dipole, Model::BetterDipole}) {
    for (const double eta : {1.01, 1.3, 1.5, 2.0}) {
      const Medium medium{"white", {0.5, 2, 20}, {0, 0, 0}, eta};
      for (int c = 0; c < 3; ++c) {
        const Profile profile = makeProfile(model, coefficients(medium, c));
        EXPECT_EQ(profile.sigmaTrPerMm, 0.0);
        EXPECT_NEAR(profile.totalReflectance(), 1, 1e-12);
        EXPECT_NEAR(profile.disc(1e9), 1, 1e-7);
      }
    }
  }
}

TEST(TotalReflectance, IsContinuousWhereAbsorptionVanishes) {
  for (const Model model : {Model::Dipole, Model::BetterDipole}) {
    const auto profile = [&](double sigmaA) {
      return makeProfile(model, coefficients({"m", {2, 2, 2}, {sigmaA, 0, 0}, 1.3}, 0));
    };
    for (const double radius : {0.0, 0.3, 5.0}) {
      EXPECT_NEAR(profile(1e-18)(radius) / profile(0)(radius), 1, 1e-7);
      EXPECT_NEAR(profile(1e-18).disc(radius + 1) / profile(0).disc(radius + 1), 1, 1e-7);
    }
  }
}

TEST(TotalReflectance, IsZeroWithoutScattering) {
  for (const Model model : {Model::Dipole, Model::BetterDipole}) {
    const Profile profile = makeProfile(model, coefficients({"ink", {0, 0, 0}, {3, 3, 3}, 1.3}, 0));
    EXPECT_EQ(profile.totalReflectance(), 0.0);
    EXPECT_EQ(profile(0.1), 0.0);
  }
}

// Jensen et al. 2001: the total reflectance in terms of α' and A only.
TEST(TotalReflectance, DipoleDependsOnAlbedoAlone) {
  const Medium medium{"m", {1, 10, 0.1}, {0.2, 2, 0.02}, 1.3};
  const double albedo = 1 / 1.2;
  const double fdr = -1.440 / 1.69 + 0.710 / 1.3 + 0.668 + 0.0636 * 1.3;
  const double a = (1 + fdr) / (1 - fdr);
  const double root = std::sqrt(3 * (1 - albedo));
  const double expected = albedo / 2 * (1 + std::exp(-4.0 / 3 * a * root)) * std::exp(-root);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(makeProfile(Model::Dipole, coefficients(medium, c)).totalReflectance(), expected,
                1e-14);
  }
}

TEST(BetterDipole, ConstantsAtOnePointThree) {
  const Medium medium{"m", {1, 1, 1}, {0.1, 0.1, 0.1}, 1.3};
  const Profile profile = makeProfile(Model::BetterDipole, coefficients(medium, 0));
  EXPECT_NEAR(twoC1(1.3), 0.4453, 5e-5);
  EXPECT_NEAR(profile.cPhi, 0.13868, 5e-6);
  EXPECT_NEAR(profile.cE, 0.35128, 5e-6);
  EXPECT_NEAR(profile.diffusionMm, 1.2 / (3 * 1.21), 1e-15);
  EXPECT_NEAR((profile.zVirtualMm - profile.zRealMm) / (4 * profile.diffusionMm), 2.3390, 5e-5);
  EXPECT_NEAR(profile.sigmaTrPerMm, std::sqrt(0.1 * 3 * 1.21 / 1.2), 1e-14);
}

// On a sphere under uniform irradiance every point receives D(2R), whatever the profile: here
// integrated over the polar angle θ between the points, chord 2R sin(θ/2).
TEST(Sphere, ReceivesTheDiscOfItsDiameter) {
  for (const Profile& profile : allProfiles()) {
    for (const double ratio : {0.5, 4.0, 20.0}) {
      const double radius = ratio * profile.zRealMm;
      const double byAngle = integrate(
          [&](double s) {
            const double theta = pi * s * s;  // finer where the points are close
            return profile(2 * radius * std::sin(theta / 2)) * 2 * pi * radius * radius *
                   std::sin(theta) * 2 * pi * s;
          },
          0, 1, 400);
      EXPECT_NEAR(profile.disc(2 * radius) / byAngle, 1, 1e-8);
    }
  }
}

TEST(Coefficients, FollowFromTheMedium) {
  const Coefficients c = coefficients({"m", {1, 2, 3}, {0.5, 0, 1}, 1.4}, 2);
  EXPECT_DOUBLE_EQ(c.sigmaTPrimePerMm, 4);
  EXPECT_DOUBLE_EQ(c.albedo, 0.75);
  EXPECT_DOUBLE_EQ(c.meanFreePathMm, 0.25);
  EXPECT_DOUBLE_EQ(c.eta, 1.4);
}

}  // namespace
}  // namespace opaline::bssrdf
