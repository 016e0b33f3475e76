// Bodies for which boundary transport cannot be right, or hardly so. Its result must be finite and
// not too bright, and it must not be used where there is no inside.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <ostream>
#include <string>
#include <utility>

#include "renderer/boundary_fixture.h"

namespace opaline {
namespace {

using namespace test;

using BoundaryAwkwardTest = RendererTest;

void light(Scene& scene) {
  constexpr auto pi = std::numbers::pi_v<float>;
  scene.lighting.directional = {{toVec3(unit({0.45, 0.35, 0.82})), {pi, pi, pi}}};
}

// Boundary transport has no inside to solve in.
TEST_F(BoundaryAwkwardTest, AnOpenSheetIsABetterDipole) {
  Scene scene = sceneOf(sheet({0, 0, 0}, {8, 0, 0}, {0, 8, 0}), marble(), {0, 10, 40}, 12);
  light(scene);
  for (const Site site : {Site::Fragment, Site::Vertex}) {
    RenderOptions options = boundaryOptions(48, 2);
    options.site = site;
    const RenderResult asked = renderBoundary(scene, options, {Aov::Exitance});
    EXPECT_EQ(asked.report.transport, Transport::BetterDipole);
    EXPECT_EQ(asked.report.clusters, 0U);
    const Image& boundary = asked.images[0];
    options.transport = Transport::BetterDipole;
    const Image dipole = renderBoundary(scene, options, {Aov::Exitance}).images[0];
    EXPECT_GT(meanOf(dipole)[0], 0.1);
    EXPECT_EQ(boundary.rgba, dipole.rgba);
  }
}

// A block bent until it lies in itself. Where its surface is inside out, the solution has no
// meaning; but light that enters again and again may not grow without end. Each of the five times
// it adds no more than all there is.
TEST_F(BoundaryAwkwardTest, ABlockBentIntoItselfDoesNotGlow) {
  const Medium thin{"thin", {0.082F, 0.116F, 0.067F}, {0.0044F, 0.00026F, 0.0015F}, 1.1};
  Scene scene = sceneOf(box({0, 0, 0}, {10, 5, 5}, 4), thin, {0, 8, 60}, 20);
  scene.deformers = {{DeformerKind::Bend, 1.83F, 0}};
  constexpr auto unitFlux = std::numbers::inv_pi_v<float>;
  scene.lighting.ambient = {unitFlux, unitFlux, unitFlux};
  const Image found = renderBoundary(scene, boundaryOptions(32, 4), {Aov::Exitance}).images[0];
  float most = 0;
  forEachCovered(found, [&](std::size_t i) {
    for (std::size_t c = 0; c < 3; ++c) most = std::max(most, found.rgba[i + c]);
  });
  EXPECT_GT(most, 0.5);
  EXPECT_LT(most, 5);
}

// Six square faces of two triangles each, hundreds of mean free paths wide, brightly lit from
// behind. The far side is in even light and acts as a half-space, whatever the shapes of its
// clusters. Its reflectance is in the project's table slab_mc.csv, "inf", diffuse, marble red and
// blue.
TEST_F(BoundaryAwkwardTest, ALargeCoarseRodIsEven) {
  constexpr double halfWidthMm = 70;
  const std::map<std::size_t, double> reflected{{0, 0.7656}, {2, 0.6971}};
  Scene scene = sceneOf(box({0, 0, 0}, {70, 350, 70}, 1), marble(), {0, 0, 1400}, 360);
  constexpr auto unitFlux = std::numbers::inv_pi_v<float>;
  scene.lighting.ambient = {unitFlux, unitFlux, unitFlux};
  scene.lighting.directional = {{toVec3(unit({0.45, 0.35, -0.82})), {3, 3, 3}}};
  const RenderResult result =
      renderBoundary(scene, boundaryOptions(64), {Aov::Exitance, Aov::Position});
  EXPECT_LE(result.report.solutions[0].steps, 5);
  const int count = forEachCovered(result.images[0], [&](std::size_t i) {
    const Vector at = toVector(&result.images[1].rgba[i]);
    // Light from around the edges fades within some diffusion lengths.
    if (std::max(std::abs(at[0]), std::abs(at[1]) - 280) > halfWidthMm - 40) return;
    for (const auto& [c, part] : reflected)
      EXPECT_NEAR(static_cast<double>(result.images[0].rgba[i + c]) / part, 1, 0.15)
          << at[0] << ", " << at[1] << " channel " << c;
  });
  EXPECT_GT(count, 200);
}

struct AwkwardCase {
  std::string name;
  std::function<Mesh()> mesh;
  double brightest = 1;  ///< relative to what may enter; more where surfaces overlap
};

void PrintTo(const AwkwardCase& awkward, std::ostream* to) {
  *to << awkward.name;
}

Mesh insideOut(Mesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  for (Vec3& normal : mesh.normals) normal = toVec3(-1.0 * toVector(normal));
  return mesh;
}

Mesh withDegenerateTriangles() {
  Mesh mesh = sphere({0, 0, 0}, 5, 3);
  const auto at = static_cast<std::uint32_t>(mesh.positionsMm.size());
  mesh.positionsMm.insert(mesh.positionsMm.end(), {{5, 0, 0}, {6, 0, 0}, {7, 0, 0}});
  mesh.normals.insert(mesh.normals.end(), 3, Vec3{0, 1, 0});
  mesh.triangles.push_back({at, at + 1, at + 2});  // no area
  mesh.triangles.push_back({at, at, at});
  mesh.triangles.push_back({0, 0, 1});
  return mesh;
}

Mesh oneTriangle() {
  Mesh mesh;
  mesh.positionsMm = {{-4, -4, 0}, {4, -4, 0}, {0, 4, 0}};
  mesh.normals.assign(3, {0, 0, 1});
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

Mesh tinyComponents() {
  Mesh mesh;
  for (int i = 0; i < 10; ++i) {
    const double angle = 2 * std::numbers::pi * i / 10;
    mesh = together(mesh, sphere(toVec3({4 * std::cos(angle), 4 * std::sin(angle), 0}), 0.4F, 0));
  }
  return mesh;
}

class BoundaryAwkwardBodyTest : public RendererTestBase<testing::TestWithParam<AwkwardCase>> {};

// No more light can leave than entered, but one place may receive light from its surroundings.
TEST_P(BoundaryAwkwardBodyTest, IsFiniteAndNotTooBright) {
  Scene scene = sceneOf(GetParam().mesh(), marble(), {0, 5, 40}, 8);
  light(scene);
  scene.lighting.ambient = {0.1F, 0.1F, 0.1F};
  const double entering = std::numbers::pi * 1.1;
  for (const Site site : {Site::Fragment, Site::Vertex}) {
    RenderOptions options = boundaryOptions(48, 2);
    options.site = site;
    const RenderResult result = renderBoundary(scene, options, {Aov::Exitance, Aov::Radiance});
    for (const Image& image : result.images)
      for (const float value : image.rgba) ASSERT_TRUE(std::isfinite(value));
    int count = forEachCovered(result.images[0], [&](std::size_t i) {
      for (std::size_t c = 0; c < 3; ++c) {
        ASSERT_GE(result.images[0].rgba[i + c], 0);
        ASSERT_LT(static_cast<double>(result.images[0].rgba[i + c]),
                  GetParam().brightest * entering);
      }
    });
    EXPECT_GE(count, 1);
    for (const Solution& solution : result.report.solutions) {
      EXPECT_LE(solution.steps, 8);
      for (const float residual : solution.residual) {
        EXPECT_TRUE(std::isfinite(residual));
        EXPECT_LE(residual, 1);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Bodies, BoundaryAwkwardBodyTest,
    testing::Values(
        AwkwardCase{"self_intersecting",
                    [] {
                      return together(sphere({-2, 0, 0}, 4, 3), sphere({2, 0, 0}, 4, 3));
                    }},
        AwkwardCase{"coincident",
                    [] {
                      return together(sphere({0, 0, 0}, 5, 3), sphere({0, 0, 0}, 5, 3));
                    }},
        AwkwardCase{"nearly_coincident",
                    [] {
                      return together(sphere({0, 0, 0}, 5, 3), sphere({0, 0, 0}, 4.999F, 3));
                    }},
        AwkwardCase{"degenerate", withDegenerateTriangles},
        AwkwardCase{"one_triangle", oneTriangle}, AwkwardCase{"tiny_components", tinyComponents},
        AwkwardCase{"inside_out",
                    [] {
                      return insideOut(sphere({0, 0, 0}, 5, 3));
                    }},
        AwkwardCase{"ball_in_a_ball",
                    [] {
                      return together(sphere({0, 0, 0}, 5, 3), sphere({0, 0, 0}, 2, 3));
                    }},
        AwkwardCase{
            "ball_and_sheet",
            [] {
              return together(sphere({0, 0, 0}, 4, 3), sheet({0, 0, -5}, {6, 0, 0}, {0, 6, 0}));
            }},
        AwkwardCase{"half_a_ball",
                    [] {
                      Mesh mesh = sphere({0, 0, 0}, 5, 3);
                      std::erase_if(mesh.triangles, [&](const Triangle& corners) {
                        return mesh.positionsMm[corners[0]][1] > 0;
                      });
                      return mesh;
                    }},
        AwkwardCase{"thin_as_paper",
                    [] {
                      return box({0, 0, 0}, {5, 5, 0.005F}, 8);
                    }},
        AwkwardCase{"needle",
                    [] {
                      return box({0, 0, 0}, {7, 0.2F, 0.2F}, 8);
                    }}),
    [](const auto& awkward) { return awkward.param.name; });

}  // namespace
}  // namespace opaline
