// Boundary transport against a direct solution of the same equations for every pair of clusters, in
// double precision with exact rays. Each cluster is four subdivisions of one triangle.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "boundary/clusters.h"
#include "boundary/dense_boundary.h"
#include "boundary/light_entering.h"
#include "renderer/boundary_fixture.h"

namespace opaline {
namespace {

using namespace test;

using BoundaryDenseTest = RendererTest;

/// Scatters much more than it absorbs, so that the first collisions are the source. Clusters are
/// about a mean free path wide.
Medium thinMilk() {
  return {"thin milk", {0.8, 0.6, 0.4}, {0.003, 0.002, 0.001}, 1.3};
}

Scene densePeanut() {
  Scene scene = sceneOf(peanut(24, 4), thinMilk(), {20, 12, 44}, 12.5F);
  scene.lighting.directional = {{toVec3(unit({-0.6, 0.5, 0.4})), {1, 1, 1}}};
  return scene;
}

reference::Scene referenceOf(const Scene& scene) {
  reference::Body body;
  const Mesh& mesh = scene.objects[0].mesh;
  for (const Vec3& position : mesh.positionsMm) body.positionsMm.push_back(toVector(position));
  for (const Vec3& normal : mesh.normals) body.normals.push_back(toVector(normal));
  body.triangles = mesh.triangles;
  body.medium = scene.objects[0].medium;
  reference::Scene result;
  result.bodies.push_back(std::move(body));
  result.lighting = scene.lighting;
  result.camera = scene.camera;
  return result;
}

/// Root mean square error over the visible clusters, at the pixels nearest to their middles,
/// relative to their mean.
double errorOfClusters(const RenderResult& found, const boundary::TriangleClusters& clusters,
                       const std::vector<double>& exitance, std::size_t channel) {
  std::vector<double> sum(clusters.count());
  std::vector<int> pixels(clusters.count());
  forEachCovered(found.images[0], [&](std::size_t i) {
    const Vector at = toVector(&found.images[1].rgba[i]);
    std::size_t nearest = 0;
    for (std::size_t k = 1; k < clusters.count(); ++k)
      if (length(clusters.list[k].centroidMm - at) < length(clusters.list[nearest].centroidMm - at))
        nearest = k;
    sum[nearest] += static_cast<double>(found.images[0].rgba[i + channel]);
    ++pixels[nearest];
  });
  double squares = 0;
  double mean = 0;
  int seen = 0;
  for (std::size_t k = 0; k < clusters.count(); ++k) {
    if (pixels[k] < 4) continue;
    ++seen;
    mean += exitance[k];
    squares += std::pow(sum[k] / pixels[k] - exitance[k], 2);
  }
  EXPECT_GT(seen, 200);
  return std::sqrt(squares * seen) / mean;
}

TEST_F(BoundaryDenseTest, EveryPairSaysTheSame) {
  const Scene scene = densePeanut();
  const reference::Scene body = referenceOf(scene);
  const reference::Geometry geometry(body);
  std::vector<std::uint32_t> own(scene.objects[0].mesh.triangles.size());
  for (std::uint32_t t = 0; t < own.size(); ++t) own[t] = t / 4;
  const boundary::TriangleClusters clusters = boundary::clustersOf(geometry, own);
  const std::vector<double> inside = boundary::insideOf(clusters);
  const Vector toLight = toVector(scene.lighting.directional[0].directionToLight);
  const boundary::LightEntering light =
      boundary::lightEntering(geometry, clusters, thinMilk().eta, toLight);
  const RenderResult found =
      renderBoundary(scene, boundaryOptions(96), {Aov::Exitance, Aov::Position});
  for (std::size_t c = 0; c < 3; ++c) {
    const boundary::DenseBoundary equation(
        clusters, {thinMilk().sigmaSPrimePerMm[c], thinMilk().sigmaAPerMm[c], thinMilk().eta},
        inside);
    const auto first =
        boundary::firstCollisions(geometry, light.places, equation.medium(), toLight);
    const std::vector<double> exitance = equation.solve(first, light.irradiance).exitance;
    const double error = errorOfClusters(found, clusters, exitance, c);
    RecordProperty("channel_" + std::to_string(c), std::to_string(error));
    EXPECT_LT(error, 0.02) << c;
  }
}

}  // namespace
}  // namespace opaline
