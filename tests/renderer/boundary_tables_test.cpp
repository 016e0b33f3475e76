// Boundary transport against tables of volumetric Monte Carlo, which shares no code with it:
// spheres, slabs and, as thick slabs, the half-space. The figures are from the project's reference
// tables (sphere_exitance_mc.csv, slab_mc.csv), with light scattered once and more often added.
// Standard errors are at most 0.4 %. A medium's lengths are scaled so that bodies of three sizes
// are one body in three channels.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <ostream>

#include "renderer/boundary_fixture.h"

namespace opaline {
namespace {

using namespace test;

struct Channel {
  double sigmaSPerMm;
  double sigmaAPerMm;
};
constexpr Channel marbleRed{2.19, 0.0021};
constexpr Channel marbleBlue{3.0, 0.0071};
constexpr Channel skinRed{0.74, 0.032};

struct SphereRow {
  const char* name;
  Channel medium;
  double radiusMm;
  double most;                      ///< L1 over the bands
  std::array<double, 20> exitance;  ///< from the far side to the side of the light, irradiance 1
};

constexpr std::array<SphereRow, 6> sphereRows{{
    {"marble red, large", marbleRed, 25.54046, 0.03, {0.000702, 0.0008364, 0.001139, 0.001392,
                                                      0.00186,  0.002569,  0.003531, 0.005356,
                                                      0.008685, 0.01608,   0.04116,  0.09976,
                                                      0.1794,   0.2666,    0.3572,   0.4439,
                                                      0.5312,   0.6145,    0.6945,   0.7732}},
    {"marble red, small", marbleRed, 8.51349, 0.03, {0.01181, 0.01379, 0.01555, 0.0178,  0.02112,
                                                     0.02523, 0.03085, 0.03835, 0.04973, 0.06828,
                                                     0.1013,  0.1545,  0.2192,  0.291,   0.3644,
                                                     0.4382,  0.5075,  0.5771,  0.6456,  0.7076}},
    {"marble blue, large", marbleBlue, 11.86778, 0.03, {0.001048, 0.001334, 0.001688, 0.00222,
                                                        0.00286,  0.003951, 0.005555, 0.008238,
                                                        0.01323,  0.02326,  0.05007,  0.104,
                                                        0.1758,   0.254,    0.3351,   0.4122,
                                                        0.4896,   0.5644,   0.636,    0.7066}},
    {"marble blue, small", marbleBlue, 3.95593, 0.03, {0.01934, 0.02158, 0.02487, 0.02846, 0.03323,
                                                       0.03915, 0.04688, 0.05724, 0.07195, 0.09226,
                                                       0.124,   0.1706,  0.2255,  0.2846,  0.3452,
                                                       0.4038,  0.4616,  0.5179,  0.573,   0.6269}},
    {"skin1 red, large", skinRed, 11.24596, 0.03, {0.003168, 0.004174, 0.005553, 0.007235, 0.009613,
                                                   0.01297,  0.01751,  0.0244,   0.03449,  0.04984,
                                                   0.07617,  0.1138,   0.1566,   0.1993,   0.241,
                                                   0.2817,   0.3199,   0.3551,   0.3897,   0.4199}},
    {"skin1 red, small", skinRed, 3.74865, 0.03, {0.07966, 0.08527, 0.08788, 0.09166, 0.09699,
                                                  0.1035,  0.1109,  0.1203,  0.1313,  0.1453,
                                                  0.1634,  0.1847,  0.206,   0.2267,  0.2475,
                                                  0.2664,  0.2827,  0.3003,  0.3156,  0.3294}},
}};

/// Scales the channel as if a body of that size were `edgeMm` large.
void setChannel(Medium& medium, std::size_t c, const Channel& channel, double sizeMm,
                double edgeMm) {
  medium.sigmaSPrimePerMm[c] = channel.sigmaSPerMm * sizeMm / edgeMm;
  medium.sigmaAPerMm[c] = channel.sigmaAPerMm * sizeMm / edgeMm;
}

struct SphereCase {
  const char* name;
  double eta;
  std::array<std::size_t, 3> rows;
};

void PrintTo(const SphereCase& rows, std::ostream* to) {
  *to << rows.name;
}

class BoundarySphereTest : public RendererTestBase<testing::TestWithParam<SphereCase>> {};

TEST_P(BoundarySphereTest, BandsLeaveWhatTheTableSays) {
  constexpr float radiusMm = 10;
  Medium medium{"any", {}, {}, GetParam().eta};
  for (std::size_t c = 0; c < 3; ++c) {
    const SphereRow& row = sphereRows[GetParam().rows[c]];
    setChannel(medium, c, row.medium, row.radiusMm, static_cast<double>(radiusMm));
  }
  Scene scene = ballOf(radiusMm, medium);
  scene.lighting.directional = {{{1, 0, 0}, {1, 1, 1}}};
  const std::vector<Image> images =
      renderBoundary(scene, boundaryOptions(96), {Aov::Exitance, Aov::Position}).images;
  const auto bands = exitanceOfBands<20>(images[0], images[1], scene.camera.positionMm);
  for (std::size_t c = 0; c < 3; ++c) {
    const SphereRow& row = sphereRows[GetParam().rows[c]];
    double error = 0;
    double sum = 0;
    for (std::size_t band = 0; band < bands.size(); ++band) {
      error += std::abs(bands[band][c] - row.exitance[band]);
      sum += row.exitance[band];
    }
    RecordProperty(row.name, std::to_string(error / sum));
    EXPECT_LT(error / sum, row.most) << row.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Tables, BoundarySphereTest,
                         testing::Values(SphereCase{"marble", 1.5, {0, 1, 2}},
                                         SphereCase{"small_marble", 1.5, {3, 1, 3}},
                                         SphereCase{"skin1", 1.3, {4, 5, 4}}),
                         [](const auto& rows) { return std::string(rows.param.name); });

/// One medium as slabs of 0.1, 0.3 and 1 diffusion lengths.
struct SlabCase {
  const char* name;
  Channel medium;
  double eta;
  float widthOverThickness;
  std::array<double, 3> thicknessMm;
  double most;                                  ///< L1 over reflectance and transmittance
  std::array<std::array<double, 2>, 3> normal;  ///< reflectance and transmittance for unit flux
  std::array<std::array<double, 2>, 3> diffuse;
};

void PrintTo(const SlabCase& slab, std::ostream* to) {
  *to << slab.name;
}

constexpr std::array<SlabCase, 4> slabCases{{
    {"marble_red",
     marbleRed,
     1.5,
     20,
     {0.85135, 2.55405, 8.51349},
     0.02,
     {{{0.4306, 0.3784}, {0.6244, 0.3072}, {0.7722, 0.1118}}},
     {{{0.4292, 0.3670}, {0.6005, 0.2823}, {0.7344, 0.1028}}}},
    {"marble_blue",
     marbleBlue,
     1.5,
     20,
     {0.39559, 1.18678, 3.95593},
     0.03,
     {{{0.3398, 0.3241}, {0.5370, 0.3586}, {0.6921, 0.1523}}},
     {{{0.3482, 0.3245}, {0.5200, 0.3361}, {0.6638, 0.1383}}}},
    {"skin1_red",
     skinRed,
     1.3,
     20,
     {1.12460, 3.74865, 3.74865},
     0.02,
     {{{0.2443, 0.2326}, {0.3947, 0.2405}, {0.3947, 0.2405}}},
     {{{0.2631, 0.2489}, {0.3970, 0.2253}, {0.3970, 0.2253}}}},
    // Light that scattered once travels several free paths along this slab, each 3.5 times as long
    // as the slab is thick.
    {"thin_skin1_red",
     skinRed,
     1.3,
     40,
     {0.37487, 0.37487, 0.37487},
     0.03,
     {{{0.1097, 0.1086}, {0.1097, 0.1086}, {0.1097, 0.1086}}},
     {{{0.1268, 0.1257}, {0.1268, 0.1257}, {0.1268, 0.1257}}}},
}};

/// A slab between z = -½ and ½, much wider than thick, with three thicknesses in its channels.
Scene slabOf(const SlabCase& slab, float side) {
  Medium medium{slab.name, {}, {}, slab.eta};
  for (std::size_t c = 0; c < 3; ++c) setChannel(medium, c, slab.medium, slab.thicknessMm[c], 1);
  const float half = slab.widthOverThickness / 2;
  return sceneOf(box({0, 0, 0}, {half, half, 0.5F}, 40), medium, {0, 0, 20 * side}, 3);
}

// The mean over the middle, where the slab is as good as endless.
std::array<double, 3> middleOf(const Scene& scene, double halfMm = 2.5, int maxSurfels = 32'768) {
  RenderOptions options = boundaryOptions(24);
  options.maxSurfels = maxSurfels;
  const std::vector<Image> images =
      renderBoundary(scene, options, {Aov::Exitance, Aov::Position}).images;
  return meanWhere(images[0], images[1], [&](const Vector& at) {
    return std::max(std::abs(at[0]), std::abs(at[1])) < halfMm;
  });
}

class BoundarySlabTest : public RendererTestBase<testing::TestWithParam<SlabCase>> {};

TEST_P(BoundarySlabTest, LightAlongTheNormal) {
  const SlabCase& slab = GetParam();
  std::array<std::array<double, 3>, 2> found{};
  for (std::size_t back = 0; back < 2; ++back) {
    Scene scene = slabOf(slab, back == 0 ? 1.0F : -1.0F);
    scene.lighting.directional = {{{0, 0, 1}, {1, 1, 1}}};
    found[back] = middleOf(scene);
  }
  for (std::size_t c = 0; c < 3; ++c) {
    const auto& [reflected, transmitted] = slab.normal[c];
    EXPECT_LT((std::abs(found[0][c] - reflected) + std::abs(found[1][c] - transmitted)) /
                  (reflected + transmitted),
              slab.most)
        << slab.thicknessMm[c] << " mm: " << found[0][c] << " and " << found[1][c] << " for "
        << reflected << " and " << transmitted;
  }
}

// Lit from both sides, so that each side shows what it reflects and what comes through.
TEST_P(BoundarySlabTest, LightFromEverywhere) {
  const SlabCase& slab = GetParam();
  Scene scene = slabOf(slab, 1);
  constexpr auto unitFlux = std::numbers::inv_pi_v<float>;
  scene.lighting.ambient = {unitFlux, unitFlux, unitFlux};
  const std::array<double, 3> found = middleOf(scene);
  for (std::size_t c = 0; c < 3; ++c) {
    const double both = slab.diffuse[c][0] + slab.diffuse[c][1];
    EXPECT_NEAR(found[c] / both, 1, slab.most) << slab.thicknessMm[c] << " mm";
  }
}

INSTANTIATE_TEST_SUITE_P(Tables, BoundarySlabTest, testing::ValuesIn(slabCases),
                         [](const auto& slab) { return std::string(slab.param.name); });

/// The reflectance of an endless half-space.
struct HalfSpaceCase {
  const char* name;
  double eta;
  std::array<Channel, 3> media;
  std::array<double, 3> normal;
  std::array<double, 3> diffuse;
  int maxSurfels;  ///< in light along the normal
};

// A slab six diffusion lengths thick: less than 0.001 gets through.
TEST_F(RendererTest, BoundaryOfALargeThickSlabIsThatOfAHalfSpace) {
  const std::array<HalfSpaceCase, 2> cases{{{"marble",
                                             1.5,
                                             {marbleRed, marbleBlue, marbleBlue},
                                             {0.8048, 0.7305, 0.7305},
                                             {0.7656, 0.6971, 0.6971},
                                             RenderOptions{}.maxSurfels},
                                            {"skin1",
                                             1.3,
                                             {skinRed, skinRed, skinRed},
                                             {0.4308, 0.4308, 0.4308},
                                             {0.4290, 0.4290, 0.4290},
                                             32'768}}};
  constexpr float thicknessMm = 10;
  constexpr double most = 0.02;
  for (const HalfSpaceCase& half : cases) {
    Medium medium{half.name, {}, {}, half.eta};
    for (std::size_t c = 0; c < 3; ++c) {
      const auto [s, a] = half.media[c];
      // Grosjean's coefficient, as in d'Eon 2012.
      const double diffusion = (2 * a + s) / (3 * (a + s) * (a + s));
      const double lengthMm = std::sqrt(diffusion / a);
      setChannel(medium, c, half.media[c], 6 * lengthMm, static_cast<double>(thicknessMm));
    }
    Scene scene = sceneOf(box({0, 0, 0}, {20, 20, thicknessMm / 2}, 20), medium, {0, 0, 80}, 6);
    scene.lighting.directional = {{{0, 0, 1}, {1, 1, 1}}};
    const std::array<double, 3> normal = middleOf(scene, 5, half.maxSurfels);
    scene.lighting.directional.clear();
    constexpr auto unitFlux = std::numbers::inv_pi_v<float>;
    scene.lighting.ambient = {unitFlux, unitFlux, unitFlux};
    const std::array<double, 3> diffuse = middleOf(scene, 5);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(normal[c] / half.normal[c], 1, most) << half.name << " " << c;
      EXPECT_NEAR(diffuse[c] / half.diffuse[c], 1, most) << half.name << " " << c;
    }
  }
}

/// Exitance of a half-space for unit flux, by Monte Carlo (tools/half_space.py).
struct DarkHalfSpace {
  double albedo;
  double normal;
  double diffuse;
};

constexpr std::array<DarkHalfSpace, 2> darkHalfSpaces{
    {{2.0 / 3, .1092, .1125}, {10.0 / 11, .3007, .3035}}};

// Where clusters are small, light is followed to its second collision, and elsewhere to its first.
// What leaves must not depend on that: the clusters of the three channels are 1.5, 2.3 and 3 mean
// free paths large.
TEST_F(RendererTest, BoundaryOfADarkHalfSpaceIsThatOfMonteCarloHoweverLargeClustersAre) {
  for (const DarkHalfSpace& half : darkHalfSpaces) {
    Medium medium{.name = "dark", .eta = 1.3};
    medium.sigmaSPrimePerMm = {1, 1.5, 2};
    for (std::size_t c = 0; c < 3; ++c)
      medium.sigmaAPerMm[c] = medium.sigmaSPrimePerMm[c] * (1 / half.albedo - 1);
    Scene scene = sceneOf(box({0, 0, 0}, {10, 10, 8}, 40), medium, {0, 0, 60}, 8);
    scene.lighting.directional = {{{0, 0, 1}, {1, 1, 1}}};
    const std::array<double, 3> normal = middleOf(scene);
    scene.lighting.directional.clear();
    constexpr auto unitFlux = std::numbers::inv_pi_v<float>;
    scene.lighting.ambient = {unitFlux, unitFlux, unitFlux};
    const std::array<double, 3> diffuse = middleOf(scene);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(normal[c] / half.normal, 1, .03) << half.albedo << ", channel " << c;
      EXPECT_NEAR(diffuse[c] / half.diffuse, 1, .03) << half.albedo << ", channel " << c;
    }
  }
}

}  // namespace
}  // namespace opaline
