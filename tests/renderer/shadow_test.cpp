// Shadows lie where geometry says, and surfaces do not shadow themselves.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "bssrdf/fresnel.h"
#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"

namespace opaline {
namespace {

using namespace test;

using std::numbers::pi;

double entering(double eta, double cosine) {
  return cosine * (1 - bssrdf::fresnelReflectance(eta, cosine));
}

Scene floorAnd(const Mesh& occluder) {
  Scene scene = sceneOf(sheet({0, 0, 0}, {0, 0, 20}, {20, 0, 0}), marble(), {60, 70, 0}, 30);
  scene.objects.push_back({"occluder", occluder, marble()});
  return scene;
}

// How far a place lies outside the square [-half, half]² around a centre; negative inside.
double outside(double x, double z, double half, double centreX) {
  return std::max(std::abs(x - centreX), std::abs(z)) - half;
}

// Checks a shadow on the floor y = 0. `unshadowed` gives E by position, `edge` the distance to the
// edge of the shadow. The filter's penumbra is `blurMm` to either side of it.
void expectShadow(const Image& position, const Image& irradiance, double blurMm,
                  const std::function<double(const Vector&)>& unshadowed,
                  const std::function<double(const Vector&)>& edge) {
  int dark = 0;
  int lit = 0;
  forEachCovered(position, [&](std::size_t i) {
    const Vector place = toVector(&position.rgba[i]);
    if (std::abs(place[1]) > 1e-4) return;  // not the floor
    const auto value = static_cast<double>(irradiance.rgba[i]);
    const double distance = edge(place);
    if (distance < -blurMm) {
      ++dark;
      ASSERT_EQ(value, 0) << place[0] << ' ' << place[2];
    } else if (distance > blurMm) {
      ++lit;
      ASSERT_NEAR(value / unshadowed(place), 1, 0.002) << place[0] << ' ' << place[2];
    }
  });
  EXPECT_GT(dark, 50);
  EXPECT_GT(lit, 1000);
}

double shadowedAreaMm2(const Image& position, const Image& area, const Image& irradiance,
                       const std::function<double(const Vector&)>& unshadowed) {
  double sum = 0;
  forEachCovered(position, [&](std::size_t i) {
    const Vector place = toVector(&position.rgba[i]);
    if (std::abs(place[1]) > 1e-4) return;
    sum += static_cast<double>(area.rgba[i]) *
           (1 - static_cast<double>(irradiance.rgba[i]) / unshadowed(place));
  });
  return sum;
}

using ShadowTest = RendererTest;

TEST_F(ShadowTest, OfADirectionalLightLiesWhereItShould) {
  const Vector toLight = unit({0.5, 1, 0});
  // The occluder is an open sheet, then a thin closed box.
  for (const Mesh& occluder :
       {sheet({0, 10, 0}, {0, 0, 4}, {4, 0, 0}, 8), box({0, 10, 0}, {4, 0.05F, 4}, 8)}) {
    Scene scene = floorAnd(occluder);
    scene.lighting.directional = {{toVec3(toLight), {2, 2, 2}}};
    RenderOptions options = smallOptions();
    options.sum = Sum::Pattern;
    options.dsmSize = 512;
    options.width = options.height = 128;
    const auto images = render(
        scene, options,
        {Aov::DsmPosition, Aov::DsmIrradiance, Aov::DsmArea, Aov::Position, Aov::Irradiance});
    const double expected = 2 * entering(1.5, toLight[1]);
    const auto unshadowed = [&](const Vector&) { return expected; };
    const auto edge = [&](const Vector& p) { return outside(p[0], p[2], 4, -5); };
    // The view of the light is 56 mm wide; on the floor a texel is longer by the cosine.
    const double texelMm = 56.0 / options.shadowSize / toLight[1];
    expectShadow(images[0], images[1], 2.5 * texelMm, unshadowed, edge);
    expectShadow(images[3], images[4], 2.5 * texelMm + 0.2, unshadowed, edge);
    const double area = shadowedAreaMm2(images[0], images[2], images[1], unshadowed);
    EXPECT_NEAR(std::sqrt(area), 8, texelMm);  // half a texel per edge
  }
}

TEST_F(ShadowTest, OfAPointLightLiesWhereItShould) {
  const Vector light{0, 25, 0};
  Scene scene = floorAnd(sheet({0, 10, 0}, {0, 0, 4}, {4, 0, 0}, 8));
  scene.lighting.points = {{toVec3(light), {1000, 1000, 1000}}};
  RenderOptions options = smallOptions();
  options.dsmSize = 512;
  const auto images = render(scene, options, {Aov::DsmPosition, Aov::DsmIrradiance, Aov::DsmArea});
  const auto unshadowed = [&](const Vector& p) {
    const Vector offset = light - p;
    return 1000 / dot(offset, offset) * entering(1.5, unit(offset)[1]);
  };
  const double half = 4 * 25.0 / 15;
  const double texelMm = 2.0 * 25 / options.shadowSize;
  expectShadow(images[0], images[1], 2.5 * texelMm, unshadowed,
               [&](const Vector& p) { return outside(p[0], p[2], half, 0); });
  const double area = shadowedAreaMm2(images[0], images[2], images[1], unshadowed);
  EXPECT_NEAR(std::sqrt(area), 2 * half, texelMm);  // half a texel per edge
}

// From afar light is parallel, and so sharp that only the box around the scene need be in its view.
TEST_F(ShadowTest, OfADistantLightIsAsSharpAsOfANearOne) {
  for (const float awayMm : {400.0F, 4000.0F, 40000.0F}) {
    SCOPED_TRACE(awayMm);
    const Vector light{0, static_cast<double>(awayMm), 0};
    Scene scene = floorAnd(sheet({0, 10, 0}, {0, 0, 4}, {4, 0, 0}, 8));
    const float intensity = awayMm * awayMm;
    scene.lighting.points = {{toVec3(light), {intensity, intensity, intensity}}};
    RenderOptions options = smallOptions();
    options.dsmSize = 512;
    const auto unshadowed = [&](const Vector& p) {
      const Vector offset = light - p;
      return light[1] * light[1] / dot(offset, offset) * entering(1.5, unit(offset)[1]);
    };
    const double half = 4 * light[1] / (light[1] - 10);
    const double texelMm = 2 * 20.5 / options.shadowSize;  // the floor is 40 mm wide
    const auto expect = [&] {
      const auto images = render(scene, options, {Aov::DsmPosition, Aov::DsmIrradiance});
      expectShadow(images[0], images[1], 2.5 * texelMm, unshadowed,
                   [&](const Vector& p) { return outside(p[0], p[2], half, 0); });
    };
    expect();
    scene.lighting.spots = {{toVec3(light), {0, -1, 0}, {intensity, intensity, intensity}, 30, 40}};
    scene.lighting.points.clear();
    expect();
  }
}

// With a single view of the cone, and with the six of a cube.
TEST_F(ShadowTest, OfASpotLightLiesWhereItShould) {
  const Vector light{0, 25, 0};
  for (const float outer : {40.0F, 60.0F}) {
    Scene scene = floorAnd(sheet({0, 10, 0}, {0, 0, 4}, {4, 0, 0}, 8));
    const float inner = 0.8F * outer;
    scene.lighting.spots = {{toVec3(light), {0, -1, 0}, {1000, 1000, 1000}, inner, outer}};
    RenderOptions options = smallOptions();
    options.dsmSize = 512;
    const auto images =
        render(scene, options, {Aov::DsmPosition, Aov::DsmIrradiance, Aov::DsmArea});
    const double ends = std::cos(static_cast<double>(outer) * pi / 180);
    const double begins = std::cos(static_cast<double>(inner) * pi / 180);
    const auto unshadowed = [&](const Vector& p) {
      const Vector offset = light - p;
      const double cosine = unit(offset)[1];
      const double part = std::clamp((cosine - ends) / (begins - ends), 0.0, 1.0);
      return part * part * 1000 / dot(offset, offset) * entering(1.5, cosine);
    };
    const double half = 4 * 25.0 / 15;
    const double view = outer < 50 ? std::tan(static_cast<double>(outer) * pi / 180) : 1;
    const double texelMm = 2.0 * 25 * view / options.shadowSize;
    int cone = 0;
    int dark = 0;
    forEachCovered(images[0], [&](std::size_t i) {
      const Vector place = toVector(&images[0].rgba[i]);
      if (std::abs(place[1]) > 1e-4) return;  // not the floor
      const double distance = outside(place[0], place[2], half, 0);
      const auto found = static_cast<double>(images[1].rgba[i]);
      const double expected = unshadowed(place);
      if (expected == 0 || distance < -2.5 * texelMm) {
        ++dark;
        ASSERT_NEAR(found, 0, 1e-6);
      } else if (distance > 2.5 * texelMm) {
        ++cone;
        ASSERT_NEAR(found, expected, 1e-3 * expected + 1e-5) << place[0] << ' ' << place[2];
      }
    });
    EXPECT_GT(dark, 1000);
    EXPECT_GT(cone, 1000);
  }
}

// A plane at grazing incidence has the closed form everywhere, however it is turned.
TEST_F(ShadowTest, TiltedPlaneDoesNotShadowItself) {
  Scene scene = sceneOf(sheet({0, 0, 0}, {0, 0, 20}, {20, 0, 0}), marble(), {0, 80, 1}, 20);
  // Makes the view of the light as large as for a body that is not flat.
  scene.objects.push_back({"away", sheet({-25, 30, -25}, {0, 0, 1}, {1, 0, 0}, 1), marble()});
  for (const double degrees : {0.0, 45.0, 60.0, 70.0, 75.0, 80.0})
    for (const double azimuth : {0.2, 0.8, 1.4}) {
      const double angle = degrees * pi / 180;
      const Vector toLight{std::sin(angle) * std::cos(azimuth), std::cos(angle),
                           std::sin(angle) * std::sin(azimuth)};
      const double expected = entering(1.5, std::cos(angle));
      scene.lighting = {};
      scene.lighting.directional = {{toVec3(toLight), {1, 1, 1}}};
      const auto images =
          render(scene, smallOptions(),
                 {Aov::DsmPosition, Aov::DsmIrradiance, Aov::Position, Aov::Irradiance});
      for (const std::size_t map : {0U, 2U})
        forEachCovered(images[map], [&](std::size_t i) {
          if (images[map].rgba[i + 1] > 1e-4F) return;  // not the plane
          ASSERT_NEAR(static_cast<double>(images[map + 1].rgba[i]) / expected, 1, 1e-4)
              << degrees << "°, " << azimuth;
        });
    }
}

// The faces of the cube around a point light store depth along their axes, so a plane has a slope
// there even where it faces the light.
TEST_F(ShadowTest, PlaneDoesNotShadowItselfFromAPointLight) {
  Scene scene = sceneOf(sheet({0, 0, 0}, {0, 0, 20}, {20, 0, 0}), marble(), {0, 80, 1}, 20);
  scene.objects.push_back({"away", sheet({-25, 30, -25}, {0, 0, 1}, {1, 0, 0}, 1), marble()});
  for (const Vector& light : {Vector{0, 6, 0}, {25, 12, 19}, {31, 9, -4}, {5, 50, 5}}) {
    scene.lighting = {};
    scene.lighting.points = {{toVec3(light), {1, 1, 1}}};
    const auto images = render(scene, smallOptions(), {Aov::DsmPosition, Aov::DsmIrradiance});
    forEachCovered(images[0], [&](std::size_t i) {
      const Vector place = toVector(&images[0].rgba[i]);
      const Vector offset = light - place;
      const double cosine = unit(offset)[1];
      if (place[1] > 1e-4 || cosine < 0.17) return;
      ASSERT_NEAR(
          static_cast<double>(images[1].rgba[i]) * dot(offset, offset) / entering(1.5, cosine), 1,
          1e-3)
          << light[0] << ": " << place[0] << ' ' << place[2];
    });
  }
}

TEST_F(ShadowTest, ThinSlabKeepsItsLightAndItsShadow) {
  const Vector toLight = unit({0.3, 1, 0.2});
  Scene scene = floorAnd(box({0, 10, 0}, {8, 0.25F, 8}));
  scene.lighting.directional = {{toVec3(toLight), {1, 1, 1}}};
  RenderOptions options = smallOptions();
  options.dsmSize = 512;
  const auto images =
      render(scene, options, {Aov::DsmPosition, Aov::DsmNormal, Aov::DsmIrradiance});
  int top = 0;
  int bottom = 0;
  int umbra = 0;
  forEachCovered(images[0], [&](std::size_t i) {
    const Vector place = toVector(&images[0].rgba[i]);
    const auto value = static_cast<double>(images[2].rgba[i]);
    const float up = images[1].rgba[i + 1];
    if (place[1] > 5 && up > 0.9F) {
      ++top;
      ASSERT_NEAR(value / entering(1.5, toLight[1]), 1, 1e-4);
    } else if (place[1] > 5 && up < -0.9F) {
      ++bottom;
      ASSERT_EQ(value, 0);
    } else if (place[1] < 1e-3 && outside(place[0] + 3, place[2] + 2, 7.5, 0) < 0) {
      ++umbra;
      ASSERT_EQ(value, 0) << place[0] << ' ' << place[2];
    }
  });
  EXPECT_GT(top, 2000);
  EXPECT_GT(bottom, 2000);
  EXPECT_GT(umbra, 2000);
}

}  // namespace
}  // namespace opaline
