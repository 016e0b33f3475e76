// Paint on translucent bodies: its own colours in even light, and what path tracing finds in a
// lamp's light.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "bssrdf/fresnel.h"
#include "opaline/tone.h"
#include "reference/geometry.h"
#include "reference/path/emitter.h"
#include "reference/path/walk.h"
#include "renderer/boundary_fixture.h"
#include "scene/material.h"

namespace opaline {
namespace {

using namespace test;
using PaintedBodyTest = RendererTest;

constexpr float ballRadiusMm = 10;
constexpr Rgb pale{0.75F, 0.75F, 0.75F};
constexpr float darkShare = 0.3F;
constexpr std::array<double, 4> shades{0.85, 0.6, 0.3, 0.1};

/// The part of a body that is dark: two of four sectors around z.
bool isDark(const Vector& place) {
  return place[0] * place[1] > 0;
}

/// A ball of a medium of the pale colour. A texture of four pixels along the angle around z gives
/// two sectors a dark tint. Triangles at the border between sectors have corners of their own, so
/// that the texture does not run backwards there.
Scene paintedBall(double eta, double meanFreePathMm) {
  Appearance appearance{{0.75, 0.75, 0.75}, {}, 0, eta};
  appearance.meanFreePathMm.fill(meanFreePathMm);
  Scene scene = ballOf(ballRadiusMm, mediumOf(appearance), 4);
  Mesh& mesh = scene.objects[0].mesh;
  const Mesh welded = mesh;
  mesh = {};
  for (const Triangle& t : welded.triangles) {
    Triangle own{};
    Vector middle{};
    for (const std::uint32_t corner : t) middle = middle + toVector(welded.positionsMm[corner]);
    for (std::size_t k = 0; k < 3; ++k) {
      own[k] = static_cast<std::uint32_t>(mesh.positionsMm.size());
      mesh.positionsMm.push_back(welded.positionsMm[t[k]]);
      mesh.normals.push_back(welded.normals[t[k]]);
      mesh.textureCoordinates[0].push_back({isDark(middle) ? 0.75F : 0.25F, 0.5F});
    }
    mesh.triangles.push_back(own);
  }
  TexturePixels pixels;
  pixels.width = 2;
  pixels.height = 1;
  const auto encoded = static_cast<std::uint16_t>(
      std::lround(65535 * (1.055 * std::pow(double{darkShare}, 1 / 2.4) - 0.055)));
  pixels.rgba = {65535, 65535, 65535, 65535, encoded, encoded, encoded, 65535};
  Texture texture;
  texture.pixels = std::make_shared<const TexturePixels>(pixels);
  texture.interpolated = false;
  scene.objects[0].paint = Paint{"paint", pale, texture};
  return scene;
}

struct Means {
  double pale;
  double dark;
};

/// Mean exitance well inside the sectors, seen from +z.
Means meansInside(const std::vector<Image>& images) {
  const auto mean = [&](bool dark) {
    return meanWhere(images[0], images[1], [&](const Vector& at) {
      const double border = std::min(std::abs(at[0]), std::abs(at[1]));
      return isDark(at) == dark && border > 3 && at[2] > 3;
    })[1];
  };
  return {mean(false), mean(true)};
}

// A body of two hundred mean free paths is nearly a half-space.
TEST_F(PaintedBodyTest, InEvenLightItsColorsAreThoseOfThePaint) {
  for (const double eta : {1.3, 1.4, 1.5}) {
    Scene scene = paintedBall(eta, 0.1);
    scene.lighting.ambient = {1, 1, 1};
    const Means seen = meansInside(
        renderBoundary(scene, boundaryOptions(64), {Aov::Exitance, Aov::Position}).images);
    const double entered = std::numbers::pi * bssrdf::meanTransmittance(eta);
    EXPECT_NEAR(seen.pale / entered, 0.75, 0.02) << eta;
    EXPECT_NEAR(seen.dark / entered, 0.75 * double{darkShare}, 0.02) << eta;
  }
}

/// A ball, or an ellipsoid, with an appearance from a texture of four shades of grey side by side;
/// the whole body has one of them.
Scene evenlyPainted(double eta, double meanFreePathMm, std::size_t shade, const Vector& halfAxesMm,
                    double ballMm) {
  TexturePixels pixels;
  pixels.width = 4;
  pixels.height = 1;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto encoded =
        static_cast<std::uint16_t>(std::lround(65535 * encodeSrgb(static_cast<float>(shades[i]))));
    pixels.rgba.insert(pixels.rgba.end(), {encoded, encoded, encoded, 65535});
  }
  Texture texture;
  texture.pixels = std::make_shared<const TexturePixels>(pixels);
  texture.interpolated = false;
  Appearance appearance{{1, 1, 1}, {}, 0, eta};
  appearance.meanFreePathMm.fill(meanFreePathMm);
  appearance.ballMm = ballMm;
  const scene::Translucent made = scene::bodyOf(appearance, texture);
  Scene scene = ballOf(1, made.medium, 4);
  Mesh& mesh = scene.objects[0].mesh;
  for (std::size_t i = 0; i < mesh.positionsMm.size(); ++i) {
    const Vector at = toVector(mesh.positionsMm[i]);
    Vector normal{};
    for (std::size_t k = 0; k < 3; ++k) normal[k] = at[k] / halfAxesMm[k];
    for (std::size_t k = 0; k < 3; ++k) mesh.positionsMm[i][k] *= static_cast<float>(halfAxesMm[k]);
    mesh.normals[i] = toVec3(unit(normal));
  }
  mesh.textureCoordinates[0].assign(mesh.positionsMm.size(),
                                    {(static_cast<float>(shade) + 0.5F) / 4, 0.5F});
  scene.camera.positionMm = {0, 0, 60};
  scene.objects[0].paint = made.paint;
  scene.lighting.ambient = {1, 1, 1};
  return scene;
}

/// The share of the entered light that leaves again.
double meanShare(const Scene& scene, double eta) {
  const Image image = renderBoundary(scene, boundaryOptions(48), {Aov::Exitance}).images[0];
  double sum = 0;
  const int count = forEachCovered(image, [&](std::size_t i) { sum += double{image.rgba[i]}; });
  return sum / count / (std::numbers::pi * bssrdf::meanTransmittance(eta));
}

// Valid for bodies as large as the ball of the colours, from 20 mean free paths on.
TEST_F(PaintedBodyTest, ColorsOfABallAreSeenOnIt) {
  for (const double eta : {1.3, 1.5})
    for (const double meanFreePathMm : {0.1, 0.4, 1.0})
      for (const std::size_t shade : {0U, 2U}) {
        const Scene scene = evenlyPainted(eta, meanFreePathMm, shade, {10, 10, 10}, 20);
        EXPECT_NEAR(meanShare(scene, eta), shades[shade], 0.02) << eta << " " << meanFreePathMm;
      }
}

// The ball's diameter is taken as six times the ellipsoid's volume over its surface.
TEST_F(PaintedBodyTest, ColorsOfABallAreSeenOnAnEllipsoid) {
  const double eta = 1.4;
  const double a = 10;
  const double c = 5;
  const double eccentricity = std::sqrt(1 - c * c / (a * a));
  const double surface = 2 * std::numbers::pi * a * a *
                         (1 + c * c / (a * a) / eccentricity * std::atanh(eccentricity));
  const double ballMm = 6 * (4 * std::numbers::pi / 3 * a * a * c) / surface;
  for (const std::size_t shade : {0U, 2U}) {
    const Scene scene = evenlyPainted(eta, ballMm / 20, shade, {a, c, a}, ballMm);
    EXPECT_NEAR(meanShare(scene, eta), shades[shade], 0.02) << shade;
  }
}

/// Exitance by path tracing, in four bands of the cosine to +z, each dark and pale.
using Bands = std::array<std::array<double, 2>, 4>;

std::size_t bandOf(const Vector& place) {
  return std::min<std::size_t>(static_cast<std::size_t>(4 * place[2] / double{ballRadiusMm}), 3);
}

Bands tracedBands(const Scene& scene, int particles) {
  const Object& object = scene.objects[0];
  reference::Body body;
  for (const Vec3& p : object.mesh.positionsMm) body.positionsMm.push_back(toVector(p));
  for (const Vec3& n : object.mesh.normals) body.normals.push_back(toVector(n));
  body.triangles = object.mesh.triangles;
  body.medium = object.medium;
  body.paint = object.paint;
  body.textureCoordinates = object.mesh.textureCoordinates;
  reference::Scene traced;
  traced.bodies = {body};
  traced.lighting = scene.lighting;
  traced.camera = scene.camera;
  const reference::Geometry geometry(traced);
  const reference::DistanceBound bound(traced);
  const double s = object.medium.sigmaSPrimePerMm[0];
  const double a = object.medium.sigmaAPerMm[0];
  const std::vector<reference::Interior> interiors{
      {s + a, s / (s + a), 0, object.medium.eta,
       std::make_shared<const reference::Layer>(traced.bodies[0], 0)}};
  const reference::Walk walk(geometry, bound, interiors, 0);
  const reference::Emitter emitter(geometry, 0);
  Bands bands{};
  const double area = 2 * std::numbers::pi * double{ballRadiusMm} * double{ballRadiusMm} / 8;
  for (int i = 0; i < particles; ++i) {
    reference::Random random(3, static_cast<std::uint64_t>(i));
    walk.follow(emitter.emit(random), random, [&](const reference::Leaving& leaving) {
      const reference::Vector& position = leaving.point.position;
      if (position[2] <= 0) return;
      bands[bandOf(position)][isDark(position) ? 1 : 0] += emitter.flux() / particles / area;
    });
  }
  return bands;
}

Bands renderedBands(const Scene& scene) {
  const std::vector<Image> images =
      renderBoundary(scene, boundaryOptions(96), {Aov::Exitance, Aov::Position}).images;
  Bands sums{};
  Bands areas{};
  forEachCovered(images[0], [&](std::size_t i) {
    const Vector at = toVector(&images[1].rgba[i]);
    const Vector toCamera = toVector(scene.camera.positionMm) - at;
    const double seen = dot(unit(at), unit(toCamera));
    if (at[2] <= 0 || seen < 0.02) return;
    const double axial = dot(unit(toCamera), unit(toVector(scene.camera.positionMm)));
    const double area = dot(toCamera, toCamera) * std::pow(axial, 3) / seen;
    const std::size_t dark = isDark(at) ? 1 : 0;
    areas[bandOf(at)][dark] += area;
    sums[bandOf(at)][dark] += area * static_cast<double>(images[0].rgba[i + 1]);
  });
  for (std::size_t band = 0; band < sums.size(); ++band)
    for (std::size_t dark = 0; dark < 2; ++dark) sums[band][dark] /= areas[band][dark];
  return sums;
}

// Light crosses the layer four times: on its way in and out, and mirrored back and forth.
TEST_F(PaintedBodyTest, InALampsLightItIsWhatPathTracingFinds) {
  Scene scene = paintedBall(1.4, 0.4);
  scene.lighting.directional = {{{0, 0, 1}, {1, 1, 1}}};
  scene.lighting.ambient = {};
  const Bands traced = tracedBands(scene, 400'000);
  const Bands rendered = renderedBands(scene);
  for (std::size_t band = 1; band < 4; ++band)
    for (std::size_t dark = 0; dark < 2; ++dark)
      EXPECT_NEAR(rendered[band][dark] / traced[band][dark], 1, 0.04) << band << " " << dark;
}

TEST_F(PaintedBodyTest, PaintThatIsNotThereChangesNothing) {
  Scene scene = paintedBall(1.4, 0.4);
  scene.objects[0].paint->colorTexture.reset();
  scene.objects[0].paint->color = {1, 1, 1};
  scene.lighting.directional = {{{1, 0, 1}, {1, 1, 1}}};
  const RenderOptions options = boundaryOptions(32);
  const Image painted = renderBoundary(scene, options, {Aov::Radiance}).images[0];
  scene.objects[0].paint.reset();
  RenderOptions atFragments = options;
  atFragments.site = Site::Fragment;
  const Image bare = renderBoundary(scene, atFragments, {Aov::Radiance}).images[0];
  forEachCovered(bare, [&](std::size_t i) {
    EXPECT_NEAR(painted.rgba[i], bare.rgba[i], 1e-3F * bare.rgba[i] + 1e-5F);
  });
}

/// A sheet of squares of two triangles each. The upper left corner of each is cut into many small
/// dark triangles that make up a hundredth of its area.
Scene speckledSheet() {
  constexpr int squares = 24;
  constexpr double edgeMm = 1;
  constexpr int specks = 16;
  constexpr float paleAt = 0.25F;
  constexpr float darkAt = 0.75F;
  Mesh mesh;
  const auto add = [&](const Vector& a, const Vector& b, const Vector& c, float color) {
    const auto first = static_cast<std::uint32_t>(mesh.positionsMm.size());
    for (const Vector& corner : {a, b, c}) {
      mesh.positionsMm.push_back(toVec3(corner));
      mesh.normals.push_back({0, 0, 1});
      mesh.textureCoordinates[0].push_back({color, 0.5F});
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  };
  const double cut = edgeMm * std::sqrt(0.02);  // half its square is a hundredth
  for (int y = 0; y < squares; ++y)
    for (int x = 0; x < squares; ++x) {
      const Vector low{(x - squares / 2) * edgeMm, (y - squares / 2) * edgeMm, 0};
      const Vector right = low + Vector{edgeMm, 0, 0};
      const Vector up = low + Vector{0, edgeMm, 0};
      const Vector across = low + Vector{edgeMm, edgeMm, 0};
      const Vector first = low + Vector{cut, 0, 0};
      const Vector last = low + Vector{0, cut, 0};
      add(right, across, up, paleAt);
      add(first, right, up, paleAt);
      add(first, up, last, paleAt);
      for (int i = 0; i < specks; ++i) {
        const auto at = [&](int k) {
          const double part = static_cast<double>(k) / specks;
          return (1 - part) * first + part * last;
        };
        add(low, at(i), at(i + 1), darkAt);
      }
    }
  Appearance appearance{{0.75, 0.75, 0.75}, {0.1, 0.1, 0.1}, 0, 1.4};
  Scene scene = sceneOf(mesh, mediumOf(appearance), {0, 0, 60}, 8);
  scene.objects[0].paint =
      Paint{"paint", pale, paintedBall(1.4, 0.1).objects[0].paint->colorTexture};
  scene.lighting.directional = {{{0, 0, 1}, {1, 1, 1}}};
  return scene;
}

// Surfels of many triangles let in what each triangle does, weighted by area: 0.99 of the pale part
// here, although most triangles are dark.
TEST_F(PaintedBodyTest, SmallTrianglesCountByTheirArea) {
  RenderOptions options = smallOptions();
  options.transport = Transport::BetterDipole;
  options.site = Site::Fragment;
  options.maxSurfels = 1024;
  Scene scene = speckledSheet();
  const auto meanIrradiance = [&] {
    const Image image = render(scene, options, {Aov::Irradiance})[0];
    double sum = 0;
    const int count = forEachCovered(image, [&](std::size_t i) { sum += double{image.rgba[i]}; });
    return sum / count;
  };
  const double speckled = meanIrradiance();
  for (Vec2& at : scene.objects[0].mesh.textureCoordinates[0]) at[0] = 0.25F;
  const double pure = meanIrradiance();
  EXPECT_LT(speckled, pure);
  EXPECT_GT(speckled, 0.985 * pure);
}

TEST_F(PaintedBodyTest, ThePatternRefusesIt) {
  RenderOptions options = smallOptions();
  options.sum = Sum::Pattern;
  options.transport = Transport::Dipole;
  sharedRenderer().renderer->setScene(paintedBall(1.4, 0.4));
  EXPECT_THROW(sharedRenderer().renderer->render(options, {Aov::Radiance}), UsageError);
}

}  // namespace
}  // namespace opaline
