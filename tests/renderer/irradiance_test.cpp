// The light that surfels have gathered, as the camera sees it, against Lambert's cosine law,
// Fresnel's transmittance and the geometry of shadows.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "bssrdf/fresnel.h"
#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"

namespace opaline {
namespace {

using namespace test;

using std::numbers::pi;

double entering(double cosine) {
  return cosine > 0 ? cosine * (1 - bssrdf::fresnelReflectance(1.5, cosine)) : 0;
}

struct Method {
  const char* name;
  Transport transport;
  Sum sum;
  Site site;
};

class IrradianceTest : public RendererTestBase<testing::TestWithParam<Method>> {
 protected:
  static RenderOptions options() {
    RenderOptions options = smallOptions();
    options.transport = GetParam().transport;
    options.sum = GetParam().sum;
    options.site = GetParam().site;
    options.width = options.height = 96;
    return options;
  }
};

INSTANTIATE_TEST_SUITE_P(
    Methods, IrradianceTest,
    testing::Values(Method{"Boundary", Transport::Boundary, Sum::Tree, Site::Fragment},
                    Method{"BoundaryAtVertices", Transport::Boundary, Sum::Tree, Site::Vertex},
                    Method{"Tree", Transport::BetterDipole, Sum::Tree, Site::Fragment},
                    Method{"All", Transport::Dipole, Sum::All, Site::Vertex}),
    [](const auto& method) { return std::string(method.param.name); });

double longestEdge(const Mesh& mesh) {
  double longest = 0;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      longest = std::max(longest, length(toVector(mesh.positionsMm[t[i]]) -
                                         toVector(mesh.positionsMm[t[(i + 1) % 3]])));
  return longest;
}

// A surfel of the ball lies in one triangle. Its mean must thus be a value that the closed form has
// within an edge's length of the pixel.
TEST_P(IrradianceTest, ABallFollowsTheCosineToItsLamp) {
  constexpr double radiusMm = 5;
  const Mesh ball = sphere({0, 0, 0}, static_cast<float>(radiusMm), 4);
  Scene scene = sceneOf(ball, marble(), {0, 0, 20}, 5.25F);
  const Vector toLight = unit({1, 1, 2});
  scene.lighting.directional = {{toVec3(toLight), {3, 2, 1}}};
  renderer().setScene(scene);
  const RenderResult result = renderer().render(options(), {Aov::Position, Aov::Irradiance});
  ASSERT_GE(result.report.sources, result.report.triangles);
  const Image& irradiance = result.images[1];
  const double reach = longestEdge(ball) / radiusMm;  // as an angle
  int lit = 0;
  double sum = 0;
  double sumExpected = 0;
  forEachCovered(irradiance, [&](std::size_t i) {
    const double angle = std::acos(dot(unit(toVector(&result.images[0].rgba[i])), toLight));
    const auto red = static_cast<double>(irradiance.rgba[i]);
    if (angle > pi / 2 + reach) {
      ASSERT_EQ(red, 0);
    }
    if (angle > 1.4) return;  // the terminator, softened by the shadow map's texels
    ++lit;
    sum += red;
    sumExpected += 3 * entering(std::cos(angle));
    ASSERT_LE(red, 3.003 * entering(std::cos(std::max(angle - reach, 0.0))));
    ASSERT_GE(red, 2.997 * entering(std::cos(angle + reach)));
    ASSERT_NEAR(static_cast<double>(irradiance.rgba[i + 1]) * 3, 2 * red, 1e-5);
    ASSERT_NEAR(static_cast<double>(irradiance.rgba[i + 2]) * 3, red, 1e-5);
  });
  EXPECT_GT(lit, 2000);
  EXPECT_NEAR(sum / sumExpected, 1, 0.003);
}

TEST_P(IrradianceTest, AFaceHasTheSameEverywhere) {
  Scene scene = sceneOf(box({0, 0, 0}, {5, 5, 5}), marble(), {0, 0, 30}, 4);
  const Vector toLight = unit({1, 0, 1});
  scene.lighting.directional = {{toVec3(toLight), {2, 2, 2}}};
  const Image irradiance = render(scene, options(), {Aov::Irradiance})[0];
  const int covered = forEachCovered(irradiance, [&](std::size_t i) {
    ASSERT_NEAR(static_cast<double>(irradiance.rgba[i]) / (2 * entering(toLight[2])), 1, 1e-4);
  });
  EXPECT_EQ(covered, 96 * 96);
}

TEST_P(IrradianceTest, UniformLightGivesPiTimesMeanTransmittance) {
  Scene scene = sceneOf(sphere({0, 0, 0}, 5, 4), marble(), {0, 0, 20}, 5.25F);
  scene.lighting.ambient = {1, 2, 0.5F};
  const Image irradiance = render(scene, options(), {Aov::Irradiance})[0];
  const double expected = pi * bssrdf::meanTransmittance(1.5);
  const int covered = forEachCovered(irradiance, [&](std::size_t i) {
    for (const auto& [channel, factor] : {std::pair(0U, 1.0), {1U, 2.0}, {2U, 0.5}})
      ASSERT_NEAR(static_cast<double>(irradiance.rgba[i + channel]) / expected / factor, 1, 0.002);
  });
  EXPECT_GT(covered, 2000);
}

// A plate over a lit floor. Light that leaves floor or plate and enters again does not count, so
// places that see no lamp are black.
TEST_P(IrradianceTest, AShadowIsBlackInside) {
  const Mesh floor = box({0, -2, 0}, {20, 2, 20}, 32);
  Scene scene = sceneOf(floor, marble(), {-60, 70, 0}, 30);
  scene.objects.push_back({"plate", box({0, 10, 0}, {9, 0.5F, 9}, 8), marble()});
  const Vector toLight = unit({0.5, 1, 0});
  scene.lighting.directional = {{toVec3(toLight), {2, 2, 2}}};
  RenderOptions wanted = finelyDivided(options());
  wanted.bounces = 2;
  const auto images = render(scene, wanted, {Aov::Position, Aov::Irradiance});
  // On one side the shadow is cast by the plate's lower edge, 9.5 mm up, on the other by its upper
  // edge, 10.5 mm up.
  const auto outside = [](const Vector& p) {
    return std::max({-9 - 0.5 * 10.5 - p[0], p[0] - 9 + 0.5 * 9.5, std::abs(p[2]) - 9});
  };
  const double texelMm = 60.0 / wanted.shadowSize / toLight[1];
  const double margin = 2.5 * texelMm + longestEdge(floor);
  int dark = 0;
  int lit = 0;
  forEachCovered(images[1], [&](std::size_t i) {
    const Vector place = toVector(&images[0].rgba[i]);
    if (std::abs(place[1]) > 1e-3) return;  // not the floor
    const auto value = static_cast<double>(images[1].rgba[i]);
    if (outside(place) < -margin) {
      ++dark;
      ASSERT_EQ(value, 0) << place[0] << ' ' << place[2];
    } else if (outside(place) > margin) {
      ++lit;
      ASSERT_NEAR(value / (2 * entering(toLight[1])), 1, 0.002) << place[0] << ' ' << place[2];
    }
  });
  EXPECT_GT(dark, 50);
  EXPECT_GT(lit, 1000);
}

// Whether it is rendered alone, with the picture, or from light that an earlier frame found.
TEST_P(IrradianceTest, IsTheSameHoweverItIsAskedFor) {
  Scene scene = sceneOf(sphere({0, 0, 0}, 5, 4), marble(), {0, 0, 20}, 5.25F);
  scene.lighting.directional = {{{1, 1, 2}, {3, 2, 1}}};
  const Image alone = render(scene, options(), {Aov::Irradiance})[0];
  View view(renderer(), options());
  const auto with = view.render({.aovs = {Aov::Radiance, Aov::Irradiance}}).images;
  EXPECT_EQ(with[1].rgba, alone.rgba);
  // A frame of another size, whose surfels are lit by other shadow maps.
  RenderOptions other = options();
  other.width = 48;
  other.shadowSize = 64;
  for (const Aov between : {Aov::Irradiance, Aov::Radiance}) {
    render(other, {between});
    const auto images =
        view.render({.aovs = {Aov::Radiance, Aov::Irradiance}, .reuseLight = true}).images;
    EXPECT_EQ(images[0].rgba, with[0].rgba);
    EXPECT_EQ(images[1].rgba, alone.rgba);
  }
}

TEST_P(IrradianceTest, MakesNoMap) {
  Scene scene = sceneOf(sphere({0, 0, 0}, 5, 3), marble(), {0, 0, 20}, 5.25F);
  scene.lighting.ambient = {1, 1, 1};
  const auto passesOf = [&](std::vector<Aov> aovs) {
    std::vector<std::string> names;
    for (const PassTime& pass : renderer().render(options(), aovs).report.passes)
      names.push_back(pass.name);
    return names;
  };
  renderer().setScene(scene);
  const auto has = [](const std::vector<std::string>& names, const char* name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  EXPECT_FALSE(has(passesOf({Aov::Irradiance}), "neighbours"));
  EXPECT_TRUE(has(passesOf({Aov::DsmIrradiance}), "neighbours"));
}

}  // namespace
}  // namespace opaline
