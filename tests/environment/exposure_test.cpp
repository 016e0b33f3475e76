#include "opaline/exposure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "opaline/scene.h"

namespace opaline {
namespace {

constexpr float piF = std::numbers::pi_v<float>;
constexpr float hundredth = 0.0051F;  // of a stop, to which results are rounded

Scene emptyScene() {
  Scene scene;
  scene.lighting = {};
  return scene;
}

float stopsOf(const Lighting& lighting) {
  Scene scene = emptyScene();
  scene.lighting = lighting;
  return automaticExposureStops(scene);
}

Rgb grey(float value) {
  return {value, value, value};
}

TEST(Exposure, OrdinaryLightIsLeftAsItIs) {
  EXPECT_EQ(stopsOf(defaultLighting()), 0);
  EXPECT_EQ(stopsOf({.ambient = grey(1)}), 0);
  EXPECT_EQ(stopsOf({.directional = {{}}}), 0);
  // The first picture of the README.
  const auto unit = [](float x, float y, float z) {
    const float length = std::sqrt(x * x + y * y + z * z);
    return Vec3{x / length, y / length, z / length};
  };
  EXPECT_EQ(stopsOf({.directional = {{unit(-0.5F, 0.5F, -0.8F), {6, 5.6F, 5}},
                                     {unit(0.8F, 0.3F, -0.5F), {2.5F, 2.2F, 2}},
                                     {unit(-0.4F, 0.8F, 0.7F), {0.5F, 0.5F, 0.55F}}},
                     .ambient = {0.08F, 0.08F, 0.1F}}),
            0);
}

// White paper under an even sky of radiance L has radiance L; facing a lamp of irradiance E it has
// E/π.
TEST(Exposure, WhiteComesToTheNearerEndOfWhatIsOrdinary) {
  EXPECT_FLOAT_EQ(stopsOf({.ambient = grey(10)}), -2);
  EXPECT_FLOAT_EQ(stopsOf({.ambient = grey(0.0625F)}), 2);
  EXPECT_FLOAT_EQ(stopsOf({.directional = {{{0, 0.6F, 0.8F}, grey(10 * piF)}}}), -2);
  EXPECT_NEAR(stopsOf({.directional = {{{0, 0, 1}, grey(7.5F * piF)}}, .ambient = grey(2.5F)}), -2,
              hundredth);
  // Two lamps at right angles light a surface between them by the diagonal of both.
  EXPECT_NEAR(stopsOf({.directional = {{{1, 0, 0}, grey(10 * piF)}, {{0, 1, 0}, grey(10 * piF)}}}),
              -2.5F, hundredth);
  // Lamps on opposite sides do not add up.
  EXPECT_NEAR(stopsOf({.directional = {{{1, 0, 0}, grey(10 * piF)}, {{-1, 0, 0}, grey(10 * piF)}}}),
              -2, hundredth);
}

TEST(Exposure, TheBrightestChannelDecides) {
  EXPECT_FLOAT_EQ(stopsOf({.ambient = {0, 0.1F, 10}}), -2);
}

TEST(Exposure, ADoubledSkyIsAStopLess) {
  auto sky = std::make_shared<Image>();
  sky->width = 8;
  sky->height = 4;
  for (int i = 0; i < 32; ++i) {
    const float value = i == 5 ? 400 : 1.5F;
    sky->rgba.insert(sky->rgba.end(), {value, value, value, 1});
  }
  const float once = stopsOf({.environment = sky});
  EXPECT_LT(once, -1);
  auto doubled = std::make_shared<Image>(*sky);
  for (float& value : doubled->rgba) value *= 2;
  EXPECT_NEAR(stopsOf({.environment = doubled}), once - 1, 2 * hundredth);
}

// A sky of one colour is ambient light of that colour.
TEST(Exposure, AnEvenEnvironmentIsAmbientLight) {
  auto sky = std::make_shared<Image>();
  sky->width = 4;
  sky->height = 2;
  sky->rgba.assign(32, 10);
  EXPECT_FLOAT_EQ(stopsOf({.environment = sky}), -2);
}

TEST(Exposure, PointLightsCountAtTheMiddleOfTheBody) {
  Scene scene = emptyScene();
  scene.objects.emplace_back().mesh.positionsMm = {{10, -3, -4}, {10, 3, 4}};  // 10 mm across
  const auto stopsAt = [&](const Vec3& place, float intensity) {
    scene.lighting.points = {{place, grey(intensity)}};
    return automaticExposureStops(scene);
  };
  // 20 mm away: E = intensity / 400.
  EXPECT_NEAR(stopsAt({30, 0, 0}, 400 * 10 * piF), -2, hundredth);
  // Nearer lamps count as at half the diagonal, 5 mm.
  EXPECT_NEAR(stopsAt({11, 0, 0}, 25 * 10 * piF), -2, hundredth);
  EXPECT_NEAR(stopsAt({10, 0, 0}, 25 * 10 * piF), -2, hundredth);
}

TEST(Exposure, SpotLightsCountWhereTheyShine) {
  Scene scene = emptyScene();
  scene.objects.emplace_back().mesh.positionsMm = {{10, -3, -4}, {10, 3, 4}};
  SpotLight light{
      .positionMm = {30, 0, 0}, .direction = {-1, 0, 0}, .intensity = grey(400 * 10 * piF)};
  scene.lighting.spots = {light};
  EXPECT_NEAR(automaticExposureStops(scene), -2, hundredth);
  light.direction = {1, 0, 0};
  scene.lighting = {.spots = {light}, .ambient = grey(1)};
  EXPECT_EQ(automaticExposureStops(scene), 0);
}

// A sphere gives L π r²/d²; a light that faces away gives nothing.
TEST(Exposure, AreaLightsCountByTheLightInTheMiddle) {
  Scene scene = emptyScene();
  scene.objects.emplace_back().mesh.positionsMm = {{10, -3, -4}, {10, 3, 4}};
  scene.lighting.areas = {SphereLight{{110, 0, 0}, 5, grey(400 * 10)}};
  EXPECT_NEAR(automaticExposureStops(scene), -2, 2 * hundredth);
  scene.lighting = {.areas = {DiscLight{{40, 0, 0}, {1, 0, 0}, 5, grey(1e6F)}}, .ambient = grey(1)};
  EXPECT_EQ(automaticExposureStops(scene), 0);
}

TEST(Exposure, IsFiniteForAnyLight) {
  EXPECT_EQ(stopsOf({}), 0);
  constexpr float most = std::numeric_limits<float>::max();
  EXPECT_EQ(stopsOf({.directional = {{{0, 0, 1}, grey(most)}}, .ambient = grey(most)}), -32);
  EXPECT_EQ(stopsOf({.ambient = grey(std::numeric_limits<float>::denorm_min())}), 32);
  // A lamp in a scene without extent.
  EXPECT_EQ(stopsOf({.points = {{{0, 0, 0}, grey(1)}}}), 0);
}

}  // namespace
}  // namespace opaline
