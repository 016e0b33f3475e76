// The derivatives of the profiles as the shaders compute them, compiled as C++, against differences
// of the published formulas in long double.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>
#include <numbers>

#include "bssrdf/profile.h"
#include "opaline/media.h"
#include "shaders/profile_packing.h"

namespace opaline::test::glsl {

using glm::exp2;
using glm::inversesqrt;
using glm::lessThan;
using glm::vec3;
using shared::Profile;

inline vec3 mix(vec3 a, vec3 b, glm::bvec3 which) {
  return {which.x ? b.x : a.x, which.y ? b.y : a.y, which.z ? b.z : a.z};
}

#include "shaders/lib/multipole.glsl"

}  // namespace opaline::test::glsl

namespace opaline::passes {
namespace {

using bssrdf::Model;
using bssrdf::Profile;
using Real = long double;

// Jensen et al. 2001, Eq. 4, and d'Eon 2012, by the square of the distance, which may be negative
// as far as the poles allow.
Real profileAt(const Profile& p, Real squaredMm2) {
  const Real sigma = p.sigmaTrPerMm;
  const auto flux = [&](Real z) {
    const Real d = std::sqrt(squaredMm2 + z * z);
    return z * (1 + sigma * d) * std::exp(-sigma * d) / (d * d * d);
  };
  const auto fluence = [&](Real z) {
    const Real d = std::sqrt(squaredMm2 + z * z);
    return std::exp(-sigma * d) / d;
  };
  const Real over = Real{p.albedo} / (4 * std::numbers::pi_v<Real>);
  const Real fluxes = flux(p.zRealMm) + flux(p.zVirtualMm);
  if (p.model == Model::Dipole) return over * fluxes;
  return over * (Real{p.cPhi} * (fluence(p.zRealMm) - fluence(p.zVirtualMm)) / Real{p.diffusionMm} +
                 Real{p.cE} * fluxes);
}

struct Exact {
  Real value;
  Real first;
  Real second;
};

// Central differences without their errors of second to sixth order (Richardson 1911).
Exact derivativesAt(const Profile& p, Real squaredMm2) {
  const Real pole = squaredMm2 + Real{p.zRealMm} * Real{p.zRealMm};
  const Real widest = pole / (10 + 5 * Real{p.sigmaTrPerMm} * std::sqrt(pole));
  const Real middle = profileAt(p, squaredMm2);
  std::array<Real, 4> first{};
  std::array<Real, 4> second{};
  for (std::size_t i = 0; i < 4; ++i) {
    const Real h = widest / static_cast<Real>(1U << i);
    const Real after = profileAt(p, squaredMm2 + h);
    const Real before = profileAt(p, squaredMm2 - h);
    first[i] = (after - before) / (2 * h);
    second[i] = (after - 2 * middle + before) / (h * h);
  }
  for (std::size_t order = 1; order < 4; ++order) {
    const Real weight = std::pow(Real{4}, static_cast<int>(order));
    for (std::size_t i = 0; i + order < 4; ++i) {
      first[i] = (weight * first[i + 1] - first[i]) / (weight - 1);
      second[i] = (weight * second[i + 1] - second[i]) / (weight - 1);
    }
  }
  return {middle, first[0], second[0]};
}

struct Worst {
  double value = 0;
  double first = 0;
  double second = 0;
};

double off(float found, Real exact) {
  return static_cast<double>(std::abs(Real{found} / exact - 1));
}

// Worst error over all places up to so many mean free paths, or diffusion lengths, away.
Worst worstOf(const Medium& medium, Model model, double meanFreePaths) {
  const std::array<Profile, 3> profiles = bssrdf::makeProfiles(model, medium);
  const shared::Profile packed = shaders::packProfile(profiles);
  Worst worst;
  for (double step = 0; step <= 1; step += 1.0 / 256) {
    glm::vec3 squared(0);
    for (int c = 0; c < 3; ++c) {
      const Profile& p = profiles[static_cast<std::size_t>(c)];
      double farMm = meanFreePaths * p.zRealMm;
      if (p.sigmaTrPerMm > 0) farMm = std::min(farMm, 15 / p.sigmaTrPerMm);
      squared[c] = static_cast<float>(std::pow(step * step * farMm, 2));
    }
    const test::glsl::Derivatives found =
        model == Model::Dipole ? test::glsl::dipoleDerivatives(packed, squared)
                               : test::glsl::betterDipoleDerivatives(packed, squared);
    for (int c = 0; c < 3; ++c) {
      const Exact exact =
          derivativesAt(profiles[static_cast<std::size_t>(c)], static_cast<Real>(squared[c]));
      worst.value = std::max(worst.value, off(found.value[c], exact.value));
      worst.first = std::max(worst.first, off(found.first[c], exact.first));
      worst.second = std::max(worst.second, off(found.second[c], exact.second));
    }
  }
  return worst;
}

void expectDerivatives(Model model, double meanFreePaths, double bound) {
  std::vector<Medium> media{{"faint", {1, 10, 0.1}, {1e-4, 1e-5, 0}, 1.3},
                            {"dark", {0.01, 0.1, 1}, {1, 1, 10}, 1.8}};
  for (const MeasuredMedium& row : measuredMedia()) media.push_back(row.medium);
  for (const Medium& medium : artisticMedia()) media.push_back(medium);
  Worst all;
  for (const Medium& medium : media) {
    const Worst worst = worstOf(medium, model, meanFreePaths);
    EXPECT_LT(worst.value, 1e-5) << medium.name;
    EXPECT_LT(worst.first, bound) << medium.name;
    EXPECT_LT(worst.second, bound) << medium.name;
    all.value = std::max(all.value, worst.value);
    all.first = std::max(all.first, worst.first);
    all.second = std::max(all.second, worst.second);
  }
}

TEST(MultipoleShader, DipolesDerivatives) {
  expectDerivatives(Model::Dipole, 1000, 1e-5);
}

// Fluence is a difference of two poles. Far from both it is as small as the square of the poles'
// distance over that from the place, and its accuracy falls likewise.
TEST(MultipoleShader, BetterDipolesDerivatives) {
  expectDerivatives(Model::BetterDipole, 10, 1e-5);
  expectDerivatives(Model::BetterDipole, 100, 5e-4);
}

TEST(MultipoleShader, OutsideADiscIsWhatTheDiscLeaves) {
  for (const MeasuredMedium& row : measuredMedia())
    for (const Model model : {Model::Dipole, Model::BetterDipole}) {
      const std::array<Profile, 3> profiles = bssrdf::makeProfiles(model, row.medium);
      for (const double radiusMm : {0.0, 0.1, 1.0, 5.0}) {
        const glm::vec3 found = test::glsl::profileOutside(
            shaders::packProfile(profiles), glm::vec3(static_cast<float>(radiusMm * radiusMm)));
        for (int c = 0; c < 3; ++c) {
          const Profile& profile = profiles[static_cast<std::size_t>(c)];
          const double total = profile.totalReflectance();
          EXPECT_NEAR(static_cast<double>(found[c]), total - profile.disc(radiusMm), 1e-5 * total)
              << row.medium.name << " " << radiusMm;
        }
      }
    }
}

TEST(MultipoleShader, DifferencesAreOfThePublishedProfiles) {
  for (const MeasuredMedium& row : measuredMedia())
    for (const Model model : {Model::Dipole, Model::BetterDipole})
      for (const Profile& profile : bssrdf::makeProfiles(model, row.medium))
        for (const double radiusMm : {0.0, 0.1, 1.0, 10.0})
          ASSERT_NEAR(static_cast<double>(profileAt(profile, Real{radiusMm} * Real{radiusMm})) /
                          profile(radiusMm),
                      1, 1e-10)
              << row.medium.name;
}

}  // namespace
}  // namespace opaline::passes
