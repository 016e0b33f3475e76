// Opaque materials, against closed forms.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "renderer/opaque_fixture.h"
#include "renderer/shapes.h"

namespace opaline {
namespace {

using namespace test;
using std::numbers::pi;

// With alpha² = a², and cosines to the half vector, the light and the eye.
double ggx(double alpha, double half, double in, double out) {
  const double a2 = alpha * alpha;
  const double t = half * half * (a2 - 1) + 1;
  const double distribution = a2 / (pi * t * t);
  const auto lambda = [&](double c) { return 0.5 * (std::sqrt(1 + a2 * (1 / (c * c) - 1)) - 1); };
  return distribution / ((1 + lambda(in) + lambda(out)) * 4 * in * out);
}

// What a GGX surface with F = 1 mirrors once of even light, summed over the hemisphere of half
// vectors.
double mirroredOnce(double alpha, double out) {
  constexpr int steps = 400;
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const double cosine = (i + 0.5) / steps;
      const double angle = 2 * pi * (j + 0.5) / steps;
      const double sine = std::sqrt(1 - cosine * cosine);
      const double outSine = std::sqrt(1 - out * out);
      const Vector in{sine * std::cos(angle), sine * std::sin(angle), cosine};
      const Vector middle{in[0] + outSine, in[1], in[2] + out};
      const double length = std::sqrt(dot(middle, middle));
      sum += ggx(alpha, middle[2] / length, cosine, out) * cosine;
    }
  return sum * 2 * pi / (steps * steps);
}

TEST_F(OpaqueTest, MetalMirrorsLightsByGgx) {
  for (const double roughness : {0.6, 1.0}) {
    OpaqueMaterial metal;
    metal.baseColor = {1, 0.5F, 0.25F};
    metal.metallic = 1;
    metal.roughness = static_cast<float>(roughness);
    Scene scene = squareOf(metal);
    const double in = 0.8;
    scene.lighting.directional.push_back({{0.6F, 0, 0.8F}, {1, 1, 1}});
    const double half = std::sqrt((1 + in) / 2);
    const double alpha = roughness * roughness;
    const double once = ggx(alpha, half, in, 1) * in;
    const double sent = 1 / mirroredOnce(alpha, 1) - 1;
    const Vector found = radianceAt(scene, 16, 16);
    for (std::size_t c = 0; c < 3; ++c) {
      const double head = metal.baseColor[c];
      const double fresnel = head + (1 - head) * std::pow(1 - half, 5);
      EXPECT_NEAR(found[c] / (once * fresnel * (1 + head * sent)), 1, 0.01) << roughness;
    }
  }
}

// glTF 2.0, appendix B: between metal and dielectric the two are mixed, not their numbers.
TEST_F(OpaqueTest, HalfMetalIsTheMeanOfMetalAndDielectric) {
  OpaqueMaterial material;
  material.baseColor = {0.8F, 0.4F, 0.1F};
  material.roughness = 0.6F;
  const auto found = [&](float metallic) {
    material.metallic = metallic;
    Scene scene = squareOf(material);
    scene.lighting.directional.push_back({{0.6F, 0, 0.8F}, {2, 2, 2}});
    scene.lighting.ambient = {0.3F, 0.3F, 0.3F};
    return radianceAt(scene, 16, 16);
  };
  const Vector dielectric = found(0);
  const Vector metal = found(1);
  const Vector mixed = found(0.25F);
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(mixed[c] / (0.75 * dielectric[c] + 0.25 * metal[c]), 1, 1e-4);
}

// A white material that absorbs nothing is invisible in a white furnace.
TEST_F(OpaqueTest, NothingIsLostInAWhiteFurnace) {
  for (const float metallic : {0.0F, 0.5F, 1.0F})
    for (const float roughness : {0.1F, 0.5F, 1.0F}) {
      OpaqueMaterial white;
      white.baseColor = {1, 1, 1};
      white.metallic = metallic;
      white.roughness = roughness;
      Scene scene = squareOf(white);
      scene.lighting.ambient = {1, 1, 1};
      EXPECT_NEAR(radianceAt(scene, 12, 17)[0], 1, 0.01) << metallic << " " << roughness;
    }
}

// A smooth surface without F₀ mirrors nothing head-on, and lookups beyond a table's ends are
// clamped.
TEST_F(OpaqueTest, WhatMirrorsNothingHeadOnIsNotBelowBlack) {
  for (const float roughness : {0.0F, 0.05F, 0.1F, 0.2F, 0.4F, 0.7F, 1.0F}) {
    OpaqueMaterial black;
    black.baseColor = {0, 0, 0};
    black.specularColor = {1, 1, 0};
    black.roughness = roughness;
    Scene scene = squareOf(black);
    scene.lighting.ambient = {1, 1, 1};
    const Vector found = radianceAt(scene, 12, 17);
    EXPECT_GE(found[2], 0) << roughness;
    EXPECT_GT(found[0], 0.01) << roughness;
  }
}

// A large luminous plane over a matt one: irradiance π L, less at the rim.
TEST_F(OpaqueTest, EmissionLightsWhatLiesBefore) {
  OpaqueMaterial lamp = mattMaterial({0, 0, 0});
  lamp.emission = {2, 1, 0.5F};
  Scene scene = squareOf(lamp);
  EXPECT_NEAR(radianceAt(scene, 16, 16)[0], 2, 1e-3);
  Scene both = squareOf(mattMaterial({0.5F, 0.5F, 0.5F}));
  both.objects.push_back(scene.objects[0]);
  // A third of the edge above, facing down. The camera looks from below it.
  constexpr float above = 2 * halfEdgeMm / 3;
  Mesh& mesh = both.objects[1].mesh;
  for (std::size_t v = 0; v < mesh.positionsMm.size(); ++v) {
    mesh.positionsMm[v][2] = above;
    mesh.normals[v] = {0, 0, -1};
  }
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  both.camera.positionMm = {0, 0, 0.99F * above};
  both.camera.verticalFovDegrees = 10;
  // A square plate over the middle of another (Howell, B-4, four times).
  const double x = static_cast<double>(halfEdgeMm / above);
  const double root = std::sqrt(1 + x * x);
  const double factor = 4 * x / root * std::atan(x / root) / pi;
  RenderOptions options = finelyDivided(OpaqueTest::options());
  options.bounces = 1;
  const Vector found =
      toVector(render(both, options, {Aov::Radiance})[0].pixel(edgePixels / 2, edgePixels / 2));
  EXPECT_NEAR(found[0], 0.5 * factor * 2, 0.03 * factor);
  EXPECT_NEAR(found[2], 0.5 * factor * 0.5, 0.01 * factor);
}

// A lamp so small that few rays from a place hit it: E by quadrature over its square, without
// noise.
TEST_F(OpaqueTest, LightOfSmallThingsIsEven) {
  OpaqueMaterial lamp = mattMaterial({0, 0, 0});
  lamp.emission = {1, 1, 1};
  Scene scene = squareOf(mattMaterial({1, 1, 1}));
  scene.objects.push_back(squareOf(lamp).objects[0]);
  constexpr float above = 0.6F * halfEdgeMm;
  constexpr float part = 0.15F;
  Mesh& mesh = scene.objects[1].mesh;
  for (std::size_t v = 0; v < mesh.positionsMm.size(); ++v) {
    mesh.positionsMm[v] = {part * mesh.positionsMm[v][0], part * mesh.positionsMm[v][1], above};
    mesh.normals[v] = {0, 0, -1};
  }
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  const auto irradiance = [](const Vector& at) {
    constexpr int parts = 16;
    constexpr double half = static_cast<double>(part * halfEdgeMm);
    double sum = 0;
    for (int i = 0; i < parts; ++i)
      for (int k = 0; k < parts; ++k) {
        const double x = half * (2 * (i + 0.5) / parts - 1) - at[0];
        const double y = half * (2 * (k + 0.5) / parts - 1) - at[1];
        const double z{above};
        sum += z * z / std::pow(x * x + y * y + z * z, 2);
      }
    return 4 * half * half * sum / (parts * parts);
  };
  RenderOptions options = finelyDivided(OpaqueTest::options());
  options.bounces = 1;
  const auto images = render(scene, options, {Aov::Radiance, Aov::Position, Aov::Object});
  double squares = 0;
  double all = 0;
  int count = 0;
  for (int y = 0; y < edgePixels; ++y)
    for (int x = 0; x < edgePixels; ++x) {
      if (images[2].pixel(x, y)[0] != 0) continue;
      const double expected = irradiance(toVector(images[1].pixel(x, y))) / pi;
      squares += std::pow(double{images[0].pixel(x, y)[1]} - expected, 2);
      all += expected;
      ++count;
    }
  ASSERT_GT(count, 800);
  EXPECT_LT(std::sqrt(squares / count), 0.15 * all / count);
}

// Inside a luminous matt ball all is L + ρL + ρ²L + …, including bounces that are not traced.
TEST_F(OpaqueTest, LightGoesRoundInAHollowBall) {
  Mesh hollow = sphere({0, 0, 0}, 10, 4);
  for (Vec3& normal : hollow.normals) normal = {-normal[0], -normal[1], -normal[2]};
  for (Triangle& t : hollow.triangles) std::swap(t[1], t[2]);
  Scene scene = sceneOf(hollow, marble(), {0, 0, 4}, 10);
  scene.objects[0].opaque = mattMaterial({0.5F, 0.7F, 0});
  scene.objects[0].opaque->emission = {1, 1, 1};
  scene.camera.verticalFovDegrees = 40;
  const Image image = render(scene, options(), {Aov::Radiance})[0];
  for (const int x : {2, edgePixels / 2, edgePixels - 3}) {
    const Vector found = toVector(image.pixel(x, edgePixels / 2));
    EXPECT_NEAR(found[0], 2, 0.03);
    EXPECT_NEAR(found[1], 1 / 0.3, 0.06);
    EXPECT_NEAR(found[2], 1, 1e-3);
  }
}

// Rays pass cut-out surfaces: light of a panel and of the sky goes through a plate that is all
// hole.
TEST_F(OpaqueTest, LightPassesWhatIsCutOut) {
  OpaqueMaterial hole = mattMaterial({1, 1, 1});
  Texture texture;
  texture.pixels = texturePixels(1, {{1, 1, 1, 0.2}});
  hole.baseColorTexture = texture;
  Scene scene = squareOf(mattMaterial({0.5F, 0.5F, 0.5F}));
  scene.lighting.ambient = {0.2F, 0.2F, 0.2F};
  scene.lighting.areas = {RectangleLight{{0, 0, 30}, {0, 10, 0}, {10, 0, 0}, {1, 1, 1}}};
  scene.camera.positionMm = {300, 0, 30};  // sees the middle below the plate
  const Vector open = radianceAt(scene, edgePixels / 2, edgePixels / 2);
  EXPECT_GT(open[1], 0.1);
  scene.objects.push_back(squareOf(hole).objects[0]);
  for (Vec3& place : scene.objects[1].mesh.positionsMm) place[2] = 5;
  EXPECT_LT(radianceAt(scene, edgePixels / 2, edgePixels / 2)[1], 0.9 * open[1]);
  scene.objects[1].opaque->alphaCutoff = 0.5F;
  EXPECT_NEAR(radianceAt(scene, edgePixels / 2, edgePixels / 2)[1], open[1], 0.01 * open[1]);
}

TEST_F(OpaqueTest, UnlitIsItsColourWhateverTheLight) {
  OpaqueMaterial material;
  material.baseColor = {0.3F, 0.6F, 0.9F};
  material.unlit = true;
  Scene scene = squareOf(material);
  scene.lighting.directional.push_back({{0, 0, 1}, {50, 50, 50}});
  const Vector found = radianceAt(scene, 5, 5);
  EXPECT_NEAR(found[0], 0.3, 1e-4);
  EXPECT_NEAR(found[2], 0.9, 1e-4);
}

// A surface that sees all of an even sky gives back its share of that light, whatever lies close
// below, within 2 %.
TEST_F(OpaqueTest, NothingBelowTakesLightOfTheSky) {
  const OpaqueMaterial white = mattMaterial({0.8F, 0.8F, 0.8F});
  const auto expectEven = [&](Scene scene) {
    for (Object& object : scene.objects) object.opaque = white;
    scene.lighting.ambient = {1, 1, 1};
    const Image image = render(scene, finelyDivided(OpaqueTest::options()), {Aov::Radiance})[0];
    for (int y = 4; y < edgePixels - 4; ++y)
      for (int x = 4; x < edgePixels - 4; ++x)
        ASSERT_NEAR(image.pixel(x, y)[1] / 0.8F, 1, 0.02F) << x << " " << y;
  };
  // A label: two open sheets back to back, away from their borders.
  const Mesh label = together(sheet({0, 0, 0}, {25, 0, 0}, {0, 5, 0}, 1),
                              sheet({0, 0, -0.2F}, {0, 5, 0}, {25, 0, 0}, 1));
  expectEven(sceneOf(label, marble(), {0, 0, 200}, 2));
  // A book on a table, as thick as the table's surfels are large.
  Scene book = sceneOf(box({0, 0, 3.1F}, {60, 40, 3}, 1), marble(), {0, 0, 1000}, 30);
  book.objects.push_back(
      sceneOf(box({0, 0, -10}, {250, 100, 10}, 1), marble(), {0, 0, 1}, 1).objects[0]);
  expectEven(book);
  // Both as one object, away from the book's borders.
  book.objects[0].mesh = together(book.objects[0].mesh, book.objects[1].mesh);
  book.objects.pop_back();
  book.camera.verticalFovDegrees = 2;
  expectEven(book);
}

}  // namespace
}  // namespace opaline
