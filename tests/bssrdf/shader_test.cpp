// The shaders' source compiled as C++: the effect of float arithmetic, independent of any device.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/exponential.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>

#include "bssrdf/fresnel.h"
#include "bssrdf/profile.h"
#include "opaline/media.h"
#include "shaders/profile_packing.h"

namespace opaline::test::glsl {

using glm::exp2;
using glm::inversesqrt;
using glm::lessThan;
using glm::vec3;
using shared::Profile;
using std::sqrt;

vec3 mix(vec3 a, vec3 b, glm::bvec3 which) {
  return {which.x ? b.x : a.x, which.y ? b.y : a.y, which.z ? b.z : a.z};
}

#include "shaders/lib/fresnel.glsl"
#include "shaders/lib/profile.glsl"

}  // namespace opaline::test::glsl

namespace opaline::bssrdf {
namespace {

void expectSame(const Medium& medium, Model model) {
  std::array<Profile, 3> exact;
  double shortestDiffusion = 1e9;
  for (int c = 0; c < 3; ++c) {
    Profile& profile = exact[static_cast<std::size_t>(c)];
    profile = makeProfile(model, coefficients(medium, c));
    const double length = profile.sigmaTrPerMm > 0 ? 1 / profile.sigmaTrPerMm : 1e9;
    shortestDiffusion = std::min(shortestDiffusion, std::min(length, 1000 * profile.zRealMm));
  }
  const shared::Profile packed = shaders::packProfile(exact);
  for (double r = 0; r <= 20 * shortestDiffusion; r = r * 1.07 + 1e-4 * shortestDiffusion) {
    const auto squared = static_cast<float>(r * r);
    const double rounded = std::sqrt(static_cast<double>(squared));
    const glm::vec3 value = model == Model::Dipole
                                ? test::glsl::dipoleProfile(packed, squared)
                                : test::glsl::betterDipoleProfile(packed, squared);
    for (int c = 0; c < 3; ++c) {
      const double expected = exact[static_cast<std::size_t>(c)](rounded);
      if (expected == 0 && value[c] == 0) continue;
      ASSERT_NEAR(static_cast<double>(value[c]) / expected, 1, 1e-5)
          << medium.name << ' ' << c << " at " << r;
    }
  }
}

TEST(ProfileShader, AgreesWithDoublePrecision) {
  for (const Model model : {Model::Dipole, Model::BetterDipole}) {
    for (const MeasuredMedium& row : measuredMedia()) expectSame(row.medium, model);
    for (const Medium& medium : artisticMedia()) expectSame(medium, model);
    expectSame({"faint", {1, 10, 0.1}, {1e-6, 1e-5, 0}, 1.3}, model);
    expectSame({"dark", {0.01, 0.1, 1}, {1, 1, 10}, 1.8}, model);
  }
}

TEST(FresnelShader, AgreesWithDoublePrecision) {
  for (const double eta : {1.01, 1.3, 1.5, 2.5}) {
    for (int i = 0; i <= 1000; ++i) {
      const auto mu = static_cast<float>(i / 1000.0);
      EXPECT_NEAR(test::glsl::fresnelReflectance(static_cast<float>(eta), mu),
                  fresnelReflectance(static_cast<double>(static_cast<float>(eta)), mu), 2e-6)
          << eta << ' ' << mu;
    }
  }
}

}  // namespace
}  // namespace opaline::bssrdf
