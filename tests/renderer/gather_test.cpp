// Light that enters, in the diffusion source map: irradiance on spheres against closed forms and
// direct quadrature.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include "bssrdf/fresnel.h"
#include "bssrdf/quadrature.h"
#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"

namespace opaline {
namespace {

using namespace test;

using std::numbers::pi;

using GatherTest = RendererTest;

double transmitted(double eta, double cosine) {
  return 1 - bssrdf::fresnelReflectance(eta, cosine);
}

Scene ball(float radiusMm) {
  return sceneOf(sphere({0, 0, 0}, radiusMm, 4), marble(), {0, 0, 4 * radiusMm}, radiusMm * 1.05F);
}

// Visible pixels show the map's irradiance.
RenderOptions byTheMap() {
  RenderOptions options = smallOptions();
  options.sum = Sum::Pattern;
  return options;
}

// Makes an environment of small pixels from radiance by direction.
Image environmentOf(const std::function<double(const Vector&)>& radiance) {
  Image image(256, 128);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double polar = pi * (y + 0.5) / image.height;
      const double azimuth = 2 * pi * ((x + 0.5) / image.width - 0.5);
      const double value = radiance({std::sin(polar) * std::sin(azimuth), std::cos(polar),
                                     -std::sin(polar) * std::cos(azimuth)});
      for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = static_cast<float>(value * (c + 1));
      image.pixel(x, y)[3] = 1;
    }
  return image;
}

// ∫ L F_t μ dω over the hemisphere about a normal.
double irradianceByQuadrature(const std::function<double(const Vector&)>& radiance, double eta,
                              const Vector& normal) {
  const Vector helper = std::abs(normal[0]) < 0.5 ? Vector{1, 0, 0} : Vector{0, 1, 0};
  const Vector u = unit(helper - dot(helper, normal) * normal);
  const Vector v{normal[1] * u[2] - normal[2] * u[1], normal[2] * u[0] - normal[0] * u[2],
                 normal[0] * u[1] - normal[1] * u[0]};
  constexpr int sectors = 16;
  return integrate(
      [&](double mu) {
        double ring = 0;
        for (int i = 0; i < sectors; ++i) {
          const double angle = 2 * pi * i / sectors;
          const double sine = std::sqrt(1 - mu * mu);
          ring +=
              radiance(mu * normal + (sine * std::cos(angle)) * u + (sine * std::sin(angle)) * v);
        }
        return ring / sectors * 2 * pi * transmitted(eta, mu) * mu;
      },
      0, 1, 40);
}

TEST_F(GatherTest, UniformLightGivesPiTimesMeanTransmittance) {
  for (const double eta : {1.3, 1.5}) {
    Scene scene = ball(5);
    scene.objects[0].medium.eta = eta;
    scene.lighting.ambient = {1, 2, 0.5F};
    const auto images = render(scene, byTheMap(), {Aov::DsmIrradiance, Aov::Irradiance});
    const double expected = pi * bssrdf::meanTransmittance(eta);
    for (const Image& image : images) {
      const int covered = forEachCovered(image, [&](std::size_t i) {
        ASSERT_NEAR(static_cast<double>(image.rgba[i]) / expected, 1, 0.002);
        ASSERT_NEAR(static_cast<double>(image.rgba[i + 1]) / expected, 2, 0.004);
        ASSERT_NEAR(static_cast<double>(image.rgba[i + 2]) / expected, 0.5, 0.001);
      });
      EXPECT_GT(covered, 2000);
    }
  }
}

TEST_F(GatherTest, EnvironmentOfBandsUpToTwoAgreesWithQuadrature) {
  const auto radiance = [](const Vector& d) {
    return 2 + 0.9 * d[0] - 0.5 * d[1] + 0.7 * d[2] + 0.6 * d[0] * d[2] + 0.4 * d[1] * d[1];
  };
  Scene scene = ball(5);
  scene.lighting.environment = std::make_shared<const Image>(environmentOf(radiance));
  const auto images = render(scene, smallOptions(), {Aov::DsmPosition, Aov::DsmIrradiance});
  int index = 0;
  forEachCovered(images[0], [&](std::size_t i) {
    if (++index % 97 != 0) return;
    const Vector normal = unit(toVector(&images[0].rgba[i]));
    const double expected = irradianceByQuadrature(radiance, 1.5, normal);
    for (std::size_t c = 0; c < 3; ++c)
      ASSERT_NEAR(
          static_cast<double>(images[1].rgba[i + c]) / expected / static_cast<double>(c + 1), 1,
          0.002)
          << normal[0] << ' ' << normal[1] << ' ' << normal[2];
  });
}

// Whatever the bands omit, the mean over all normals must be that of the mean radiance.
TEST_F(GatherTest, SunOfOnePixelStaysFiniteAndRight) {
  constexpr float sun = 70'000;
  Scene scene = ball(5);
  Image environment(64, 32);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 64; ++x)
      for (int c = 0; c < 4; ++c) environment.pixel(x, y)[c] = 0.5F;
  for (int c = 0; c < 3; ++c) environment.pixel(40, 9)[c] = sun;
  scene.lighting.environment = std::make_shared<const Image>(environment);

  const double pixelSolidAngle = 2 * pi / 64 * (std::cos(pi * 9 / 32) - std::cos(pi * 10 / 32));
  const double meanRadiance = 0.5 + (static_cast<double>(sun) - 0.5) * pixelSolidAngle / (4 * pi);
  const double expected = pi * bssrdf::meanTransmittance(1.5) * meanRadiance;

  const auto images =
      render(scene, smallOptions(), {Aov::DsmIrradiance, Aov::DsmArea, Aov::Radiance});
  double flux = 0;
  double area = 0;
  forEachCovered(images[0], [&](std::size_t i) {
    ASSERT_TRUE(std::isfinite(images[0].rgba[i]));
    ASSERT_GE(images[0].rgba[i], 0.0F);
    const auto texel = static_cast<double>(images[1].rgba[i]);
    flux += static_cast<double>(images[0].rgba[i]) * texel;
    area += texel;
  });
  EXPECT_NEAR(flux / area / expected, 1, 0.003);
  forEachCovered(images[2], [&](std::size_t i) {
    for (std::size_t c = 0; c < 3; ++c) {
      ASSERT_TRUE(std::isfinite(images[2].rgba[i + c]));
      ASSERT_GE(images[2].rgba[i + c], 0.0F);
    }
  });
}

// One bright pixel in even light is a directional light in ambient light, with shadows.
TEST_F(GatherTest, SunOfAnEnvironmentIsADirectionalLight) {
  constexpr float sun = 70'000;
  constexpr float around = 0.5F;
  auto environment = std::make_shared<Image>(64, 32);
  std::fill(environment->rgba.begin(), environment->rgba.end(), around);
  for (int c = 0; c < 3; ++c) environment->pixel(40, 9)[c] = sun;
  const double azimuth = 2 * pi * (40.5 / 64 - 0.5);
  const double polar = pi * 9.5 / 32;
  const double solidAngle = 2 * pi / 64 * (std::cos(pi * 9 / 32) - std::cos(pi * 10 / 32));
  const auto irradiance = static_cast<float>((double{sun} - double{around}) * solidAngle);

  Scene apart = ball(5);
  apart.objects.push_back(apart.objects[0]);
  for (Vec3& position : apart.objects[1].mesh.positionsMm) position[1] += 8;
  Scene whole = apart;
  whole.lighting.environment = environment;
  apart.lighting.ambient = {around, around, around};
  apart.lighting.directional = {{toVec3({std::sin(polar) * std::sin(azimuth), std::cos(polar),
                                         -std::sin(polar) * std::cos(azimuth)}),
                                 {irradiance, irradiance, irradiance}}};
  const Image expected = render(apart, smallOptions(), {Aov::Exitance})[0];
  const Image made = render(whole, smallOptions(), {Aov::Exitance})[0];
  forEachCovered(expected,
                 [&](std::size_t i) { ASSERT_NEAR(made.rgba[i] / expected.rgba[i], 1, 1e-3); });
}

TEST_F(GatherTest, TexelsCarryTheAreaOfTheSphere) {
  renderer().setScene(ball(5));
  for (const int size : {128, 256, 512}) {
    RenderOptions options = smallOptions();
    options.dsmSize = size;
    const Image area = render(options, {Aov::DsmArea})[0];
    double sum = 0;
    forEachCovered(area, [&](std::size_t i) {
      ASSERT_GT(area.rgba[i], 0.0F);
      sum += static_cast<double>(area.rgba[i]);
    });
    EXPECT_NEAR(sum / (4 * pi * 25), 1, 0.005) << size;
  }
}

TEST_F(GatherTest, DirectionalLightOnASphere) {
  Scene scene = ball(20);
  const Vector toLight = unit({1, 1, 2});
  scene.lighting.directional = {{toVec3(toLight), {3, 2, 1}}};
  RenderOptions options = byTheMap();
  options.dsmSize = 512;
  const auto images = render(
      scene, options, {Aov::DsmPosition, Aov::DsmIrradiance, Aov::Position, Aov::Irradiance});
  // A texel of the map is 0.2 mm, within which the closed form changes by 0.01 of its maximum.
  const std::array<double, 2> tolerance{0.001, 0.012};
  for (const std::size_t map : {0U, 2U}) {
    int lit = 0;
    forEachCovered(images[map], [&](std::size_t i) {
      const double cosine = dot(unit(toVector(&images[map].rgba[i])), toLight);
      const auto irradiance = static_cast<double>(images[map + 1].rgba[i]);
      if (cosine < -0.02) {
        ASSERT_EQ(irradiance, 0);
      }
      if (cosine < 0.15) return;  // the terminator, softened by the shadow map's texels
      ++lit;
      const double expected = 3 * cosine * transmitted(1.5, cosine);
      ASSERT_NEAR(irradiance, expected, 3 * tolerance[map / 2]) << cosine;
      ASSERT_NEAR(static_cast<double>(images[map + 1].rgba[i + 2]) * 3, irradiance, 1e-5);
    });
    EXPECT_GT(lit, 500);
  }
}

TEST_F(GatherTest, PointLightOnASphere) {
  Scene scene = ball(5);
  const Vector light{9, 4, 6};
  scene.lighting.points = {{toVec3(light), {400, 400, 400}}};
  const auto images = render(scene, smallOptions(), {Aov::DsmPosition, Aov::DsmIrradiance});
  int lit = 0;
  forEachCovered(images[0], [&](std::size_t i) {
    const Vector position = toVector(&images[0].rgba[i]);
    const Vector offset = light - position;
    const double cosine = dot(unit(position), unit(offset));
    const auto irradiance = static_cast<double>(images[1].rgba[i]);
    if (cosine < -0.02) {
      ASSERT_EQ(irradiance, 0);
    }
    if (cosine < 0.15) return;
    ++lit;
    const double expected = 400 / dot(offset, offset) * cosine * transmitted(1.5, cosine);
    ASSERT_NEAR(irradiance / expected, 1, 0.002) << cosine;
  });
  EXPECT_GT(lit, 2000);
}

TEST_F(GatherTest, LightsAddUp) {
  Scene scene = ball(5);
  const DirectionalLight sun{toVec3(unit({1, 2, 1})), {1, 2, 3}};
  const PointLight lamp{{-8, 3, 5}, {200, 100, 50}};
  std::vector<Image> images;
  for (const int lights : {1, 2, 3}) {
    scene.lighting = {};
    if ((lights & 1) != 0) scene.lighting.directional = {sun};
    if ((lights & 2) != 0) scene.lighting.points = {lamp};
    images.push_back(render(scene, smallOptions(), {Aov::DsmIrradiance})[0]);
  }
  forEachCovered(images[2], [&](std::size_t i) {
    for (std::size_t c = 0; c < 3; ++c)
      ASSERT_NEAR(images[2].rgba[i + c], images[0].rgba[i + c] + images[1].rgba[i + c], 1e-5F);
  });
}

}  // namespace
}  // namespace opaline
