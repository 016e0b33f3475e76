// Light that gets through a body without being scattered enters what lies behind it, and lights
// opaque surfaces there. The bodies in the way absorb and hardly scatter, so nothing else comes
// from them. The expected values are Fresnel's and Beer's laws.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

#include "bssrdf/fresnel.h"
#include "renderer/boundary_fixture.h"

namespace opaline {
namespace {

using namespace test;

using BoundaryThroughTest = RendererTest;

constexpr double litRadiusMm = 3;
constexpr double degree = std::numbers::pi / 180;

Medium milky() {
  return {"milky", {2, 2, 2}, {0.01F, 0.01F, 0.01F}, 1.3F};
}

Medium grey(float eta = 1.4F) {
  return {"grey", {1e-4F, 1e-4F, 1e-4F}, {0.2F, 0.5F, 1.2F}, eta};
}

/// What gets through a wall of grey.
double through(std::size_t channel, double thicknessMm, double cosine, double eta = 1.4) {
  const double inside = std::sqrt(1 - (1 - cosine * cosine) / (eta * eta));
  const double entering = 1 - bssrdf::fresnelReflectance(eta, cosine);
  return entering * entering * std::exp(-grey().sigmaAPerMm[channel] * thicknessMm / inside);
}

std::array<double, 3> exitanceOfBall(const Scene& scene) {
  const RenderResult result =
      renderBoundary(scene, boundaryOptions(64, 1), {Aov::Exitance, Aov::Position});
  return meanWhere(result.images[0], result.images[1],
                   [](const Vector& at) { return length(at) < 1.01 * litRadiusMm; });
}

Scene ball() {
  return sceneOf(sphere({0, 0, 0}, static_cast<float>(litRadiusMm), 4), milky(), {0, -16, 4}, 4);
}

TEST_F(BoundaryThroughTest, LightThroughAWallFollowsFresnelAndBeer) {
  for (const double angle : {0.0, 45.0, 65.0}) {
    const auto [sine, cosine] = std::pair(std::sin(angle * degree), std::cos(angle * degree));
    Scene scene = ball();
    scene.lighting.directional = {
        {{static_cast<float>(sine), 0, static_cast<float>(cosine)}, {1, 1, 1}}};
    const std::array<double, 3> open = exitanceOfBall(scene);
    scene.objects.push_back({"wall", box({0, 0, 8}, {40, 40, 0.5F}, 20), grey()});
    const std::array<double, 3> behind = exitanceOfBall(scene);
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(behind[c] / open[c], through(c, 1, cosine), 0.01) << angle << ' ' << c;
  }
}

TEST_F(BoundaryThroughTest, AnAreaLightThroughAWallIsAsStrong) {
  Scene scene = ball();
  SphereLight lamp;
  lamp.centreMm = {0, 0, 300};
  lamp.radiusMm = 4;
  lamp.radiance = {1e4F, 1e4F, 1e4F};
  scene.lighting.areas = {lamp};
  const std::array<double, 3> open = exitanceOfBall(scene);
  scene.objects.push_back({"wall", box({0, 0, 8}, {40, 40, 0.5F}, 20), grey()});
  const std::array<double, 3> behind = exitanceOfBall(scene);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(behind[c] / open[c], through(c, 1, 1), 0.01) << c;
}

/// A dark opaque sheet below the wall, which gives back little that the wall could mirror.
Scene floorSheet() {
  Scene scene = sceneOf(sheet({0, 0, 0}, {16, 0, 0}, {0, 16, 0}, 16), milky(), {0, -16, 4}, 5);
  scene.objects[0].opaque = mattMaterial({0.03F, 0.03F, 0.03F});
  return scene;
}

/// How much less of a scene's light a floor gives back with the wall above it than without.
std::array<double, 3> shareAtFloor(Scene scene, Site site, double cameraZ = 4) {
  RenderOptions options = boundaryOptions(64, 1);
  options.site = site;
  const auto given = [&] {
    const RenderResult result = renderBoundary(scene, options, {Aov::Exitance, Aov::Position});
    return meanWhere(result.images[0], result.images[1],
                     [](const Vector& at) { return length(at) < 2; });
  };
  scene.camera.positionMm[2] = static_cast<float>(cameraZ);
  const std::array<double, 3> open = given();
  scene.objects.push_back({"wall", box({0, 0, 8}, {40, 40, 0.5F}, 20), grey()});
  std::array<double, 3> share = given();
  for (std::size_t c = 0; c < 3; ++c) share[c] /= open[c];
  return share;
}

TEST_F(BoundaryThroughTest, AFloorBehindAWallHasTheLightOfFresnelAndBeer) {
  for (const double angle : {0.0, 45.0, 65.0}) {
    const auto [sine, cosine] = std::pair(std::sin(angle * degree), std::cos(angle * degree));
    Scene scene = floorSheet();
    scene.lighting.directional = {
        {{static_cast<float>(sine), 0, static_cast<float>(cosine)}, {1, 1, 1}}};
    const std::array<double, 3> share =
        shareAtFloor(scene, angle == 45 ? Site::Vertex : Site::Fragment);
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(share[c], through(c, 1, cosine), 0.01) << angle << ' ' << c;
  }
}

// From the height of the lamp its edge is seen at 4 degrees.
TEST_F(BoundaryThroughTest, AFloorBehindAWallHasTheLightOfAnAreaLight) {
  Scene scene = floorSheet();
  scene.lighting.areas = {DiscLight{{0, 0, 140}, {0, 0, -1}, 10, {1000, 1000, 1000}}};
  for (const Site site : {Site::Fragment, Site::Vertex}) {
    const std::array<double, 3> share = shareAtFloor(scene, site);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(share[c], through(c, 1, 1), 0.01) << c;
  }
}

// A leaf is seen from below. Its upper side is lit through the wall.
TEST_F(BoundaryThroughTest, ALeafBehindAWallShinesOnItsOtherSide) {
  for (const bool area : {false, true}) {
    Scene scene = floorSheet();
    scene.objects[0].opaque->diffuseTransmission = 1;
    scene.objects[0].opaque->diffuseTransmissionColor = {0.03F, 0.03F, 0.03F};
    if (area)
      scene.lighting.areas = {DiscLight{{0, 0, 140}, {0, 0, -1}, 10, {1000, 1000, 1000}}};
    else
      scene.lighting.directional = {{{0, 0, 1}, {1, 1, 1}}};
    const std::array<double, 3> share = shareAtFloor(scene, Site::Fragment, -10);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(share[c], through(c, 1, 1), 0.01) << c;
  }
}

Mesh shell(float radiusMm, float wallMm) {
  Mesh inner = sphere({0, 0, 0}, radiusMm - wallMm, 4);
  for (Triangle& triangle : inner.triangles) std::swap(triangle[1], triangle[2]);
  for (Vec3& normal : inner.normals) normal = {-normal[0], -normal[1], -normal[2]};
  return together(sphere({0, 0, 0}, radiusMm, 4), inner);
}

// The index is low, so that the shell mirrors none of the ball's own light.
TEST_F(BoundaryThroughTest, TheSkyThroughAShellFollowsFresnelAndBeer) {
  Scene scene = ball();
  scene.lighting.ambient = {1, 1, 1};
  const std::array<double, 3> open = exitanceOfBall(scene);
  scene.objects.push_back({"shell", shell(60, 1), grey(1.02F)});
  const std::array<double, 3> within = exitanceOfBall(scene);
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(within[c] / open[c], through(c, 1, 1, 1.02), 0.01) << c;
}

// Seen from outside and from its middle. The expected values are those of `opaline reference --path
// --aov exitance` of a finer mesh, within 1 %.
TEST_F(BoundaryThroughTest, AThinHollowBallInEvenLightIsThatOfPathTracing) {
  Scene scene = sceneOf(shell(10, 0.7F), *findMedium("gummy-orange"), {0, 0, 40}, 11);
  scene.lighting.ambient = {1, 1, 1};
  const std::array<std::array<double, 3>, 2> expected{
      {{1.274, 1.076, 0.606}, {1.134, 0.952, 0.544}}};
  for (const bool within : {false, true}) {
    if (within) {
      scene.camera.positionMm = {0, 0, 0.01F};
      scene.camera.targetMm = {0, 0, 5};
      scene.camera.verticalFovDegrees = 90;
    }
    const RenderResult result =
        renderBoundary(scene, boundaryOptions(64, 2), {Aov::Exitance, Aov::Position});
    const std::array<double, 3> mean =
        meanWhere(result.images[0], result.images[1], [](const Vector&) { return true; });
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(mean[c] / expected.at(within)[c], 1, 0.09) << within << ' ' << c;
  }
}

constexpr double floorMm = 160;  // edge of a lit floor along x, from 0
constexpr double screenMm = 6;   // from there to a screen that faces it
constexpr double heightMm = 20;  // of the screen's middle above the floor

// How much of a floor's light gets to the screen through the wall, by a sum over directions.
double throughFromFloor(std::size_t channel) {
  double all = 0;
  double left = 0;
  constexpr int steps = 400;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const double squared = (i + 0.5) / steps;  // of the sine to the screen's normal
      const double angle = (j + 0.5) / steps * std::numbers::pi;
      const double cosine = std::sqrt(1 - squared);
      const double down = std::sqrt(squared) * std::sin(angle);
      const double where = heightMm * cosine / down - screenMm;
      if (where < 0 || where > floorMm) continue;
      all += 1;
      left += through(channel, 0.5, cosine, 1.02);
    }
  return left / all;
}

// The light is parallel to the wall and the screen, so the screen has the floor's light alone.
TEST_F(BoundaryThroughTest, TheLightOfAFloorThroughAWallFollowsFresnelAndBeer) {
  constexpr auto far = static_cast<float>(floorMm);
  constexpr auto high = static_cast<float>(heightMm);
  constexpr auto away = static_cast<float>(-screenMm);
  Scene scene =
      sceneOf(sheet({far / 2, 0, 0}, {far / 2, 0, 0}, {0, 150, 0}, 20), milky(), {-3, 0, high}, 5);
  scene.objects[0].opaque = mattMaterial({0.8F, 0.8F, 0.8F});
  Object screen{"screen", sheet({away, 0, high}, {0, 4, 0}, {0, 0, 4}, 8), milky()};
  screen.opaque = mattMaterial({0.03F, 0.03F, 0.03F});
  scene.objects.push_back(screen);
  scene.camera.targetMm = {away, 0, high};
  scene.camera.verticalFovDegrees = 80;
  scene.lighting.directional = {{{0, 0, 1}, {1, 1, 1}}};
  const auto given = [&] {
    const RenderResult result =
        renderBoundary(scene, boundaryOptions(64, 1), {Aov::Exitance, Aov::Position});
    return meanWhere(result.images[0], result.images[1],
                     [](const Vector& at) { return std::abs(at[0] + screenMm) < 0.1; });
  };
  const std::array<double, 3> open = given();
  scene.objects.push_back({"wall", box({-1, 0, high}, {0.25F, 150, high}, 20), grey(1.02F)});
  const std::array<double, 3> behind = given();
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(behind[c] / open[c], throughFromFloor(c), 0.01) << c;
}

// One pixel of that sRGB value.
Texture plainTexture(float value) {
  const auto code = static_cast<std::uint16_t>(std::lround(65535 * value));
  TexturePixels pixels;
  pixels.width = pixels.height = 1;
  pixels.rgba = {code, code, code, 65535};
  Texture texture;
  texture.pixels = std::make_shared<const TexturePixels>(pixels);
  return texture;
}

// Most of the light behind the wall is not scattered in it, so paint must take its share of that.
TEST_F(BoundaryThroughTest, PaintTakesItsShare) {
  const Medium clear{"clear", {0.2F, 0.2F, 0.2F}, {0.01F, 0.01F, 0.01F}, 1.3F};
  const auto behind = [&](float shade) {
    Scene scene = ball();
    scene.lighting.directional = {{{0, 0, 1}, {1, 1, 1}}};
    scene.objects.push_back({"wall", box({0, 0, 8}, {40, 40, 0.5F}, 20), clear});
    Object& wall = scene.objects.back();
    wall.mesh.textureCoordinates[0].assign(wall.mesh.positionsMm.size(), {0.5F, 0.5F});
    wall.paint = Paint{"paint", {0.5F, 0.5F, 0.5F}, plainTexture(shade)};
    return exitanceOfBall(scene)[0];
  };
  const double bare = behind(1);
  const double dim = behind(0.5F);
  EXPECT_LT(dim, 0.8 * bare);
  EXPECT_GT(dim, 0.3 * bare);
  EXPECT_LT(behind(0), 0.02 * bare);
}

TEST_F(BoundaryThroughTest, NothingGetsThroughWhatIsOpaque) {
  Scene scene = ball();
  scene.lighting.directional = {{{0, 0, 1}, {1, 1, 1}}};
  scene.objects.push_back({"wall", box({0, 0, 8}, {40, 40, 0.5F}, 20), grey()});
  scene.objects.push_back({"screen", box({0, 0, 12}, {20, 20, 0.5F}, 8), milky()});
  scene.objects.back().opaque = OpaqueMaterial{};
  for (const double exitance : exitanceOfBall(scene)) EXPECT_LT(exitance, 1e-4);
}

}  // namespace
}  // namespace opaline
