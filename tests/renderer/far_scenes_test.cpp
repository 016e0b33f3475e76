#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include "opaline/renderer.h"
#include "renderer/shapes.h"

namespace opaline::test {
namespace {

// Scenes far from the origin look as they do near it, however places are given. In single
// precision, places 131 m away are 16 µm apart.
constexpr float offsetsMm[] = {1024, 16384, 131072};

// Rounds so that positions are the same numbers everywhere, up to the offset.
float onGrid(float x) {
  constexpr float grid = 1.0F / 64;
  return std::round(x / grid) * grid;
}

Vec3 moved(Vec3 position, float offsetMm) {
  position[0] += offsetMm;
  return position;
}

Mesh ballAt(float offsetMm) {
  Mesh ball = sphere({0, 0, 0}, 5, 3);
  for (Vec3& position : ball.positionsMm) {
    for (float& x : position) x = onGrid(x);
    position = moved(position, offsetMm);
  }
  return ball;
}

Camera cameraAt(float offsetMm) {
  Camera camera;
  camera.positionMm = {offsetMm, 3, 25};
  camera.targetMm = {offsetMm, 0, 0};
  camera.verticalFovDegrees = 30;
  return camera;
}

Scene sceneAt(float offsetMm) {
  Scene scene = sceneOf(ballAt(offsetMm), marble(), {offsetMm, 3, 25}, 6);
  scene.camera = cameraAt(offsetMm);
  scene.lighting.directional = {{{0.6F, 0, 0.8F}, {1, 1, 1}}};
  scene.lighting.points = {{{offsetMm + 20, 10, 0}, {100, 100, 100}}};
  scene.lighting.areas = {SphereLight{.centreMm = {offsetMm - 20, 0, 0}, .radiusMm = 4}};
  return scene;
}

RenderOptions smallOptions(Transport transport = Transport::Boundary) {
  RenderOptions options;
  options.width = options.height = 48;
  options.maxSurfels = 4096;
  options.maxClusters = 256;
  options.shadowSize = 256;
  options.transport = transport;
  return options;
}

// Root mean square difference relative to the first.
double difference(const std::vector<float>& a, const std::vector<float>& b) {
  EXPECT_EQ(a.size(), b.size());
  double apart = 0;
  double all = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double x = static_cast<double>(a[i]);
    const double d = x - static_cast<double>(b[i]);
    apart += d * d;
    all += x * x;
  }
  return std::sqrt(apart / all);
}

// `make` takes an offset. Rounding alone changes the picture of boundary transport by `tolerance`
// at any place.
void expectAlike(const std::function<std::vector<float>(float)>& make, double tolerance = 5e-3) {
  const std::vector<float> here = make(0);
  for (const float offsetMm : offsetsMm)
    EXPECT_LT(difference(here, make(offsetMm)), tolerance) << offsetMm << " mm away";
}

TEST(FarScenes, LookAsNear) {
  for (const Transport transport : {Transport::Dipole, Transport::Boundary})
    expectAlike([&](float offsetMm) {
      Renderer renderer;
      renderer.setScene(sceneAt(offsetMm));
      return renderer.render(smallOptions(transport)).images.at(0).rgba;
    });
}

TEST(FarScenes, NodesAndClipsMoveThem) {
  expectAlike([](float offsetMm) {
    Scene scene = sceneAt(offsetMm);
    Rig rig;
    rig.positions = ballAt(0).positionsMm;
    rig.normals = scene.objects[0].mesh.normals;
    scene.nodes = {{.translation = {offsetMm, 0, 0}}};
    scene.objects[0].rig = rig;
    Track track{.seconds = {0, 1}};
    track.values = {offsetMm, 0, 0, offsetMm + 2, 1, 0};
    scene.clips = {{.seconds = 1, .tracks = {track}}};
    ClipChanges changes;
    PointLight light = scene.lighting.points[0];
    light.positionMm[1] = -10;
    changes.points = {{0, {0, 1}, {scene.lighting.points[0], light}}};
    Camera camera = scene.camera;
    camera.positionMm[1] = 8;
    changes.cameras = {{0, {0, 1}, {scene.camera, camera}}};
    scene.changes = {changes};
    Renderer renderer;
    renderer.setScene(scene);
    renderer.setTime({.seconds = 0.5});
    return renderer.render(smallOptions()).images.at(0).rgba;
  });
}

TEST(FarScenes, GivenPositionsLightsAndCamerasAreThere) {
  expectAlike([](float offsetMm) {
    Renderer renderer;
    renderer.setScene(sceneAt(offsetMm));
    std::vector<Vec3> positions = ballAt(0).positionsMm;
    for (Vec3& position : positions)
      position = moved({onGrid(1.25F * position[0]), onGrid(position[1]), position[2]}, offsetMm);
    renderer.replacePositions(0, positions);
    Lighting lighting = sceneAt(offsetMm).lighting;
    lighting.points[0].positionMm[1] = 0;
    renderer.setLighting(lighting);
    View view(renderer, smallOptions());
    Camera camera = cameraAt(offsetMm);
    camera.positionMm[0] += 5;
    view.setCamera(camera);
    return view.render().images.at(0).rgba;
  });
}

TEST(FarScenes, MatricesSeeThem) {
  expectAlike([](float offsetMm) {
    Renderer renderer;
    renderer.setScene(sceneAt(offsetMm));
    View view(renderer, smallOptions());
    CameraMatrices matrices;
    // From 25 mm in front of the ball, x to the right, y up, 28 degrees across.
    matrices.worldToView = {1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0, -offsetMm, 0, 25, 1};
    matrices.viewToClip = {4, 0, 0, 0, 0, 4, 0, 0, 0, 0, 1, 1, 0, 0, -1, 0};
    view.setCamera(matrices);
    return view.render().images.at(0).rgba;
  });
}

TEST(FarScenes, PositionsAreTold) {
  expectAlike(
      [](float offsetMm) {
        Renderer renderer;
        renderer.setScene(sceneAt(offsetMm));
        std::vector<float> rgba =
            renderer.render(smallOptions(), {Aov::Position}).images.at(0).rgba;
        for (std::size_t i = 0; i < rgba.size(); i += 4)
          if (rgba[i + 3] > 0) rgba[i] -= offsetMm;
        return rgba;
      },
      2e-3);
}

}  // namespace
}  // namespace opaline::test
