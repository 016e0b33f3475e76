// Open opaque surfaces, whose two sides see different light.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"

namespace opaline {
namespace {

using namespace test;
using std::numbers::pi;

constexpr float halfMm = 10;

/// Black below the horizon.
std::shared_ptr<const Image> skyAbove(float radiance, int height = 32) {
  Image image(2 * height, height);
  for (int y = 0; y < height / 2; ++y)
    for (int x = 0; x < 2 * height; ++x)
      for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = radiance;
  return std::make_shared<const Image>(std::move(image));
}

class SheetTest : public RendererTest {
 protected:
  static RenderOptions options() {
    RenderOptions options = smallOptions();
    options.transport = Transport::Boundary;
    options.width = options.height = 32;
    options.antialias = 1;
    options.specular = false;
    options.maxSurfels = 8192;
    return options;
  }

  // Level and white, with its front up.
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

  Image irradiance(const Scene& scene) { return render(scene, options(), {Aov::Exitance})[0]; }
};

TEST_F(SheetTest, ItsUpperSideSeesTheSkyAndItsLowerSideWhatIsBelow) {
  Scene above = seen({level(0)}, {0, 40, 0});
  above.lighting.environment = skyAbove(2);
  Scene below = above;
  below.camera.positionMm = {0, -40, 0};
  const Image ofAbove = irradiance(above);
  const Image ofBelow = irradiance(below);
  int count = forEachCovered(
      ofAbove, [&](std::size_t i) { EXPECT_NEAR(double{ofAbove.rgba[i]}, 2 * pi, 0.02 * pi); });
  count += forEachCovered(
      ofBelow, [&](std::size_t i) { EXPECT_NEAR(double{ofBelow.rgba[i]}, 0, 0.02 * pi); });
  EXPECT_GT(count, 800);
}

// A square that faces another, over its middle (Howell, B-4, four times).
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

// Which way its triangles go round makes no difference to what it sends to others: of the sky, of
// lamps on either side of it, and of what comes back.
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

}  // namespace
}  // namespace opaline
