// What rough surfaces mirror of a scene, against quadrature over the lobe of GGX.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"

namespace opaline {
namespace {

using namespace test;
using std::numbers::pi;

// A rectangle across an axis.
struct Wall {
  std::size_t axis;
  double at;
  Vector least;
  Vector most;

  bool isMet(const Vector& from, const Vector& direction) const {
    const double distance = (at - from[axis]) / direction[axis];
    if (!(distance > 0)) return false;
    const Vector place = from + distance * direction;
    for (std::size_t i = 0; i < 3; ++i)
      if (i != axis && (place[i] < least[i] || place[i] > most[i])) return false;
    return true;
  }

  Mesh mesh() const {
    const Vector middle = 0.5 * (least + most);
    Vec3 centre = toVec3(middle);
    centre[axis] = static_cast<float>(at);
    std::array<Vec3, 2> sides{};
    for (std::size_t i = 0, side = 0; i < 3; ++i)
      if (i != axis) sides[side++][i] = static_cast<float>(0.5 * (most[i] - least[i]));
    return sheet(centre, sides[0], sides[1], 6);
  }
};

// The share of the rays of a horizontal surface's lobe that meet no wall (Walter et al. 2007,
// equations 35 and 36).
double shareOfSky(const std::vector<Wall>& walls, const Vector& place, const Vector& toCamera,
                  double alpha) {
  constexpr int steps = 96;
  int sent = 0;
  int free = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const double u = (i + 0.5) / steps;
      const double angle = 2 * pi * (j + 0.5) / steps;
      const double tangent = alpha * std::sqrt(u / (1 - u));
      const Vector facet = unit({tangent * std::cos(angle), 1, tangent * std::sin(angle)});
      const Vector direction = 2 * dot(facet, toCamera) * facet - toCamera;
      if (direction[1] <= 0) continue;
      ++sent;
      bool meets = false;
      for (const Wall& wall : walls) meets = meets || wall.isMet(place, direction);
      if (!meets) ++free;
    }
  return static_cast<double>(free) / sent;
}

const Wall endWall{2, -5, {-5, 0, -5}, {5, 4, -5}};
const Wall leftWall{0, -3, {-3, 0, -5}, {-3, 6, 5}};
const Wall rightWall{0, 3, {3, 0, -5}, {3, 6, 5}};

// A floor at y = 0 under an even sky, with black walls.
Scene floorWith(const std::vector<Wall>& walls, const Medium& medium) {
  Scene scene = sceneOf(sheet({0, 0, 0}, {0, 0, 5}, {5, 0, 0}, 6), medium, {0.5F, 7, 14}, 7);
  for (const Wall& wall : walls) {
    scene.objects.push_back({.name = "wall", .mesh = wall.mesh(), .medium = marble()});
    scene.objects.back().opaque = OpaqueMaterial{};
    scene.objects.back().opaque->baseColor = {0, 0, 0};
  }
  scene.lighting.ambient = {1, 1, 1};
  return scene;
}

struct Differences {
  double rms = 0;
  double most = 0;
};

class MirroredSceneTest : public RendererTest {
 protected:
  // Between the share of sky that pixels of the floor mirror and that by quadrature.
  Differences differences(Scene scene, const std::vector<Wall>& walls, float roughness) {
    const double alpha = static_cast<double>(roughness) * static_cast<double>(roughness);
    RenderOptions options = smallOptions();
    options.transport = Transport::Boundary;
    options.width = options.height = 96;
    options.roughness = roughness;
    const auto images = render(scene, options, {Aov::Radiance, Aov::Position});
    scene.objects.resize(1);
    const Image open = render(scene, options, {Aov::Radiance})[0];
    Differences found;
    int seen = 0;
    forEachCovered(images[1], [&](std::size_t i) {
      const Vector place = toVector(&images[1].rgba[i]);
      const bool onFloor =
          std::abs(place[1]) < 1e-3 && std::abs(place[0]) < 2.5 && std::abs(place[2]) < 4;
      if (!onFloor || open.rgba[i] == 0) return;
      const Vector toCamera = unit(toVector(scene.camera.positionMm) - place);
      const double share =
          static_cast<double>(images[0].rgba[i]) / static_cast<double>(open.rgba[i]);
      const double off = share - shareOfSky(walls, place, toCamera, alpha);
      found.rms += off * off;
      found.most = std::max(found.most, std::abs(off));
      ++seen;
    });
    EXPECT_GT(seen, 300);
    found.rms = std::sqrt(found.rms / seen);
    return found;
  }
};

TEST_F(MirroredSceneTest, MetalMirrorsWhatItsLobeSees) {
  for (const float roughness : {0.25F, 0.35F, 0.5F, 0.8F})
    for (const std::vector<Wall>& walls : {std::vector{endWall}, {leftWall, rightWall}}) {
      Scene scene = floorWith(walls, marble());
      scene.objects.front().opaque = OpaqueMaterial{};
      scene.objects.front().opaque->metallic = 1;
      scene.objects.front().opaque->roughness = roughness;
      const Differences found = differences(scene, walls, roughness);
      EXPECT_LT(found.rms, 0.07) << roughness << ' ' << walls.size();
      EXPECT_LT(found.most, 0.2) << roughness << ' ' << walls.size();
    }
}

// Its reflection is a twentieth of metal's, and has fewer rays.
TEST_F(MirroredSceneTest, TranslucentBodiesMirrorWhatTheirLobeSees) {
  // Nothing scatters back out of it, so that only the reflection is visible.
  const Medium black{"black", {1e-6, 1e-6, 1e-6}, {1, 1, 1}, 1.5};
  for (const float roughness : {0.25F, 0.35F, 0.5F})
    for (const std::vector<Wall>& walls : {std::vector{endWall}, {leftWall, rightWall}}) {
      const Differences found = differences(floorWith(walls, black), walls, roughness);
      EXPECT_LT(found.rms, 0.15) << roughness << ' ' << walls.size();
      EXPECT_LT(found.most, 0.4) << roughness << ' ' << walls.size();
    }
}

// A polished floor shows the wall of translucent stuff that stands on it as bright as that is.
// Half-spaces know its light at places that are seen, but the mirror needs it everywhere.
TEST_F(MirroredSceneTest, MetalMirrorsHalfSpaces) {
  const Medium medium{"wall", {0.5, 0.6, 0.7}, {0.05, 0.06, 0.07}, 1.3};
  Scene scene = floorWith({}, marble());
  scene.lighting = {};
  scene.lighting.directional = {{{0, 0, 1}, {3, 2, 1}}};
  scene.objects[0].opaque = OpaqueMaterial{};
  scene.objects[0].opaque->baseColor = {1, 1, 1};
  scene.objects[0].opaque->metallic = 1;
  scene.objects[0].opaque->roughness = 0;
  scene.objects.push_back(
      {.name = "wall", .mesh = box({0, 0, -10}, {40, 40, 5}, 24), .medium = medium});
  for (const Transport transport : {Transport::Dipole, Transport::BetterDipole}) {
    RenderOptions options = smallOptions();
    options.transport = transport;
    options.width = options.height = 96;
    options.maxSurfels = 65'536;
    const auto images = render(scene, options, {Aov::Radiance, Aov::Object, Aov::Exitance});
    std::array<double, 3> wall{};
    int ofWall = 0;
    forEachCovered(images[1], [&](std::size_t i) {
      if (images[1].rgba[i] != 1) return;
      ++ofWall;
      for (std::size_t c = 0; c < 3; ++c) wall[c] += static_cast<double>(images[2].rgba[i + c]);
    });
    ASSERT_GT(ofWall, 100);
    int ofFloor = 0;
    forEachCovered(images[1], [&](std::size_t i) {
      if (images[1].rgba[i] != 0 || images[1].rgba[i + 3] < 1) return;
      ++ofFloor;
      for (std::size_t c = 0; c < 3; ++c) {
        const double expected = wall[c] / ofWall / pi;
        EXPECT_NEAR(images[0].rgba[i + c], expected, 0.03 * expected) << i / 4 << ' ' << c;
      }
    });
    EXPECT_GT(ofFloor, 1000);
    // Light that was found for exitance alone lacks what is mirrored.
    Lighting brighter = scene.lighting;
    brighter.directional[0].irradiance = {6, 4, 2};
    renderer().setLighting(brighter);
    View view(renderer(), options);
    view.render({.aovs = {Aov::Exitance}});
    const Image after = view.render({.reuseLight = true}).images[0];
    EXPECT_EQ(after.rgba, view.render().images[0].rgba);
  }
}

}  // namespace
}  // namespace opaline
