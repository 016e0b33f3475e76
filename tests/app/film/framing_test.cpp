#include "film/framing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "deform/deformed_vertices.h"
#include "renderer/frame/camera_view.h"
#include "shared_files.h"

namespace opaline::app {
namespace {

/// How far vertices are from the middle of the picture, 1 at its border; behind the camera: huge.
double farthestOut(const Scene& scene, const Framed& framed, const Moment& moment) {
  const glm::mat4 toClip =
      makeCameraView(scene.camera, static_cast<float>(framed.aspect)).worldToClip;
  double farthest = 0;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    for (const scene::Double3& p :
         deform::deformedVertices(scene, i, framed.clip, moment.seconds).positionsMm) {
      const glm::vec4 clip = toClip * glm::vec4(p[0], p[1], p[2], 1);
      if (!(clip.w > 0)) return 1e30;
      farthest = std::max(
          {farthest, double{std::abs(clip.x / clip.w)}, double{std::abs(clip.y / clip.w)}});
    }
  }
  return farthest;
}

double farthestOut(const Scene& scene, const Framed& framed) {
  double farthest = 0;
  for (const Moment& moment : framed.moments) {
    farthest = std::max(farthest, farthestOut(scene, framed, moment));
  }
  return farthest;
}

void expectSeen(Scene scene, double aspect) {
  FrameRange frames;
  frames.last = 30;
  frames.perSecond = 12;
  const Framed framed{0, aspect, nullptr, momentsOf(frames, nullptr)};
  const Camera before = scene.camera;
  const bool wasCut = farthestOut(scene, framed) > 1;
  showAll(scene, framed);
  if (!wasCut) {
    EXPECT_EQ(scene.camera.positionMm, before.positionMm);
  } else {
    // No farther back than the margin asks for.
    EXPECT_NEAR(farthestOut(scene, framed), 0.97, 1e-4);
  }
  EXPECT_EQ(scene.camera.targetMm, before.targetMm);
}

class ModelsInTheFrame : public testing::TestWithParam<const char*> {};

TEST_P(ModelsInTheFrame, AtAllTimes) {
  const auto file = test::sharedModel(GetParam());
  if (!file) GTEST_SKIP() << "the models are not here";
  LoadOptions options;
  options.diagonalMm = 50;
  Scene scene = loadScene(*file, options);
  expectSeen(scene, 1);
  expectSeen(scene, 0.4);
  scene.deformers = {{DeformerKind::Squash, -0.8F, 1.5F}, {DeformerKind::Wobble, 0.3F, 0.9F}};
  scene.camera = defaultCamera(scene, {1, 2, -3});
  expectSeen(scene, 1.7);
}

INSTANTIATE_TEST_SUITE_P(Shared, ModelsInTheFrame,
                         testing::Values("gltf/TranslucentTrio.glb", "gltf/CesiumMan.glb",
                                         "gltf/RiggedFigure.glb", "gltf/AnimatedMorphCube.glb",
                                         "teapot.ply"));

// A camera is fitted in a time that does not grow with a film without an end.
TEST(Moments, OfAnEndlessFilmSomeAreLookedAt) {
  const std::vector<Moment> moments = momentsOf({0, 999'999, 30}, nullptr);
  EXPECT_LE(moments.size(), 1024U);
  EXPECT_DOUBLE_EQ(moments.front().seconds, 0);
  EXPECT_DOUBLE_EQ(moments.back().seconds, 999'999 / 30.0);
  EXPECT_EQ(momentsOf({3, 13, 30, 5}, nullptr).size(), 3U);
  EXPECT_DOUBLE_EQ(momentsOf({3, 13, 30, 5}, nullptr)[1].seconds, 8 / 30.0);
}

TEST(Frame, OfACameraThatWasChosenStays) {
  Scene scene = builtInTeapot();
  scene.camera.positionMm[2] = 20;
  const Camera chosen = scene.camera;
  scene.cameraChosen = true;
  const Framed framed{0, 1, nullptr, {Moment{}}};
  showAll(scene, framed);
  EXPECT_EQ(scene.camera.positionMm, chosen.positionMm);
  scene.cameraChosen = false;
  showAll(scene, framed);
  EXPECT_NE(scene.camera.positionMm, chosen.positionMm);
}

TEST(Frame, OfTheMomentIsFilled) {
  Scene scene = builtInTeapot();
  scene.deformers = {{DeformerKind::Bend, 1.5F, 0}};
  scene.camera.positionMm = {300, 100, 50};
  frame(scene, {}, {}, 1.5);
  EXPECT_NEAR(farthestOut(scene, {0, 1.5, nullptr, {Moment{}}}), 0.97, 1e-4);
  // What is given moves the target.
  PositionsByObject given{{0, scene.objects[0].mesh.positionsMm}};
  for (Vec3& p : given[0]) p[0] += 100;
  scene.deformers.clear();
  frame(scene, {}, given, 1.5);
  const Bounds box = boundsOf(scene);
  EXPECT_NEAR(scene.camera.targetMm[0], (box.minMm[0] + box.maxMm[0]) / 2 + 100, 1e-3);
}

}  // namespace
}  // namespace opaline::app
