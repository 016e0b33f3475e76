// The reflection of the sky where the scene is in its way.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"

namespace opaline {
namespace {

using namespace test;

using ReflectedSkyTest = RendererTest;

constexpr double eta = 1.5;

// Nothing comes out of it or through it, so that only the reflection is visible.
Medium black() {
  return {"black", {1e-6, 1e-6, 1e-6}, {20, 20, 20}, eta};
}

double fresnel(double cosine) {
  const double inside = std::sqrt(1 - (1 - cosine * cosine) / (eta * eta));
  const double s = (cosine - eta * inside) / (cosine + eta * inside);
  const double p = (eta * cosine - inside) / (eta * cosine + inside);
  return 0.5 * (s * s + p * p);
}

// A floor at y = 0 and a wall at its end, 4 mm high, under an even sky.
Scene floorAndWall(const Mesh& mesh) {
  Scene scene = sceneOf(mesh, black(), {2, 7, 14}, 7);
  scene.lighting.ambient = {1, 1, 1};
  return scene;
}

Mesh closedMesh() {
  return together(box({0, -0.5F, 0}, {5, 0.5F, 5}, 6), box({0, 1.5F, -5.5F}, {5, 2.5F, 0.5F}, 6));
}

Mesh openMesh() {
  return together(sheet({0, 0, 0}, {0, 0, 5}, {5, 0, 0}, 6),
                  sheet({0, 2, -5}, {5, 0, 0}, {0, 2, 0}, 6));
}

RenderOptions mirror() {
  RenderOptions options;
  options.width = options.height = 96;
  options.roughness = 0.05F;
  options.maxSurfels = 4096;
  options.dsmSize = 128;
  return options;
}

// Whether the ray that the floor mirrors there misses the wall. None near a change, at the floor's
// edges, or off the floor.
std::optional<bool> mirrorsSky(const Vector& place, const Vector& toCamera) {
  if (std::abs(place[1]) > 1e-3 || std::max(std::abs(place[0]), std::abs(place[2])) > 4.5)
    return std::nullopt;
  const Vector direction{-toCamera[0], toCamera[1], -toCamera[2]};
  const double distance = (-5 - place[2]) / direction[2];
  const Vector meets = place + distance * direction;
  const double inside = std::min(4 - meets[1], 5 - std::abs(meets[0]));
  if (std::abs(inside) < 0.5) return std::nullopt;
  return inside < 0;
}

// Every pixel of the floor must have all of the sky's reflection or none.
void expectWallMirrored(const Scene& scene, const std::vector<Image>& images) {
  std::array<int, 2> seen{};
  forEachCovered(images[1], [&](std::size_t i) {
    const Vector place = toVector(&images[1].rgba[i]);
    const Vector toCamera = unit(toVector(scene.camera.positionMm) - place);
    const std::optional<bool> sky = mirrorsSky(place, toCamera);
    if (!sky) return;
    ++seen[*sky ? 1 : 0];
    ASSERT_NEAR(static_cast<double>(images[0].rgba[i]), *sky ? fresnel(toCamera[1]) : 0, 0.004)
        << place[0] << ' ' << place[2];
  });
  EXPECT_GT(seen[0], 200);
  EXPECT_GT(seen[1], 200);
}

TEST_F(ReflectedSkyTest, EndsWhereTheMirroredRayMeetsAWall) {
  const Scene scene = floorAndWall(closedMesh());
  renderer().setScene(scene);
  RenderOptions options = mirror();
  for (const Transport transport : {Transport::Boundary, Transport::BetterDipole})
    for (const Sum sum : {Sum::Tree, Sum::All}) {
      options.transport = transport;
      options.sum = sum;
      expectWallMirrored(scene, render(options, {Aov::Radiance, Aov::Position}));
    }
}

// This method has no surfels for rays to meet, and spends no time on them.
TEST_F(ReflectedSkyTest, IsWholeUnderTheMethodOf2008) {
  const Scene scene = floorAndWall(closedMesh());
  RenderOptions options = mirror();
  options.transport = Transport::Dipole;
  options.sum = Sum::Pattern;
  const auto images = render(scene, options, {Aov::Radiance, Aov::Position});
  int seen = 0;
  forEachCovered(images[1], [&](std::size_t i) {
    const Vector place = toVector(&images[1].rgba[i]);
    const Vector toCamera = unit(toVector(scene.camera.positionMm) - place);
    if (!mirrorsSky(place, toCamera)) return;
    ++seen;
    ASSERT_NEAR(static_cast<double>(images[0].rgba[i]), fresnel(toCamera[1]), 0.004);
  });
  EXPECT_GT(seen, 400);
}

TEST_F(ReflectedSkyTest, EndsAtOpenMeshesToo) {
  const Scene scene = floorAndWall(openMesh());
  expectWallMirrored(scene, render(scene, mirror(), {Aov::Radiance, Aov::Position}));
}

TEST_F(ReflectedSkyTest, FollowsTheBodyAsItMoves) {
  Scene scene = floorAndWall(openMesh());
  scene.deformers = {{DeformerKind::Bend, 0.6F, 4}};
  RenderOptions options = mirror();
  options.transport = Transport::BetterDipole;
  View view(renderer());
  const auto at = [&](double seconds, bool specular) {
    options.specular = specular;
    view.setOptions(options);
    renderer().setTime({.seconds = seconds});
    return view.render({.reuseLight = true}).images[0].rgba;
  };
  renderer().setScene(scene);
  const auto rest = at(0, true);
  const auto bent = at(1, true);
  EXPECT_FALSE(rest == bent);
  // Light is found without the reflection first, and reused for the picture with it.
  static_cast<void>(at(0, false));
  EXPECT_TRUE(at(0, true) == rest);
  static_cast<void>(at(1, false));
  EXPECT_TRUE(at(1, true) == bent);
}

// A mirrored part of the scene is taken to be as bright as the mirroring surface, M/π. A surface
// that reflects all light of an even sky then looks like that sky.
TEST_F(ReflectedSkyTest, TheSceneIsMirroredAsBrightAsTheSurface) {
  Scene scene = floorAndWall(openMesh());
  scene.objects.front().medium = {"white", {1, 1, 1}, {0.01, 0.01, 0.01}, eta};
  Lighting lamp;
  lamp.directional.push_back({toVec3(unit({0.3, 0.8, 0.5})), {3, 3, 3}});
  for (const Lighting& lighting : {scene.lighting, lamp}) {
    SCOPED_TRACE(lighting.directional.size());
    scene.lighting = lighting;
    RenderOptions options = mirror();
    const auto images = render(scene, options, {Aov::Radiance, Aov::Position, Aov::Exitance});
    options.specular = false;
    const Image plain = render(options, {Aov::Radiance})[0];
    int seen = 0;
    forEachCovered(images[1], [&](std::size_t i) {
      const Vector place = toVector(&images[1].rgba[i]);
      const Vector toCamera = unit(toVector(scene.camera.positionMm) - place);
      if (mirrorsSky(place, toCamera).value_or(true)) return;
      ++seen;
      const auto own = static_cast<double>(images[2].rgba[i]) / std::numbers::pi;
      EXPECT_NEAR(static_cast<double>(images[0].rgba[i] - plain.rgba[i]),
                  fresnel(toCamera[1]) * own, 0.004);
    });
    EXPECT_GT(seen, 200);
  }
}

}  // namespace
}  // namespace opaline
