// The directions in which light leaves: the shaders' source as C++, against exact transfer in slabs
// and conservation of energy.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <numbers>

#include "bssrdf/exit_directions.h"
#include "bssrdf/fresnel.h"
#include "bssrdf/quadrature.h"
#include "shaders/shared/medium.h"

namespace opaline::test::exits {

using glm::clamp;
using glm::exp;
using glm::mix;
using glm::vec3;
using glm::vec4;
using shared::BoundaryMedium;
using shared::MediumData;
using std::max;
using std::sqrt;

// clang-format off
#include "shaders/lib/fresnel.glsl"
#include "shaders/lib/exit_law.glsl"
// clang-format on

}  // namespace opaline::test::exits

namespace opaline::bssrdf {
namespace {

using test::integrate;

/// A medium in one channel with a mean free path of 1 mm.
shared::MediumData mediumOf(double eta, double albedo) {
  const double diffusion = (2 * (1 - albedo) + albedo) / 3;  // Grosjean 1956
  const double robin = (1 + threeC2(eta)) / (1 - twoC1(eta));
  const ExitDirections exits = exitDirections(eta);
  shared::MediumData medium{};
  medium.boundary.x = static_cast<float>(eta);
  medium.inside.extinction = glm::vec4(1);
  medium.inside.diffusion =
      glm::vec4(glm::vec3(static_cast<float>(diffusion)), static_cast<float>(robin));
  medium.inside.sigma = glm::vec4(static_cast<float>(std::sqrt((1 - albedo) / diffusion)));
  medium.exits = {exits.cosines[0], exits.cosines[1], exits.mirrored[0], exits.mirrored[1]};
  medium.inside.sigma.w = static_cast<float>(meanCosineInside(eta));
  return medium;
}

/// For light that has entered at that place (1) or comes through the body (0).
double law(const shared::MediumData& medium, double thickness, double entered, double cosine) {
  const glm::vec4 origin(glm::vec3(static_cast<float>(entered)), static_cast<float>(1 / thickness));
  return static_cast<double>(test::exits::exitLaw(medium, static_cast<float>(cosine), origin).x);
}

double overDirections(double eta, const auto& function) {
  return 2 / meanTransmittance(eta) *
         integrate([&](double mu) { return mu * (1 - fresnelReflectance(eta, mu)) * function(mu); },
                   0, 1, 200);
}

TEST(ExitDirectionsTest, IntegratePolynomialsOfTheThirdDegree) {
  for (const double eta : {1.01, 1.3, 1.5, 3.0}) {
    const ExitDirections exits = exitDirections(eta);
    for (int degree = 0; degree <= 3; ++degree) {
      const double exact = overDirections(eta, [&](double mu) {
        return std::pow(std::sqrt(1 - (1 - mu * mu) / (eta * eta)), degree);
      });
      double sum = 0;
      for (std::size_t i = 0; i < 2; ++i)
        sum += exits.weights[i] * std::pow(exits.cosines[i], degree);
      EXPECT_NEAR(sum, exact, 2e-5) << eta << ' ' << degree;
    }
  }
}

// All light that leaves must go somewhere.
TEST(ExitLawTest, MeanOverDirectionsIsOne) {
  for (const double eta : {1.01, 1.3, 1.5, 2.0})
    for (const double albedo : {0.0, 0.5, 0.84, 0.96, 1.0})
      for (const double thickness : {0.5, 1.0, 3.0, 10.0, 1e6})
        for (const double entered : {0.0, 0.4, 1.0}) {
          const shared::MediumData medium = mediumOf(eta, albedo);
          const double mean =
              overDirections(eta, [&](double mu) { return law(medium, thickness, entered, mu); });
          EXPECT_NEAR(mean, 1, thickness < 1 ? 0.01 : 0.005)
              << eta << ' ' << albedo << ' ' << thickness << ' ' << entered;
        }
}

// Even light from everywhere is as bright in a white half-space as outside.
TEST(ExitLawTest, LightOnAWhiteHalfSpaceLeavesEvenly) {
  for (const double eta : {1.3, 1.5})
    for (const double cosine : {0.1, 0.5, 1.0})
      EXPECT_NEAR(law(mediumOf(eta, 1), 1e6, 1, cosine), 1, 0.004) << eta << ' ' << cosine;
}

TEST(ExitLawTest, UnknownOriginLeavesEvenly) {
  EXPECT_EQ(test::exits::exitLaw(mediumOf(1.3, 0.8), 0.3F, test::exits::unknownOrigin),
            glm::vec3(1));
}

/// Output of `tools/exit_law.py --table`: radiance relative to that of as much even light, at 0,
/// 30, 60 and 75 degrees, for light along the normal.
struct Row {
  double eta;
  double thickness;
  double albedo;
  std::array<double, 4> lit;
  std::array<double, 4> other;
};
constexpr std::array rows{
    Row{1.3, 0.5, 0.9999, {0.8525, 0.9067, 1.0790, 1.2495}, {0.8544, 0.9078, 1.0773, 1.2481}},
    Row{1.3, 0.5, 0.96, {0.8524, 0.9067, 1.0790, 1.2495}, {0.8545, 0.9079, 1.0772, 1.2481}},
    Row{1.3, 0.5, 0.84, {0.8521, 0.9065, 1.0793, 1.2497}, {0.8548, 0.9080, 1.0769, 1.2479}},
    Row{1.3, 0.5, 0.68, {0.8518, 0.9063, 1.0796, 1.2500}, {0.8552, 0.9082, 1.0766, 1.2476}},
    Row{1.3, 1, 0.9999, {0.8942, 0.9375, 1.0604, 1.1516}, {0.9027, 0.9426, 1.0542, 1.1419}},
    Row{1.3, 1, 0.96, {0.8937, 0.9372, 1.0609, 1.1523}, {0.9033, 0.9429, 1.0538, 1.1413}},
    Row{1.3, 1, 0.84, {0.8921, 0.9362, 1.0620, 1.1541}, {0.9049, 0.9438, 1.0527, 1.1395}},
    Row{1.3, 1, 0.68, {0.8904, 0.9352, 1.0632, 1.1562}, {0.9067, 0.9449, 1.0513, 1.1375}},
    Row{1.3, 4, 0.9999, {0.9709, 0.9852, 1.0168, 1.0298}, {1.0356, 1.0209, 0.9773, 0.9550}},
    Row{1.3, 4, 0.96, {0.9609, 0.9794, 1.0231, 1.0422}, {1.0507, 1.0289, 0.9683, 0.9388}},
    Row{1.3, 4, 0.84, {0.9443, 0.9699, 1.0334, 1.0629}, {1.0889, 1.0490, 0.9455, 0.8984}},
    Row{1.3, 4, 0.68, {0.9335, 0.9636, 1.0402, 1.0768}, {1.1264, 1.0684, 0.9234, 0.8597}},
    Row{1.3, 8, 0.9999, {0.9873, 0.9937, 1.0072, 1.0125}, {1.0616, 1.0322, 0.9638, 0.9344}},
    Row{1.3, 8, 0.96, {0.9667, 0.9824, 1.0197, 1.0362}, {1.0960, 1.0481, 0.9450, 0.9041}},
    Row{1.3, 8, 0.84, {0.9454, 0.9704, 1.0328, 1.0618}, {1.2033, 1.0953, 0.8885, 0.8170}},
    Row{1.3, 8, 0.68, {0.9339, 0.9638, 1.0400, 1.0764}, {1.3282, 1.1465, 0.8257, 0.7254}},
    Row{1.5, 0.5, 0.9999, {0.8858, 0.9270, 1.0578, 1.2140}, {0.8866, 0.9273, 1.0571, 1.2145}},
    Row{1.5, 0.5, 0.96, {0.8858, 0.9270, 1.0579, 1.2140}, {0.8866, 0.9273, 1.0571, 1.2145}},
    Row{1.5, 0.5, 0.84, {0.8856, 0.9270, 1.0581, 1.2139}, {0.8868, 0.9274, 1.0569, 1.2146}},
    Row{1.5, 0.5, 0.68, {0.8854, 0.9269, 1.0583, 1.2138}, {0.8870, 0.9274, 1.0567, 1.2148}},
    Row{1.5, 1, 0.9999, {0.9204, 0.9526, 1.0437, 1.1264}, {0.9241, 0.9544, 1.0410, 1.1245}},
    Row{1.5, 1, 0.96, {0.9201, 0.9524, 1.0440, 1.1266}, {0.9244, 0.9546, 1.0407, 1.1243}},
    Row{1.5, 1, 0.84, {0.9190, 0.9519, 1.0448, 1.1273}, {0.9255, 0.9551, 1.0399, 1.1238}},
    Row{1.5, 1, 0.68, {0.9178, 0.9513, 1.0457, 1.1279}, {0.9267, 0.9556, 1.0389, 1.1233}},
    Row{1.5, 4, 0.9999, {0.9803, 0.9902, 1.0115, 1.0202}, {1.0153, 1.0086, 0.9901, 0.9821}},
    Row{1.5, 4, 0.96, {0.9723, 0.9858, 1.0164, 1.0293}, {1.0266, 1.0143, 0.9834, 0.9704}},
    Row{1.5, 4, 0.84, {0.9599, 0.9791, 1.0241, 1.0436}, {1.0548, 1.0287, 0.9664, 0.9415}},
    Row{1.5, 4, 0.68, {0.9522, 0.9749, 1.0289, 1.0525}, {1.0820, 1.0424, 0.9502, 0.9142}},
    Row{1.5, 8, 0.9999, {0.9903, 0.9952, 1.0056, 1.0097}, {1.0315, 1.0160, 0.9814, 0.9673}},
    Row{1.5, 8, 0.96, {0.9751, 0.9872, 1.0148, 1.0263}, {1.0570, 1.0279, 0.9671, 0.9438}},
    Row{1.5, 8, 0.84, {0.9603, 0.9793, 1.0239, 1.0431}, {1.1364, 1.0638, 0.9236, 0.8746}},
    Row{1.5, 8, 0.68, {0.9524, 0.9750, 1.0288, 1.0523}, {1.2277, 1.1031, 0.8752, 0.8004}},
};

TEST(ExitLawTest, IsThatOfExactTransferInSlabs) {
  constexpr std::array<double, 4> degrees{0, 30, 60, 75};
  for (const Row& row : rows) {
    const shared::MediumData medium = mediumOf(row.eta, row.albedo);
    for (std::size_t i = 0; i < degrees.size(); ++i) {
      const double cosine = std::cos(degrees[i] * std::numbers::pi / 180);
      EXPECT_NEAR(law(medium, row.thickness, 1, cosine) / row.lit[i], 1, 0.03)
          << row.eta << ' ' << row.thickness << ' ' << row.albedo << ' ' << degrees[i];
      const double through = law(medium, row.thickness, 0, cosine);
      // Where little light passes a thick absorbing slab, it is steeper than the law's straight
      // line.
      const bool isDark = row.albedo < 0.9 && row.thickness > 2;
      EXPECT_LT(std::abs(through - row.other[i]),
                (isDark ? std::abs(1 - row.other[i]) : 0.03 * row.other[i]))
          << row.eta << ' ' << row.thickness << ' ' << row.albedo << ' ' << degrees[i];
    }
  }
}

}  // namespace
}  // namespace opaline::bssrdf
