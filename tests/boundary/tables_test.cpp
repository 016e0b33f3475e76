// The boundary solution against tables of volumetric Monte Carlo, which shares no code with it:
// spheres and slabs. Rows: medium, size, light, expected exitances.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "boundary/bodies.h"
#include "boundary/dense_boundary.h"
#include "boundary/light_entering.h"

namespace opaline::test::boundary {
namespace {

struct SphereRow {
  const char* name;
  Channel medium;
  double radiusMm;
  std::array<double, 20> exitance;  ///< from the far side to the side of the light, irradiance 1
};

constexpr SphereRow sphereRows[] = {
    {"marble_red_large", {2.19, 0.0021, 1.5}, 25.54046, {0.000702, 0.0008364, 0.001139, 0.001392,
                                                         0.00186,  0.002569,  0.003531, 0.005356,
                                                         0.008685, 0.01608,   0.04116,  0.09976,
                                                         0.1794,   0.2666,    0.3572,   0.4439,
                                                         0.5312,   0.6145,    0.6945,   0.7732}},
    {"marble_red_small",
     {2.19, 0.0021, 1.5},
     8.51349,
     {0.01181, 0.01379, 0.01555, 0.0178, 0.02112, 0.02523, 0.03085, 0.03835, 0.04973, 0.06828,
      0.1013,  0.1545,  0.2192,  0.291,  0.3644,  0.4382,  0.5075,  0.5771,  0.6456,  0.7076}},
    {"marble_blue_large", {3.0, 0.0071, 1.5}, 11.86778, {0.001048, 0.001334, 0.001688, 0.00222,
                                                         0.00286,  0.003951, 0.005555, 0.008238,
                                                         0.01323,  0.02326,  0.05007,  0.104,
                                                         0.1758,   0.254,    0.3351,   0.4122,
                                                         0.4896,   0.5644,   0.636,    0.7066}},
    {"marble_blue_small",
     {3.0, 0.0071, 1.5},
     3.95593,
     {0.01934, 0.02158, 0.02487, 0.02846, 0.03323, 0.03915, 0.04688, 0.05724, 0.07195, 0.09226,
      0.124,   0.1706,  0.2255,  0.2846,  0.3452,  0.4038,  0.4616,  0.5179,  0.573,   0.6269}},
    {"skin1_red_large",
     {0.74, 0.032, 1.3},
     11.24596,
     {0.003168, 0.004174, 0.005553, 0.007235, 0.009613, 0.01297, 0.01751, 0.0244, 0.03449, 0.04984,
      0.07617,  0.1138,   0.1566,   0.1993,   0.241,    0.2817,  0.3199,  0.3551, 0.3897,  0.4199}},
    {"skin1_red_small", {0.74, 0.032, 1.3}, 3.74865, {0.07966, 0.08527, 0.08788, 0.09166, 0.09699,
                                                      0.1035,  0.1109,  0.1203,  0.1313,  0.1453,
                                                      0.1634,  0.1847,  0.206,   0.2267,  0.2475,
                                                      0.2664,  0.2827,  0.3003,  0.3156,  0.3294}},
};

struct SlabRow {
  const char* name;
  Channel medium;
  double thicknessMm;
  double halfWidths;  ///< of the slab that represents an infinite one, in thicknesses
  bool diffuse;       ///< diffuse light, else along the normal
  double reflected;
  double transmitted;
  double most;  ///< error of the light from the first collisions on
};

constexpr SlabRow slabRows[] = {
    {"marble_red_normal_0_1", {2.19, 0.0021, 1.5}, 0.85135, 8, false, 0.4306, 0.3784, 0.05},
    {"marble_red_normal_0_3", {2.19, 0.0021, 1.5}, 2.55405, 8, false, 0.6244, 0.3072, 0.05},
    {"marble_red_normal_1", {2.19, 0.0021, 1.5}, 8.51349, 4, false, 0.7722, 0.1118, 0.05},
    {"marble_red_diffuse_0_1", {2.19, 0.0021, 1.5}, 0.85135, 8, true, 0.4292, 0.3670, 0.05},
    {"marble_red_diffuse_0_3", {2.19, 0.0021, 1.5}, 2.55405, 8, true, 0.6005, 0.2823, 0.05},
    {"marble_red_diffuse_1", {2.19, 0.0021, 1.5}, 8.51349, 4, true, 0.7344, 0.1028, 0.05},
    {"marble_blue_normal_0_1", {3.0, 0.0071, 1.5}, 0.39559, 8, false, 0.3398, 0.3241, 0.05},
    {"marble_blue_normal_0_3", {3.0, 0.0071, 1.5}, 1.18678, 8, false, 0.5370, 0.3586, 0.05},
    {"marble_blue_normal_1", {3.0, 0.0071, 1.5}, 3.95593, 4, false, 0.6921, 0.1523, 0.05},
    {"marble_blue_diffuse_0_1", {3.0, 0.0071, 1.5}, 0.39559, 8, true, 0.3482, 0.3245, 0.05},
    {"marble_blue_diffuse_0_3", {3.0, 0.0071, 1.5}, 1.18678, 8, true, 0.5200, 0.3361, 0.05},
    {"marble_blue_diffuse_1", {3.0, 0.0071, 1.5}, 3.95593, 4, true, 0.6638, 0.1383, 0.05},
    {"skin1_red_normal_0_1", {0.74, 0.032, 1.3}, 0.37487, 16, false, 0.1097, 0.1086, 0.1},
    {"skin1_red_normal_0_3", {0.74, 0.032, 1.3}, 1.12460, 8, false, 0.2443, 0.2326, 0.1},
    {"skin1_red_normal_1", {0.74, 0.032, 1.3}, 3.74865, 4, false, 0.3947, 0.2405, 0.1},
    {"skin1_red_diffuse_0_1", {0.74, 0.032, 1.3}, 0.37487, 16, true, 0.1268, 0.1257, 0.1},
    {"skin1_red_diffuse_0_3", {0.74, 0.032, 1.3}, 1.12460, 8, true, 0.2631, 0.2489, 0.1},
    {"skin1_red_diffuse_1", {0.74, 0.032, 1.3}, 3.74865, 4, true, 0.3970, 0.2253, 0.1},
};

struct System {
  System(const ClusteredBody& of, const Channel& medium)
      : geometry(of.scene),
        clusters(clustersOf(geometry, of.clusterOfTriangle)),
        equation(clusters, medium, insideOf(clusters)) {}

  reference::Geometry geometry;
  TriangleClusters clusters;
  DenseBoundary equation;
};

void PrintTo(const SphereRow& row, std::ostream* to) {
  *to << row.name;
}
void PrintTo(const SlabRow& row, std::ostream* to) {
  *to << row.name;
}

template <typename Row>
std::string nameOf(const testing::TestParamInfo<Row>& row) {
  return row.param.name;
}

class SphereTable : public testing::TestWithParam<SphereRow> {};

// Error over twenty bands of equal area: L1 of their exitances, relative to the sum.
double bandError(const SphereRow& row, const TriangleClusters& clusters,
                 std::span<const double> exitance) {
  std::array<double, 20> flux{};
  std::array<double, 20> area{};
  for (std::size_t i = 0; i < clusters.count(); ++i) {
    const Vector& at = clusters.list[i].centroidMm;
    const double cosine = at[2] / reference::length(at);
    const auto band = static_cast<std::size_t>(std::clamp(10 * (cosine + 1), 0.0, 19.5));
    flux[band] += exitance[i] * clusters.list[i].areaMm2;
    area[band] += clusters.list[i].areaMm2;
  }
  double error = 0;
  double sum = 0;
  for (std::size_t band = 0; band < 20; ++band) {
    error += std::abs(flux[band] / area[band] - row.exitance[band]);
    sum += row.exitance[band];
  }
  return error / sum;
}

TEST_P(SphereTable, ExitanceOfBands) {
  const SphereRow& row = GetParam();
  const ClusteredBody body = sphere(row.radiusMm, 3);
  const System system(body, row.medium);
  const Vector toLight{0, 0, 1};
  const LightEntering light =
      lightEntering(system.geometry, system.clusters, row.medium.eta, toLight);
  const Diffusion& medium = system.equation.medium();
  const auto first = firstCollisions(system.geometry, light.places, medium, toLight);
  const auto second = secondCollisions(system.geometry, first, light.places, medium);
  const auto exits = singleExits(system.geometry, first, light.places, medium);
  constexpr double most = 0.05;
  EXPECT_LT(
      bandError(row, system.clusters, system.equation.solve(first, light.irradiance).exitance),
      most);
  EXPECT_LT(bandError(row, system.clusters,
                      system.equation.solveFromSecond(first, second, light.irradiance).exitance),
            most);
  EXPECT_LT(bandError(row, system.clusters,
                      system.equation.solveFromSecond(exits, second, light.irradiance).exitance),
            most);
}

INSTANTIATE_TEST_SUITE_P(Tables, SphereTable, testing::ValuesIn(sphereRows), nameOf<SphereRow>);

class SlabTable : public testing::TestWithParam<SlabRow> {};

TEST_P(SlabTable, ReflectedAndTransmitted) {
  const SlabRow& row = GetParam();
  constexpr int cells = 20;
  const double halfWidth = row.thicknessMm * row.halfWidths;
  const ClusteredBody body = slab(halfWidth, row.thicknessMm, cells);
  const System system(body, row.medium);
  const Diffusion& medium = system.equation.medium();
  std::vector<double> entering(system.clusters.count(), 0);
  std::fill_n(entering.begin(), cells * cells,
              row.diffuse ? medium.meanTransmittance : 1 - reflectanceOutside(medium.eta, 1));
  const auto first = row.diffuse
                         ? firstCollisionsOfDiffuse(system.geometry, system.clusters, medium)
                         : firstCollisions(system.geometry, system.clusters, medium, {0, 0, 1});
  const auto second = secondCollisions(system.geometry, first, system.clusters, medium);
  const auto exits = singleExits(system.geometry, first, system.clusters, medium);
  const auto error = [&](std::span<const double> exitance) {
    std::array<double, 2> sum{};
    double count = 0;
    for (std::size_t i = 0; i < cells * cells; ++i) {
      const Vector& at = system.clusters.list[i].centroidMm;
      if (std::max(std::abs(at[0]), std::abs(at[1])) > 0.25 * halfWidth) continue;
      sum[0] += exitance[i];
      sum[1] += exitance[cells * cells + i];
      ++count;
    }
    return (std::abs(sum[0] / count - row.reflected) + std::abs(sum[1] / count - row.transmitted)) /
           (row.reflected + row.transmitted);
  };
  EXPECT_LT(error(system.equation.solve(first, entering).exitance), row.most);
  EXPECT_LT(error(system.equation.solveFromSecond(exits, second, entering).exitance), 0.05);
}

INSTANTIATE_TEST_SUITE_P(Tables, SlabTable, testing::ValuesIn(slabRows), nameOf<SlabRow>);

}  // namespace
}  // namespace opaline::test::boundary
