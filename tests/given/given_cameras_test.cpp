// Cameras given by the caller's matrices.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "given/given_frames_fixture.h"
#include "opaline/error.h"

namespace opaline::test {
namespace {

TEST_F(GivenFramesTest, MatricesSeeWhatTheCameraSees) {
  const std::vector<Aov> aovs{Aov::Radiance, Aov::Position, Aov::Depth};
  const std::vector<Image> expected = renderer().render(options(), aovs).images;
  View view(renderer(), options());
  for (const bool reversed : {false, true}) {
    view.setCamera(matrices(reversed));
    const std::vector<Image> images = view.render({.aovs = aovs}).images;
    for (std::size_t i = 0; i < images.size(); ++i) {
      std::size_t different = 0;
      for (std::size_t j = 0; j < images[i].rgba.size(); ++j)
        if (std::abs(images[i].rgba[j] - expected[i].rgba[j]) >
            1e-3F * std::max(1.0F, std::abs(expected[i].rgba[j])))
          ++different;
      EXPECT_LE(different, images[i].rgba.size() / 500) << "at silhouettes alone";
    }
  }
}

// Jitter by a pixel shows the neighbouring picture, whether viewToClip contains it or not.
TEST_F(GivenFramesTest, JitterMovesThePicture) {
  View view(renderer(), options());
  CameraMatrices given = matrices(true);
  view.setCamera(given);
  const Image still = view.render({.aovs = {Aov::Position}}).images[0];
  given.jitterPixels = {3, -2};
  view.setCamera(given);
  const Image moved = view.render({.aovs = {Aov::Position}}).images[0];
  given.jitterPixels = {};
  given.viewToClip[8] = 2.0F * 3 / size;  // x += 2·3/size · w
  given.viewToClip[9] = 2.0F * -2 / size;
  view.setCamera(given);
  const Image inside = view.render({.aovs = {Aov::Position}}).images[0];
  std::size_t covered = 0;
  for (std::size_t y = 2; y < size; ++y)
    for (std::size_t x = 0; x + 3 < size; ++x) {
      const float* from = &still.rgba[4 * (y * size + x)];
      const float* to = &moved.rgba[4 * ((y - 2) * size + x + 3)];
      const float* in = &inside.rgba[4 * ((y - 2) * size + x + 3)];
      if (from[3] == 0 || to[3] == 0 || in[3] == 0) continue;
      ++covered;
      for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(from[i], to[i], 0.01F);
        EXPECT_NEAR(from[i], in[i], 0.01F);
      }
    }
  EXPECT_GT(covered, std::size_t{size} * size / 8);
}

// An orthographic projection shows what a camera of that height does, with linear depths.
TEST_F(GivenFramesTest, OrthographicMatricesSeeWhatTheOrthographicCameraSees) {
  constexpr float heightMm = 24;
  Camera camera = scene_.camera;
  camera.orthographicHeightMm = heightMm;
  View view(renderer(), options());
  view.setCamera(camera);
  const std::vector<Aov> aovs{Aov::Radiance, Aov::Position, Aov::Depth};
  const std::vector<Image> expected = view.render({.aovs = aovs}).images;
  const Engine::Target color = engine().makeTarget(VK_FORMAT_R32G32B32A32_SFLOAT, {size, size});
  const Engine::Target depth = engine().makeTarget(VK_FORMAT_D32_SFLOAT, {size, size});
  for (const bool reversed : {false, true}) {
    SCOPED_TRACE(reversed ? "reversed" : "ordinary");
    const double slope = 1 / (farMm - nearMm);
    view.setCamera(orthographic(reversed, heightMm));
    engine().run([&](VkCommandBuffer commands) {
      Engine::clear(commands, color, {{0, 0, 0, 0}}, depth, reversed ? 0.F : 1.F);
    });
    const Composition over{.color = {color.image, color.view, color.format},
                           .depth = {depth.image, depth.view, depth.format}};
    runFrame(view, {.over = &over}, {.aovs = aovs});
    Frame frame;
    view.collect(frame);
    std::size_t covered = 0;
    const std::vector<float> depths = engine().read(depth);
    for (std::size_t i = 0; i < depths.size(); ++i) {
      const float* seen = &frame.images[2].rgba[4 * i];
      if (seen[3] == 0 || expected[2].rgba[4 * i + 3] == 0) continue;
      ++covered;
      EXPECT_NEAR(seen[0], expected[2].rgba[4 * i], 1e-3F);
      for (std::size_t j = 4 * i; j < 4 * i + 3; ++j)
        EXPECT_NEAR(frame.images[1].rgba[j], expected[1].rgba[j], 1e-3F);
    }
    EXPECT_GT(covered, std::size_t{size} * size / 8);
    for (std::size_t y = 1; y + 1 < size; ++y)
      for (std::size_t x = 1; x + 1 < size; ++x) {
        const std::size_t i = y * size + x;
        // The nearest of a pixel's samples; where its neighbours see the body, within its slope.
        if (frame.images[2].rgba[4 * i + 3] == 0) continue;
        const double mm = static_cast<double>(frame.images[2].rgba[4 * i]);
        const double ordinary = (mm - nearMm) * slope;
        EXPECT_NEAR(reversed ? 1 - static_cast<double>(depths[i]) : static_cast<double>(depths[i]),
                    ordinary, 2 * slope);
      }
    std::size_t different = 0;
    for (std::size_t j = 0; j < expected[0].rgba.size(); ++j)
      if (std::abs(frame.images[0].rgba[j] - expected[0].rgba[j]) >
          1e-3F * std::max(1.0F, std::abs(expected[0].rgba[j])))
        ++different;
    EXPECT_LE(different, expected[0].rgba.size() / 500) << "at silhouettes alone";
  }
}

TEST_F(GivenFramesTest, RefusesWhatIsNoProjection) {
  View view(renderer(), options());
  CameraMatrices given = matrices(true);
  given.viewToClip[11] = 0;
  EXPECT_THROW(view.setCamera(given), UsageError);
  given.viewToClip[15] = 1;
  given.viewToClip[10] = 0;
  EXPECT_THROW(view.setCamera(given), UsageError) << "no depth";
  given = matrices(true);
  given.worldToView[5] = NAN;
  EXPECT_THROW(view.setCamera(given), UsageError);
  EXPECT_THROW(view.setCamera(CameraMatrices{}), UsageError);
}

}  // namespace
}  // namespace opaline::test
