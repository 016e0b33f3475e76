// What the sum over the tree does not depend on: the camera, the frames before, the number of
// objects around.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

#include "bssrdf/fresnel.h"
#include "bssrdf/profile.h"
#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"
#include "renderer/sums.h"

namespace opaline {
namespace {

using namespace test;

using TreeFramesTest = RendererTest;

RenderOptions treeFrameOptions(int edge, Site site = Site::Fragment) {
  RenderOptions options = smallOptions();
  options.width = options.height = edge;
  options.site = site;
  options.sum = Sum::Tree;
  return options;
}

Scene litBall() {
  Scene scene = sceneOf(sphere({0, 0, 0}, 6, 3), skin(), {0, 3, 24}, 7);
  scene.lighting.directional = {{{0.45F, 0.35F, -0.82F}, {3, 3, 3}},
                                {{-0.6F, 0.3F, 0.7F}, {1, 0.6F, 0.2F}}};
  return scene;
}

/// Looks at the point from the direction; the picture has the point at its middle pixel's centre.
/// The pixels are small, since devices round where a triangle's corners lie to a part of one.
struct Sight {
  Vector direction;
  double distanceMm;
  float fovDegrees;
  int width;
  int height;
};

Rgb exitanceAt(Scene scene, const Vector& pointMm, const Sight& view, Site site) {
  scene.camera.targetMm = toVec3(pointMm);
  scene.camera.positionMm = toVec3(pointMm + view.distanceMm * unit(view.direction));
  scene.camera.verticalFovDegrees = view.fovDegrees;
  Renderer& renderer = *sharedRenderer().renderer;
  renderer.setScene(scene);
  RenderOptions options = treeFrameOptions(1, site);
  options.width = view.width;
  options.height = view.height;
  const std::vector<Image> images = renderer.render(options, {Aov::Exitance, Aov::Position}).images;
  const int x = view.width / 2;
  const int y = view.height / 2;
  EXPECT_GT(images[0].pixel(x, y)[3], 0);
  EXPECT_LT(length(toVector(images[1].pixel(x, y)) - pointMm), 1e-4);
  const float* value = images[0].pixel(x, y);
  return {value[0], value[1], value[2]};
}

// One point from two cameras; the largest difference, relative to what one sees.
double largestDifference(Site site) {
  const Scene scene = litBall();
  const Mesh& mesh = scene.objects[0].mesh;
  double largest = 0;
  for (const std::size_t t : {3U, 200U, 470U, 711U, 1100U}) {
    const Triangle& triangle = mesh.triangles[t];
    const Vector a = toVector(mesh.positionsMm[triangle[0]]);
    const Vector middle = (1.0 / 3) * (a + toVector(mesh.positionsMm[triangle[1]]) +
                                       toVector(mesh.positionsMm[triangle[2]]));
    // Pixels cannot be wholly at a vertex without rounding; next to one they can.
    for (const Vector& point : {middle, 0.98 * a + 0.02 * middle}) {
      const Rgb near = exitanceAt(scene, point, {point, 20, 1, 25, 25}, site);
      const Rgb far =
          exitanceAt(scene, point, {unit(point) + Vector{0.4, -0.5, 0.3}, 30, 1.5F, 67, 43}, site);
      for (std::size_t c = 0; c < 3; ++c)
        largest = std::max(largest, static_cast<double>(std::abs(far[c] / near[c] - 1)));
    }
  }
  return largest;
}

TEST_F(TreeFramesTest, ThePointKeepsItsExitanceWhateverTheCamera) {
  const double fragment = largestDifference(Site::Fragment);
  const double vertex = largestDifference(Site::Vertex);
  // What lies between pixels whose light is summed has the error of these sums: a quarter of the
  // tolerance.
  EXPECT_LE(fragment, 0.0025);
  EXPECT_LE(vertex, 1e-5);  // interpolation in single precision
}

TEST_F(TreeFramesTest, ErrorDoesNotFlickerAsTheBodyMoves) {
  Scene scene = litBall();
  scene.deformers = {{DeformerKind::Wobble, 0.08F, 1}, {DeformerKind::Twist, 1.0F, 0.5F}};
  renderer().setScene(scene);
  for (const Site site : {Site::Fragment, Site::Vertex}) {
    RenderOptions options = treeFrameOptions(48, site);
    std::vector<float> before;
    double squares = 0;  // relative to the picture's mean
    double largest = 0;  // relative to what is there
    int pixels = 0;
    for (int frame = 0; frame < 8; ++frame) {
      renderer().setTime({.seconds = 0.3 + frame / 30.0});
      const TreeAndAll images = treeAndAll(options);
      const std::array<double, 3> mean = meanOf(images.all);
      std::vector<float> error = images.tree.rgba;
      for (std::size_t i = 0; i < error.size(); ++i)
        if (i % 4 != 3) error[i] -= images.all.rgba[i];
      if (frame > 0)
        forEachCovered(images.all, [&](std::size_t i) {
          if (before[i + 3] <= 0) return;
          ++pixels;
          const float* all = &images.all.rgba[i];
          const float brightest = std::max({all[0], all[1], all[2]});
          for (std::size_t c = 0; c < 3; ++c) {
            const auto change = static_cast<double>(std::abs(error[i + c] - before[i + c]));
            squares += std::pow(change / mean[c], 2) / 3;
            largest =
                std::max(largest, change / static_cast<double>(std::max(all[c], brightest / 20)));
          }
        });
      before = error;
    }
    EXPECT_GT(pixels, 5000);
    EXPECT_LT(std::sqrt(squares / pixels), 0.01);
    EXPECT_LT(largest, 0.01);
  }
}

TEST_F(TreeFramesTest, AFrameIsTheSameWhateverWasPlayedBefore) {
  Scene scene = litBall();
  scene.deformers = {{DeformerKind::Wobble, 0.08F, 1}, {DeformerKind::Bend, 1.0F, 0.7F}};
  for (const Site site : {Site::Fragment, Site::Vertex}) {
    RenderOptions options = treeFrameOptions(48, site);
    renderer().setScene(scene);
    std::vector<Image> played;
    for (int frame = 0; frame < 6; ++frame)
      played.push_back(renderAt(0.2 * frame, options, {Aov::Exitance})[0]);
    for (const int frame : {4, 1}) {
      const double seconds = 0.2 * frame;
      EXPECT_TRUE(renderAt(seconds, options, {Aov::Exitance})[0].rgba ==
                  played[static_cast<std::size_t>(frame)].rgba);
      renderer().setScene(scene);
      const Image alone = renderAt(seconds, options, {Aov::Exitance})[0];
      EXPECT_TRUE(alone.rgba == played[static_cast<std::size_t>(frame)].rgba);
    }
    EXPECT_FALSE(played[1].rgba == played[4].rgba);
  }
}

// ---- several objects

struct BallOf {
  Vec3 centreMm;
  float radiusMm;
  int levels;
  Medium medium;
};

Scene ballsOf(const std::vector<BallOf>& balls) {
  Scene scene = sceneOf({}, marble(), {0, 0, 60}, 12);
  scene.objects.clear();
  for (const BallOf& ball : balls)
    scene.objects.push_back(
        {"ball", sphere(ball.centreMm, ball.radiusMm, ball.levels), ball.medium});
  return scene;
}

// Largest deviation of the balls, in uniform light which nothing shades, from the closed form
// B = E · D(2R) of each.
double largestDeviation(const std::vector<BallOf>& balls, const RenderOptions& options) {
  Scene scene = ballsOf(balls);
  scene.lighting.ambient = {1, 1, 1};
  Renderer& renderer = *sharedRenderer().renderer;
  renderer.setScene(scene);
  const std::vector<Image> images = renderer.render(options, {Aov::Exitance, Aov::Object}).images;
  std::vector<int> seen(balls.size(), 0);
  double largest = 0;
  forEachCovered(images[0], [&](std::size_t i) {
    const auto object = static_cast<std::size_t>(images[1].rgba[i]);
    const BallOf& ball = balls[object];
    ++seen[object];
    for (std::size_t c = 0; c < 3; ++c) {
      const double exact =
          std::numbers::pi * bssrdf::meanTransmittance(ball.medium.eta) *
          bssrdf::makeProfile(bssrdf::Model::Dipole,
                              bssrdf::coefficients(ball.medium, static_cast<int>(c)))
              .disc(2 * static_cast<double>(ball.radiusMm));
      const double off = static_cast<double>(images[0].rgba[i + c]) / exact - 1;
      largest = std::max(largest, std::abs(off));
    }
  });
  for (const int pixels : seen) EXPECT_GT(pixels, 4);
  return largest;
}

// Though others lie close by and one is as small as a mean free path.
TEST_F(TreeFramesTest, EveryObjectIsOfItsOwnMedium) {
  Medium dense = skin();
  dense.eta = 1.8;
  const std::vector<BallOf> balls{{{-6, 0, 0}, 4, 4, marble()},
                                  {{2, 0, 0}, 3, 4, skin()},
                                  {{6, 4, 0}, 2, 4, dense},
                                  {{-1, -4, 2}, 0.6F, 4, skin()}};
  for (const Site site : {Site::Fragment, Site::Vertex})
    EXPECT_LT(largestDeviation(balls, finelyDivided(treeFrameOptions(64, site))), 0.01);
}

// Balls that nearly touch, with surfels many mean free paths apart: what is nearby is of the same
// object.
TEST_F(TreeFramesTest, CoarseSurfelsAreThoseOfTheirOwnObject) {
  Medium clear = skin();
  for (double& sigma : clear.sigmaSPrimePerMm) sigma *= 0.3;
  const std::vector<BallOf> balls{
      {{-6, 0, 0}, 6, 3, marble()}, {{5.1F, 0, 0}, 5, 3, skin()}, {{0, -5.5F, 6}, 2, 3, clear}};
  for (const Site site : {Site::Fragment, Site::Vertex}) {
    RenderOptions options = treeFrameOptions(64, site);
    options.maxSurfels = 1024;
    EXPECT_LT(largestDeviation(balls, options), 0.05);
  }
}

// Of two balls one has edges shorter than the mean free path, one longer.
TEST_F(TreeFramesTest, AutoChoosesTheSiteForEachObject) {
  Scene scene =
      ballsOf({{{-5, 0, 0}, 3, 4, skin()}, {{5, 0, 0}, 5, 2, skin()}, {{0, 7, 0}, 2, 4, marble()}});
  scene.lighting.directional = {{{0.45F, 0.35F, -0.82F}, {3, 3, 3}}};
  scene.lighting.ambient = {0.2F, 0.2F, 0.2F};
  renderer().setScene(scene);
  for (const Sum sum : {Sum::Tree, Sum::All}) {
    RenderOptions options = treeFrameOptions(64, Site::Vertex);
    options.sum = sum;
    const Image vertex = render(options, {Aov::Exitance})[0];
    options.site = Site::Fragment;
    const Image fragment = render(options, {Aov::Exitance})[0];
    options.site = Site::Auto;
    const RenderResult chosen = renderer().render(options, {Aov::Exitance, Aov::Object});
    EXPECT_EQ(chosen.report.site, Site::Auto);
    std::array<int, 3> seen{};
    forEachCovered(chosen.images[0], [&](std::size_t i) {
      const auto object = static_cast<std::size_t>(chosen.images[1].rgba[i]);
      ++seen[object];
      const Image& expected = object == 1 ? fragment : vertex;
      for (std::size_t c = 0; c < 3; ++c)
        ASSERT_EQ(chosen.images[0].rgba[i + c], expected.rgba[i + c]) << "object " << object;
    });
    for (const int pixels : seen) EXPECT_GT(pixels, 30);
  }
}

// Alone or among others: lights that others do not shade, and no light from them.
TEST_F(TreeFramesTest, OthersChangeNothingButByTheirShadows) {
  const BallOf ball{{-4, 0, 0}, 3, 4, skin()};
  const auto lit = [](Scene scene) {
    scene.lighting.directional = {{{0, 0, 1}, {3, 3, 3}}};
    return scene;
  };
  for (const Site site : {Site::Fragment, Site::Vertex}) {
    const RenderOptions options = treeFrameOptions(64, site);
    const Image alone = render(lit(ballsOf({ball})), options, {Aov::Exitance})[0];
    const std::vector<Image> among = render(lit(ballsOf({{{4, 0, 0}, 4.9F, 4, marble()}, ball})),
                                            options, {Aov::Exitance, Aov::Object});
    int pixels = 0;
    double largest = 0;
    forEachCovered(alone, [&](std::size_t i) {
      if (among[1].rgba[i] != 1) return;
      ++pixels;
      for (std::size_t c = 0; c < 3; ++c)
        largest = std::max(
            largest, static_cast<double>(std::abs(among[0].rgba[i + c] / alone.rgba[i + c] - 1)));
    });
    EXPECT_GT(pixels, 100);
    EXPECT_LT(largest, 0.01);  // shadow maps have other texels
  }
}

// ---- what there is hardly anything of

void expectFinite(const std::vector<Image>& images) {
  for (const Image& image : images)
    for (const float value : image.rgba) ASSERT_TRUE(std::isfinite(value) && value >= 0);
}

TEST_F(TreeFramesTest, ASceneInTheDarkIsBlack) {
  Scene scene = litBall();
  scene.lighting = {};
  renderer().setScene(scene);
  for (const Sum sum : {Sum::Tree, Sum::All})
    for (const Site site : {Site::Fragment, Site::Vertex})
      for (const Transport transport : {Transport::Dipole, Transport::BetterDipole})
        for (const int maxSurfels : {1024, 100'000}) {
          RenderOptions options = treeFrameOptions(24, site);
          options.sum = sum;
          options.transport = transport;
          options.maxSurfels = maxSurfels;
          const Image exitance = render(options, {Aov::Exitance})[0];
          EXPECT_GT(forEachCovered(exitance,
                                   [&](std::size_t i) {
                                     for (std::size_t c = 0; c < 3; ++c)
                                       ASSERT_EQ(exitance.rgba[i + c], 0);
                                   }),
                    100);
        }
}

// A node's series may end below 0 where next to nothing arrives: with these numbers at -6e-36.
TEST_F(TreeFramesTest, WhereNextToNothingArrivesLightIsNotNegative) {
  Medium medium{.name = "absorbing", .eta = 1.45};
  medium.sigmaSPrimePerMm = {3.802887, 3.802887, 3.802887};
  medium.sigmaAPerMm = {.10579586, .09952970, .01219780};
  Scene scene =
      sceneOf(sheet({0, 0, 0}, {37.6F, 0, 0}, {0, 23.5F, 23.5F}, 2), medium, {-108, 207, 202}, 20);
  scene.deformers = {{DeformerKind::Bend, -1.1541255F}};
  scene.lighting.directional = {{{-.78825814F, -.6000107F, -.13651478F}, {3, 3, 3}}};
  renderer().setScene(scene);
  RenderOptions options = treeFrameOptions(30);
  options.transport = Transport::Boundary;  // it takes nodes without asking for the tolerance
  options.maxSurfels = 1024;
  expectFinite(render(options, {Aov::Exitance}));
}

TEST_F(TreeFramesTest, ObjectsAndTrianglesWithoutAreaAreBorne) {
  Scene scene = litBall();
  Mesh& mesh = scene.objects[0].mesh;
  for (std::uint32_t i = 0; i < 40; ++i) mesh.triangles.push_back({i, i, i + 1});
  Mesh flat;  // all of its triangles are a line
  Mesh point;
  for (int i = 0; i < 12; ++i) {
    flat.positionsMm.push_back({static_cast<float>(i), 7, 0});
    flat.normals.push_back({0, 1, 0});
    point.positionsMm.push_back({8, 8, 8});
    point.normals.push_back({0, 0, 1});
  }
  for (std::uint32_t i = 0; i + 2 < 12; ++i) {
    flat.triangles.push_back({i, i + 1, i + 2});
    point.triangles.push_back({i, i + 1, i + 2});
  }
  scene.objects.push_back({"flat", flat, marble()});
  scene.objects.push_back({"empty", {}, marble()});
  scene.objects.insert(scene.objects.begin(), {"point", point, skin()});
  renderer().setScene(scene);
  const Scene clean = litBall();
  for (const Sum sum : {Sum::Tree, Sum::All})
    for (const Site site : {Site::Auto, Site::Fragment, Site::Vertex})
      for (const int maxSurfels : {1024, 100'000}) {
        RenderOptions options = treeFrameOptions(24, site);
        options.sum = sum;
        options.maxSurfels = maxSurfels;
        const std::vector<Image> images = render(options, {Aov::Exitance, Aov::Radiance});
        expectFinite(images);
        EXPECT_GT(meanOf(images[0])[0], 0.1);
      }
}

}  // namespace
}  // namespace opaline
