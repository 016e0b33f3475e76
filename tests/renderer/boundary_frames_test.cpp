// Boundary transport on a moving body: a frame depends only on its time, errors do not flicker, and
// the body's place and rotation do not matter.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "renderer/boundary_fixture.h"

namespace opaline {
namespace {

using namespace test;

using BoundaryFramesTest = RendererTest;

Medium gummy() {
  return {"gummy", {1.0, 1.0, 1.0}, {0.02, 0.3, 0.4}, 1.4};
}

Scene twistingBear(float radians) {
  Scene scene = backlitBear(50, gummy());
  scene.deformers = {{DeformerKind::Twist, radians, 2}};
  return scene;
}

// At least one source per triangle. With fewer, detail would not be followed.
constexpr int sourcesOfBear = 1 << 16;

RenderOptions coarseOptions() {
  RenderOptions options = boundaryOptions(64, 1);
  options.maxSurfels = sourcesOfBear;
  options.maxClusters = 2400;  // less than the usual 4500
  return options;
}

RenderOptions fineOptions() {
  RenderOptions options = boundaryOptions(64, 1);
  options.maxSurfels = sourcesOfBear;
  options.tolerance = 1e-3F;
  return options;
}

/// How much a film's error changes between frames 1/25 s apart, relative to the mean.
struct Flicker {
  double ofMean = 0;  ///< largest, of a channel's mean over the picture
  double rms = 0;     ///< largest of any pair of frames, over pixels and channels
};

struct Film {
  std::vector<Image> exitances;
  std::vector<Image> positions;
};

Film filmOf(const RenderOptions& options, int frames) {
  Film film;
  for (int frame = 0; frame < frames; ++frame) {
    sharedRenderer().renderer->setTime({.seconds = 0.2 + frame / 25.0});
    std::vector<Image> images =
        sharedRenderer().renderer->render(options, {Aov::Exitance, Aov::Position}).images;
    film.exitances.push_back(std::move(images[0]));
    film.positions.push_back(std::move(images[1]));
  }
  return film;
}

/// Counts pixels whose place has moved no farther than `mostMm`.
Flicker flickerOf(const Scene& scene, int frames, double mostMm) {
  sharedRenderer().renderer->setScene(scene);
  const Film coarse = filmOf(coarseOptions(), frames);
  const Film fine = filmOf(fineOptions(), frames);
  const auto error = [&](std::size_t frame, std::size_t i) {
    return static_cast<double>(coarse.exitances[frame].rgba[i] - fine.exitances[frame].rgba[i]);
  };
  Flicker flicker;
  for (std::size_t frame = 1; frame < fine.exitances.size(); ++frame) {
    const std::array<double, 3> mean = meanOf(fine.exitances[frame]);
    std::array<double, 3> sum{};
    double squares = 0;
    int pixels = 0;
    forEachCovered(fine.positions[frame], [&](std::size_t i) {
      if (fine.positions[frame - 1].rgba[i + 3] <= 0 ||
          length(toVector(&fine.positions[frame].rgba[i]) -
                 toVector(&fine.positions[frame - 1].rgba[i])) > mostMm)
        return;
      ++pixels;
      for (std::size_t c = 0; c < 3; ++c) {
        const double change = (error(frame, i + c) - error(frame - 1, i + c)) / mean[c];
        sum[c] += change;
        squares += change * change;
      }
    });
    EXPECT_GT(pixels, 500);
    for (const double change : sum)
      flicker.ofMean = std::max(flicker.ofMean, std::abs(change) / pixels);
    flicker.rms = std::max(flicker.rms, std::sqrt(squares / (3 * pixels)));
  }
  return flicker;
}

// With half of the usual clusters green is 2 to 4 % off, more so the farther the body is twisted:
// by 0.3 to 0.75 % a frame, wherever the clusters lie.
TEST_F(BoundaryFramesTest, ErrorOfThePictureDoesNotFlickerAsTheBearTwists) {
  EXPECT_LT(flickerOf(twistingBear(1.5F), 3, 1e3).ofMean, 0.008);
}

// So slow that the error of a place stays in its pixel, except at edges.
TEST_F(BoundaryFramesTest, ErrorOfPlacesDoesNotFlickerAsTheBearTwists) {
  EXPECT_LT(flickerOf(twistingBear(0.03F), 2, 0.1).rms, 0.005);
}

TEST_F(BoundaryFramesTest, AFrameIsTheSameWhateverWasShownBefore) {
  Scene scene = sceneOf(peanut(20), marble(), {20, 5, 50}, 12);
  scene.lighting.directional = {{toVec3(unit({0.45, 0.35, -0.82})), {3, 3, 3}}};
  scene.deformers = {{DeformerKind::Twist, 1.5F, 2}, {DeformerKind::Bend, 0.8F, 3}};
  for (const Site site : {Site::Fragment, Site::Vertex}) {
    RenderOptions options = boundaryOptions(32, 2);
    options.maxSurfels = 4096;
    options.site = site;
    renderer().setScene(scene);
    const Image alone = renderAt(0.4, options, {Aov::Exitance})[0];
    renderer().setScene(scene);
    Image played;
    for (int frame = 0; frame <= 2; ++frame)
      played = renderAt(0.2 * frame, options, {Aov::Exitance})[0];
    EXPECT_EQ(played.rgba, alone.rgba);
    EXPECT_NE(renderAt(0, options, {Aov::Exitance})[0].rgba, alone.rgba);
    EXPECT_EQ(renderAt(0.4, options, {Aov::Exitance})[0].rgba, alone.rgba);
  }
}

/// A rotation about an axis and a shift, applied to a body with its lights and camera.
class Motion {
 public:
  Motion(const Vector& axis, double angle, const Vector& shift)
      : axis_(unit(axis)), angle_(angle), shift_(shift) {}

  Vector turned(const Vector& v) const {
    const double c = std::cos(angle_);
    return c * v + std::sin(angle_) * cross(axis_, v) + (1 - c) * dot(axis_, v) * axis_;
  }
  Vector moved(const Vector& v) const { return turned(v) + shift_; }

  Scene operator()(Scene scene) const {
    const auto move = [&](Vec3& v) { v = toVec3(moved(toVector(v))); };
    const auto turn = [&](Vec3& v) { v = toVec3(turned(toVector(v))); };
    for (Object& object : scene.objects) {
      for (Vec3& position : object.mesh.positionsMm) move(position);
      for (Vec3& normal : object.mesh.normals) turn(normal);
    }
    for (DirectionalLight& light : scene.lighting.directional) turn(light.directionToLight);
    for (PointLight& light : scene.lighting.points) move(light.positionMm);
    move(scene.camera.positionMm);
    move(scene.camera.targetMm);
    turn(scene.camera.up);
    return scene;
  }

 private:
  Vector axis_;
  double angle_;
  Vector shift_;
};

Scene litPeanut() {
  Scene scene = sceneOf(peanut(20), marble(), {20, 5, 50}, 10.5F);
  scene.lighting.directional = {{toVec3(unit({0.45, 0.35, -0.82})), {3, 3, 3}}};
  scene.lighting.points = {{{12, 8, 9}, {100, 50, 100}}};
  return scene;
}

// Only the rest pose decides the clusters, so a body keeps them when it is moved rigidly. Only
// single precision and the light's shadow maps differ.
TEST_F(BoundaryFramesTest, ABodyCarriedAboutLooksTheSame) {
  const Scene scene = litPeanut();
  const Motion motion({0.3, 1, 0.5}, 1.1, {3, -40, 25});
  Scene carried = scene;
  const Scene moved = motion(scene);
  carried.lighting = moved.lighting;
  carried.camera = moved.camera;
  const RenderOptions options = boundaryOptions(64, 2);
  const Image atRest = renderBoundary(scene, options, {Aov::Exitance}).images[0];
  renderer().setScene(carried);
  renderer().replacePositions(0, moved.objects[0].mesh.positionsMm);
  const Image elsewhere = render(options, {Aov::Exitance})[0];
  // A pixel at the rim may be covered in only one of them.
  double squares = 0;
  int both = 0;
  const std::array<double, 3> mean = meanOf(atRest);
  const int pixels = forEachCovered(atRest, [&](std::size_t i) {
    if (elsewhere.rgba[i + 3] <= 0) return;
    ++both;
    for (std::size_t c = 0; c < 3; ++c)
      squares +=
          std::pow(static_cast<double>(elsewhere.rgba[i + c] - atRest.rgba[i + c]) / mean[c], 2);
  });
  EXPECT_GT(both, pixels - 10);
  EXPECT_LT(std::sqrt(squares / (3 * both)), 0.005);
}

}  // namespace
}  // namespace opaline
