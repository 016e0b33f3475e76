// Open opaque surfaces, whose sides see different light, and light that goes through them.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>

#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"

namespace opaline {
namespace {

using namespace test;
using std::numbers::pi;

constexpr float halfMm = 10;

/// Light from above the horizon only.
std::shared_ptr<const Image> skyAbove(float radiance, int height = 32) {
  Image image(2 * height, height);
  for (int y = 0; y < height / 2; ++y)
    for (int x = 0; x < 2 * height; ++x)
      for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = radiance;
  return std::make_shared<const Image>(std::move(image));
}

class SheetTest : public RendererTest {
 protected:
  RenderOptions options() const {
    RenderOptions options = smallOptions();
    options.transport = Transport::Boundary;
    options.width = options.height = 32;
    options.antialias = 1;
    options.specular = false;
    options.maxSurfels = maxSurfels_;
    return options;
  }

  int maxSurfels_ = 8192;

  // A white horizontal sheet with its front up.
  static Object level(float heightMm, float half = halfMm) {
    Object object{.name = "sheet",
                  .mesh = sheet({0, heightMm, 0}, {0, 0, half}, {half, 0, 0}),
                  .medium = marble()};
    object.opaque = mattMaterial({1, 1, 1});
    return object;
  }

  static Scene seen(std::vector<Object> objects, const Vec3& fromMm) {
    Scene scene;
    scene.objects = std::move(objects);
    scene.camera = {fromMm, {}, {0, 0, 1}, 20};
    return scene;
  }

  static void turnOver(Mesh& mesh) {
    for (Vec3& normal : mesh.normals) normal = {-normal[0], -normal[1], -normal[2]};
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  }

  Image irradiance(const Scene& scene, Site site = Site::Auto) const {
    RenderOptions how = options();
    how.site = site;
    return render(scene, how, {Aov::Exitance})[0];
  }
};

TEST_F(SheetTest, ItsUpperSideSeesTheSkyAndItsLowerSideWhatIsBelow) {
  Scene above = seen({level(0)}, {0, 40, 0});
  above.lighting.environment = skyAbove(2);
  Scene below = above;
  below.camera.positionMm = {0, -40, 0};
  for (const Site site : {Site::Fragment, Site::Vertex}) {
    const Image ofAbove = irradiance(above, site);
    const Image ofBelow = irradiance(below, site);
    int count = forEachCovered(
        ofAbove, [&](std::size_t i) { EXPECT_NEAR(double{ofAbove.rgba[i]}, 2 * pi, 0.02 * pi); });
    count += forEachCovered(
        ofBelow, [&](std::size_t i) { EXPECT_NEAR(double{ofBelow.rgba[i]}, 0, 0.02 * pi); });
    EXPECT_GT(count, 800);
  }
}

// Lamps of either kind do not light the side that faces away.
TEST_F(SheetTest, LampsShineOnOneSideAlone) {
  Scene scene = seen({level(0)}, {0, 40, 0});
  scene.lighting.directional = {{{0, 1, 0}, {1, 0, 0}}};
  scene.lighting.areas = {DiscLight{{0, 30, 0}, {0, -1, 0}, 3, {0, 9, 0}}};
  for (const Site site : {Site::Fragment, Site::Vertex}) {
    scene.camera.positionMm = {0, 40, 0};
    const Vector above = toVector(irradiance(scene, site).pixel(16, 16));
    EXPECT_NEAR(above[0], 1, 1e-3);
    EXPECT_NEAR(above[1], 9 * pi * 9 / (9 + 900), 0.01 * pi * 9 * 9 / 909);
    scene.camera.positionMm = {0, -40, 0};
    const Vector below = toVector(irradiance(scene, site).pixel(16, 16));
    EXPECT_EQ(below[0] + below[1], 0);
  }
}

// A square facing another, over its middle (Howell, B-4, four times).
TEST_F(SheetTest, ARedFloorShinesOnItsLowerSideAlone) {
  Object floor = level(-5);
  floor.opaque = mattMaterial({0, 0, 0});
  floor.opaque->emission = {3, 0.5F, 0};
  Scene scene = seen({level(0, 1), floor}, {0, -4, 0});
  const double x = 2.0;
  const double root = std::sqrt(1 + x * x);
  const double factor = 4 * x / root * std::atan(x / root) / pi;
  const Vector below = toVector(irradiance(scene).pixel(16, 16));
  EXPECT_NEAR(below[0], 3 * pi * factor, 0.03 * 3 * pi * factor);
  EXPECT_NEAR(below[1], 0.5 * pi * factor, 0.03 * 0.5 * pi * factor);
  EXPECT_NEAR(below[2], 0, 1e-6);
  scene.camera.positionMm = {0, 40, 0};
  scene.camera.verticalFovDegrees = 2;
  EXPECT_NEAR(double{irradiance(scene).pixel(16, 16)[0]}, 0, 1e-3);
}

// The orientation of its triangles does not matter for the light that it sends to others: light of
// the sky, of lamps on either side, and what returns.
TEST_F(SheetTest, TurnedOverItIsTheSame) {
  const auto sky = skyAbove(0.3F);
  const auto irradiances = [&](bool turned, const Vec3& camera) {
    Object roof = level(6, 8);
    Object floor = level(-6);
    if (turned) turnOver(roof.mesh);
    Scene scene = seen({roof, floor}, camera);
    scene.lighting.environment = sky;
    scene.lighting.points.push_back({{1, 2, -1}, {60, 90, 120}});
    scene.lighting.areas = {DiscLight{{0, 20, 0}, {0, -1, 0}, 3, {9, 6, 3}},
                            SphereLight{{-3, -1, 2}, 1, {4, 8, 2}}};
    return irradiance(scene);
  };
  for (const Vec3& camera : {Vec3{14, 15, 9}, Vec3{3, -4, 2}}) {
    const Image once = irradiances(false, camera);
    const Image turned = irradiances(true, camera);
    double squares = 0;
    double sum = 0;
    const int count = forEachCovered(once, [&](std::size_t i) {
      squares += std::pow(double{once.rgba[i]} - double{turned.rgba[i]}, 2);
      sum += double{once.rgba[i]};
    });
    ASSERT_GT(count, 100);
    EXPECT_LT(std::sqrt(squares / count), 0.01 * sum / count) << camera[0];
  }
}

/// Sheets that let light through.
class TransmissionTest : public SheetTest {
 protected:
  TransmissionTest() { maxSurfels_ = 2048; }

  static OpaqueMaterial leaf(const Rgb& base, float through, const Rgb& color) {
    OpaqueMaterial material = mattMaterial(base);
    material.diffuseTransmission = through;
    material.diffuseTransmissionColor = color;
    return material;
  }

  static Object leafAt(float heightMm, const OpaqueMaterial& material, float half = halfMm) {
    Object object = level(heightMm, half);
    object.opaque = material;
    return object;
  }

  static Object ball(const OpaqueMaterial& material) {
    Object object{.name = "ball", .mesh = sphere({0, 0, 0}, halfMm, 3), .medium = marble()};
    object.opaque = material;
    return object;
  }

  static void expectMiddle(const Image& image, const Vector& expected, double tolerance) {
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(double{image.pixel(16, 16)[c]}, expected[c], tolerance * expected[c] + 1e-6) << c;
  }
};

// Lambert's law: of E, (1 - t) times the base colour leaves on the lamp's side, and t times the
// transmission's colour on the other.
TEST_F(TransmissionTest, LightOfALampLeavesBothSides) {
  for (const bool turned : {false, true}) {
    Object sheet = leafAt(0, leaf({0.5F, 0.25F, 1}, 0.4F, {0.25F, 1, 0.5F}));
    if (turned) turnOver(sheet.mesh);
    Scene scene = seen({sheet}, {0, 40, 0});
    scene.lighting.directional = {{{0.6F, 0.8F, 0}, {3, 2, 1}}};
    Scene below = scene;
    below.camera.positionMm = {0, -40, 0};
    for (const Site site : {Site::Fragment, Site::Vertex}) {
      expectMiddle(irradiance(scene, site), {0.6 * 0.5 * 2.4, 0.6 * 0.25 * 1.6, 0.6 * 1 * 0.8},
                   1e-4);
      expectMiddle(irradiance(below, site), {0.4 * 0.25 * 2.4, 0.4 * 1 * 1.6, 0.4 * 0.5 * 0.8},
                   1e-4);
    }
  }
}

// Light that the dielectric layer mirrors towards the camera is deducted from both.
TEST_F(TransmissionTest, RadianceIsThatOfTheExitanceLessTheMirror) {
  Scene scene = seen({leafAt(0, leaf({0, 0, 0}, 1, {1, 1, 1}))}, {0, -40, 0});
  scene.lighting.directional = {{{0, 1, 0}, {1, 1, 1}}};
  RenderOptions how = options();
  expectMiddle(render(scene, how, {Aov::Radiance})[0], {1 / pi, 1 / pi, 1 / pi}, 1e-4);
  how.specular = true;
  scene.objects[0].opaque->specular = 1;
  scene.objects[0].opaque->roughness = 0.1F;
  expectMiddle(render(scene, how, {Aov::Radiance})[0], {0.96 / pi, 0.96 / pi, 0.96 / pi}, 0.001);
}

TEST_F(TransmissionTest, LightOfTheSkyAndOfAreaLightsGoesThrough) {
  Scene scene = seen({leafAt(0, leaf({0, 0, 0}, 0.5F, {1, 0.5F, 0}))}, {0, -40, 0});
  scene.lighting.environment = skyAbove(2);
  const double sky = 2 * pi;
  for (const Site site : {Site::Fragment, Site::Vertex})
    expectMiddle(irradiance(scene, site), {0.5 * sky, 0.25 * sky, 0}, 0.01);
  // A disc over the middle: E = π L r² / (r² + h²).
  scene.lighting = {};
  scene.lighting.areas = {DiscLight{{0, 4, 0}, {0, -1, 0}, 3, {9, 9, 9}}};
  const double disc = pi * 9 * 9 / 25;
  for (const Site site : {Site::Fragment, Site::Vertex})
    expectMiddle(irradiance(scene, site), {0.5 * disc, 0.25 * disc, 0}, 0.02);
}

// The factor is multiplied by alpha, the colour by a picture in sRGB, where 0.7354 means a half.
TEST_F(TransmissionTest, TexturesVaryShareAndColor) {
  const auto texel = [](const std::array<std::uint16_t, 4>& rgba) {
    Texture texture;
    texture.pixels = std::make_shared<const TexturePixels>(
        TexturePixels{.width = 1, .height = 1, .rgba = {rgba.begin(), rgba.end()}, .name = {}});
    return texture;
  };
  OpaqueMaterial material = leaf({1, 1, 1}, 1, {1, 1, 0.5F});
  material.diffuseTransmissionTexture = texel({0, 0, 0, 16384});
  material.diffuseTransmissionColorTexture = texel({65535, 48195, 65535, 65535});
  Scene scene = seen({leafAt(0, material)}, {0, -40, 0});
  Mesh& mesh = scene.objects[0].mesh;
  mesh.textureCoordinates[0].resize(mesh.positionsMm.size());
  scene.lighting.directional = {{{0, 1, 0}, {1, 1, 1}}};
  expectMiddle(irradiance(scene), {0.25, 0.125, 0.125}, 0.002);
  scene.camera.positionMm = {0, 40, 0};
  expectMiddle(irradiance(scene), {0.75, 0.75, 0.75}, 0.002);
}

// A roof that mirrors nothing, lit by a lamp above, lights the dark floor in its shadow like a
// luminous square (Howell, B-4, four times).
TEST_F(TransmissionTest, WhatGoesThroughLightsOthers) {
  Object floor = level(-5, 1);
  floor.opaque = mattMaterial({0.01F, 0.01F, 0.01F});
  Scene scene = seen({leafAt(0, leaf({0, 0, 0}, 0.5F, {1, 0.5F, 0.25F})), floor}, {0, -2, 0});
  scene.camera.targetMm = {0, -5, 0};
  scene.lighting.directional = {{{0, 1, 0}, {1, 1, 1}}};
  const double x = 2;
  const double root = std::sqrt(1 + x * x);
  const double expected = 0.01 * 0.5 * 4 * x / root * std::atan(x / root) / pi;
  expectMiddle(irradiance(scene), {expected, 0.5 * expected, 0.25 * expected}, 0.03);
}

// A closed white paper lantern: all light that goes in comes out.
TEST_F(TransmissionTest, AWhiteLanternLosesNoLight) {
  for (const float through : {0.5F, 0.8F}) {
    Scene scene = seen({ball(leaf({1, 1, 1}, through, {1, 1, 1}))}, {0, 0, 60});
    scene.camera.up = {0, 1, 0};
    scene.lighting.points = {{{0, 0, 0}, {700, 700, 700}}};
    // Of even light from inside, all that ever gets out leaves evenly.
    const double expected = 700.0 / (halfMm * halfMm);
    const Image lit = irradiance(scene);
    const int count = forEachCovered(lit, [&](std::size_t i) {
      EXPECT_NEAR(double{lit.rgba[i]}, expected, 0.03 * expected) << through;
    });
    EXPECT_GT(count, 300);
  }
}

TEST_F(TransmissionTest, AWhiteLanternInAWhiteFurnaceIsInvisible) {
  Scene scene = seen({ball(leaf({1, 1, 1}, 0.6F, {1, 1, 1}))}, {0, 0, 60});
  scene.camera.up = {0, 1, 0};
  scene.lighting.ambient = {1, 1, 1};
  const Image lit = irradiance(scene);
  const int count =
      forEachCovered(lit, [&](std::size_t i) { EXPECT_NEAR(double{lit.rgba[i]}, pi, 0.015 * pi); });
  EXPECT_GT(count, 300);
}

// An edit may let light through a body that was closed to it.
TEST_F(TransmissionTest, AClosedBodyMayBecomeALantern) {
  Scene scene = seen({ball(mattMaterial({1, 1, 1}))}, {0, 0, 60});
  scene.camera.up = {0, 1, 0};
  scene.lighting.points = {{{0, 0, 0}, {700, 700, 700}}};
  EXPECT_EQ(double{irradiance(scene).pixel(16, 16)[0]}, 0);
  Material lantern = materialOf(scene.objects[0]);
  lantern.opaque = leaf({1, 1, 1}, 0.5F, {1, 1, 1});
  renderer().setMaterial(0, lantern);
  const Image edited = render(options(), {Aov::Exitance})[0];
  giveMaterial(lantern, scene.objects[0]);
  EXPECT_EQ(edited.rgba, irradiance(scene).rgba);
}

}  // namespace
}  // namespace opaline
