// Properties of the boundary solution for any medium.

#include "boundary/dense_boundary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "boundary/bodies.h"
#include "boundary/light_entering.h"

namespace opaline::test::boundary {
namespace {

const Vector toLight{0, 0, 1};

double fluxOut(const TriangleClusters& clusters, std::span<const double> perArea) {
  double sum = 0;
  for (std::size_t i = 0; i < clusters.count(); ++i) sum += perArea[i] * clusters.list[i].areaMm2;
  return sum;
}

TEST(DenseBoundary, MomentsOfTheReflectance) {
  // d'Eon 2012 at η = 1.3; mean transmittances by quadrature.
  EXPECT_NEAR(Diffusion({1, 0.1, 1.3}).boundary, 2.3390, 0.01);
  EXPECT_NEAR(Diffusion({1, 0.1, 1.3}).meanTransmittance, 0.939, 1e-3);
  EXPECT_NEAR(Diffusion({1, 0.1, 1.5}).meanTransmittance, 0.908, 1e-3);
  EXPECT_NEAR(Diffusion({1, 0.1, 1.3}).slantCosine, 0.840, 5e-3);
  EXPECT_NEAR(Diffusion({1, 0.1, 1.5}).slantCosine, 0.885, 5e-3);
}

TEST(DenseBoundary, HalfOfSpaceIsInsideOfASphere) {
  const ClusteredBody body = sphere(5, 3);
  const reference::Geometry geometry(body.scene);
  const TriangleClusters clusters = clustersOf(geometry, body.clusterOfTriangle);
  for (const double inside : insideOf(clusters)) EXPECT_NEAR(inside, 0.5, 0.03);
}

TEST(DenseBoundary, SheetsCloserThanTheirClustersAreWide) {
  const ClusteredBody body = slab(20, 0.5, 16);
  const reference::Geometry geometry(body.scene);
  const TriangleClusters clusters = clustersOf(geometry, body.clusterOfTriangle);
  // The exact part is one half; a point's would be 3 and more, as it grows without bound.
  const std::vector<double> inside = insideOf(clusters);
  for (const double part : inside) {
    EXPECT_GT(part, 0);
    EXPECT_LT(part, 0.6);
  }
}

// A disc seen from its axis, and any cluster from far away.
TEST(DenseBoundary, CoverageOfADisc) {
  Cluster disc;
  disc.discRadiusMm = 1;
  disc.areaMm2 = 3.14159265358979;
  disc.vectorAreaMm2 = {0, 0, disc.areaMm2};
  for (const double height : {1e-3, 0.3, 1.0, 5.0})
    EXPECT_NEAR(coverage(disc, {0, 0, height}), (1 - height / std::hypot(height, 1)) / 2, 1e-12);
  EXPECT_NEAR(coverage(disc, {60, 0, 80}), 0.8 / (4 * 1e4), 1e-8);
  EXPECT_LT(coverage(disc, {0, 0, -2}), 0);
}

TEST(DenseBoundary, WithoutAbsorptionAllThatEntersLeaves) {
  const ClusteredBody body = sphere(6, 3);
  const reference::Geometry geometry(body.scene);
  const TriangleClusters clusters = clustersOf(geometry, body.clusterOfTriangle);
  const DenseBoundary equation(clusters, {2, 1e-9, 1.3}, insideOf(clusters));
  const LightEntering light = lightEntering(geometry, clusters, 1.3, toLight);
  const auto first = firstCollisions(geometry, light.places, equation.medium(), toLight);
  const double in = fluxOut(clusters, light.irradiance);
  EXPECT_NEAR(fluxOut(clusters, equation.solve(first, light.irradiance).exitance) / in, 1, 0.015);
  const auto second = secondCollisions(geometry, first, light.places, equation.medium());
  const auto exits = singleExits(geometry, first, light.places, equation.medium());
  const auto moved = equation.solveFromSecond(exits, second, light.irradiance);
  EXPECT_NEAR(fluxOut(clusters, moved.exitance) / in, 1, 0.015);
}

TEST(DenseBoundary, SecondCollisionsAndExitsShareTheFirst) {
  const ClusteredBody body = sphere(1.5, 2);
  const reference::Geometry geometry(body.scene);
  const TriangleClusters clusters = clustersOf(geometry, body.clusterOfTriangle);
  const Diffusion medium({1, 0.2, 1.3});
  const auto first = firstCollisionsOfDiffuse(geometry, clusters, medium);
  double before = 0;
  for (const LightPoint& point : first) before += point.weight;
  double after = 0;
  for (const LightPoint& point : secondCollisions(geometry, first, clusters, medium, 16))
    after += point.weight;
  for (const SingleExit& exit : singleExits(geometry, first, clusters, medium, 16))
    after += exit.share;
  EXPECT_NEAR(after / before, 1, 0.01);
}

/// Fluence at one place inside from a point of light of power 1 at another: Green's identity again,
/// with the values that are known on the surface by then.
double fluenceInside(const TriangleClusters& clusters, const DenseBoundary& equation,
                     const Vector& of, const Vector& at) {
  using namespace reference;
  const Diffusion& medium = equation.medium();
  const double sigma = medium.attenuationPerMm;
  const auto unbounded = [&](double r) {
    return std::exp(-sigma * r) / (4 * std::numbers::pi * medium.diffusionMm * r);
  };
  std::vector<double> entering(clusters.count(), 0);
  entering[0] = 1 / clusters.list[0].areaMm2;
  const std::vector<double> fluence =
      equation.solve({{.placeMm = of, .weight = 1}}, entering).fluence;
  double sum = unbounded(length(of - at));
  for (std::size_t j = 0; j < clusters.count(); ++j) {
    const Cluster& cluster = clusters.list[j];
    const Vector offset = cluster.centroidMm - at;
    const double r = length(offset);
    sum -= fluence[j] * (cluster.areaMm2 * unbounded(r) / (2 * medium.boundary) -
                         (1 + sigma * r) * std::exp(-sigma * r) * coverage(cluster, offset));
  }
  return sum;
}

// Diffusion with Robin's condition is its own adjoint: light goes both ways alike, though neither
// the sums nor their matrix are symmetric. Tested between a place below a ball's outside and one
// beside its hollow.
TEST(DenseBoundary, LightGoesThereAsBack) {
  const ClusteredBody body = hollowSphere(6, 3, 3);
  const reference::Geometry geometry(body.scene);
  const TriangleClusters clusters = clustersOf(geometry, body.clusterOfTriangle);
  const std::vector<double> inside = insideOf(clusters);
  const Vector outside{0, 1, 5};
  const Vector beside{3.8, 0, -0.5};
  for (const double sigmaAPerMm : {1e-6, 0.01, 0.1}) {
    const DenseBoundary equation(clusters, {2, sigmaAPerMm, 1.3}, inside);
    const double there = fluenceInside(clusters, equation, outside, beside);
    const double back = fluenceInside(clusters, equation, beside, outside);
    EXPECT_GT(there, 0);
    EXPECT_NEAR(back / there, 1, 0.015) << sigmaAPerMm;
  }
}

// On a sphere chords r have the area 2π r dr, and (x_j - x_i)·n_j = r²/(2R): both integrals are
// closed, and the fluence 1 everywhere gives their sum.
TEST(DenseBoundary, LeftSideOfASphere) {
  constexpr double radius = 3;
  const ClusteredBody body = sphere(radius, 2);
  const reference::Geometry geometry(body.scene);
  const TriangleClusters clusters = clustersOf(geometry, body.clusterOfTriangle);
  const DenseBoundary equation(clusters, {1, 0.05, 1.3}, insideOf(clusters));
  const Diffusion& medium = equation.medium();
  const double sigma = medium.attenuationPerMm;
  const double lost = std::exp(-2 * sigma * radius);
  const double expected = 0.5 - (2 - (2 + 2 * sigma * radius) * lost) / (4 * sigma * radius) +
                          (1 - lost) / (4 * medium.boundary * medium.diffusionMm * sigma);
  const std::vector<double> one(clusters.count(), 1);
  std::vector<double> left(clusters.count());
  equation.product(one, left);
  const double mean =
      std::accumulate(left.begin(), left.end(), 0.0) / static_cast<double>(left.size());
  EXPECT_NEAR(mean / expected, 1, 0.005);
}

// Light along the normal of a sheet: what is neither absorbed nor let out returns.
TEST(DenseBoundary, LightIsMirroredInside) {
  constexpr double thickness = 0.3;
  const ClusteredBody body = slab(3, thickness, 8);
  const reference::Geometry geometry(body.scene);
  const TriangleClusters clusters = clustersOf(geometry, body.clusterOfTriangle);
  const Diffusion medium({0.9, 0.1, 1.5});
  double taken = 0;
  for (const LightPoint& point : firstCollisions(geometry, clusters, medium, toLight))
    if (point.cluster == 0) taken += point.weight;
  // Rays start slightly off the surface.
  const double back = 0.04 * std::exp(-thickness);  // ((η-1)/(η+1))² = 0.04
  EXPECT_NEAR(taken, (1 - std::exp(-thickness)) * (1 + back), 4 * geometry.offsetMm());
}

TEST(DenseBoundary, SolvesItsEquation) {
  const ClusteredBody body = sphere(4, 2);
  const reference::Geometry geometry(body.scene);
  const TriangleClusters clusters = clustersOf(geometry, body.clusterOfTriangle);
  const DenseBoundary equation(clusters, {1, 0.05, 1.5}, insideOf(clusters));
  const LightEntering light = lightEntering(geometry, clusters, 1.5, toLight);
  const auto solution = equation.solve(
      firstCollisions(geometry, light.places, equation.medium(), toLight), light.irradiance);
  std::vector<double> left(clusters.count());
  equation.product(solution.fluence, left);
  for (std::size_t i = 0; i < left.size(); ++i)
    EXPECT_NEAR(left[i], solution.source[i], 1e-6 * std::abs(solution.source[i]) + 1e-7);
  EXPECT_LT(solution.residuals.size(), 20U);
}

}  // namespace
}  // namespace opaline::test::boundary
