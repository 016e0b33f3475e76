// The ground under a scene and other opaque bodies, against closed forms.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bssrdf/fresnel.h"
#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"

namespace opaline {
namespace {

using namespace test;
using std::numbers::pi;

constexpr int pixels = 64;
constexpr float ballMm = 10;

Medium darkness() {
  return {"dark", {0.01, 0.01, 0.01}, {10, 10, 10}, 1.3};
}

Medium whiteness() {
  return {"white", {5, 5, 5}, {0, 0, 0}, 1.3};
}

class ErrorsOfGround {
 public:
  void add(double error) {
    ++count_;
    sum_ += error;
    squares_ += error * error;
    largest_ = std::max(largest_, std::abs(error));
  }
  double mean() const { return sum_ / count_; }
  double rms() const { return std::sqrt(squares_ / count_); }
  double largest() const { return largest_; }

 private:
  int count_ = 0;
  double sum_ = 0;
  double squares_ = 0;
  double largest_ = 0;
};

class GroundTest : public RendererTest {
 protected:
  static RenderOptions options() {
    RenderOptions options = smallOptions();
    options.transport = Transport::Boundary;
    options.width = options.height = pixels;
    options.antialias = 1;
    options.specular = false;
    return options;
  }

  // A ball standing on the ground, seen from above.
  static Scene ballOnGround(const Medium& medium, const Rgb& color) {
    Scene scene = sceneOf(sphere({0, 0, 0}, ballMm, 4), medium, {0, 300, 1}, 5 * ballMm);
    scene.camera.up = {0, 0, -1};
    scene.objects.push_back(groundUnder(scene, {.color = color}));
    return scene;
  }

  // Visits pixels that see the ground at that distance from the place below the ball's middle.
  template <typename Visit>
  static void forEachOfGround(const std::vector<Image>& images, double least, double most,
                              const Visit& visit) {
    int seen = 0;
    for (int y = 0; y < pixels; ++y)
      for (int x = 0; x < pixels; ++x) {
        if (images[1].pixel(x, y)[0] != 1) continue;
        const Vector place = toVector(images[2].pixel(x, y));
        const double distance = std::hypot(place[0], place[2]);
        if (distance < least || distance > most) continue;
        visit(toVector(images[0].pixel(x, y)), place, distance);
        ++seen;
      }
    EXPECT_GT(seen, 50);
  }

  std::vector<Image> look(const Scene& scene, const RenderOptions& options) {
    return render(scene, options, {Aov::Exitance, Aov::Object, Aov::Position});
  }
};

TEST_F(GroundTest, GivesBackItsShareOfADirectionalLightButInTheShadow) {
  RenderOptions options = GroundTest::options();
  options.bounces = 0;
  Scene scene = ballOnGround(darkness(), {0.8F, 0.5F, 0.1F});
  scene.lighting.directional.push_back({{0.6F, 0.8F, 0}, {2, 3, 4}});
  const auto images = look(scene, options);
  const Vector expected{0.8 * 0.8 * 2, 0.5 * 0.8 * 3, 0.1 * 0.8 * 4};
  forEachOfGround(images, 0, 5 * ballMm, [&](const Vector& found, const Vector& at, double) {
    // The axis of the shadow's cylinder goes through the ball's middle.
    const double along = 0.6 * at[0] + 0.8 * at[1];
    const double away = std::sqrt(dot(at, at) - along * along) / static_cast<double>(ballMm);
    if (std::abs(away - 1) < 0.05) return;
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(found[c], away < 1 ? 0 : expected[c], 1e-3 * expected[c]);
  });
}

// Irradiance below a lamp at that height over an endless matt floor, which is in shadow up to that
// radius from the place below the lamp. By quadrature over rings that grow outwards.
double irradianceFromFloor(const Vector& at, const Vector& normal, double floorMm, double lampMm,
                           double shadowMm) {
  constexpr int rings = 300;
  constexpr int places = 180;
  constexpr double growth = 1.03;
  const double height = lampMm - floorMm;
  double sum = 0;
  for (double ring = 0, inner = shadowMm; ring < rings; ++ring, inner *= growth) {
    const double radius = 0.5 * (1 + growth) * inner;
    const double exitance = height / std::pow(radius * radius + height * height, 1.5);
    for (int i = 0; i < places; ++i) {
      const double angle = 2 * pi * (i + 0.5) / places;
      const Vector offset{radius * std::cos(angle) - at[0], floorMm - at[1],
                          radius * std::sin(angle) - at[2]};
      const double squared = dot(offset, offset);
      const double facing = std::max(dot(offset, normal), 0.0) * -offset[1] / squared;
      const double area = radius * (growth - 1) * inner * 2 * pi / places;
      sum += exitance * facing / (pi * squared) * area;
    }
  }
  return sum;
}

// Far out its triangles are large. Too few clusters must not join them to those near the ball.
TEST_F(GroundTest, FewClustersDoNotJoinNearAndFar) {
  constexpr float floorMm = -1.1F * ballMm;
  constexpr float lampMm = 7 * ballMm;
  constexpr double albedoOfFloor = 0.8;
  Scene scene =
      sceneOf(sphere({0, 0, 0}, ballMm, 4), darkness(), {0, -0.2F * ballMm, 60}, 1.1F * ballMm);
  scene.objects[0].opaque = mattMaterial({0.5F, 0.5F, 0.5F});
  scene.objects.push_back(groundUnder(scene, {.color = {0.8F, 0.8F, 0.8F}, .heightMm = floorMm}));
  scene.lighting.points.push_back({{0, lampMm, 0}, {1, 1, 1}});
  const double shadowMm = (lampMm - floorMm) * std::tan(std::asin(double{ballMm} / double{lampMm}));
  for (const int clusters : {1500, 8192}) {
    RenderOptions options = GroundTest::options();
    options.bounces = 1;
    options.maxClusters = clusters;
    const auto images = look(scene, options);
    double found = 0;
    double expected = 0;
    forEachCovered(images[0], [&](std::size_t i) {
      const Vector at = toVector(&images[2].rgba[i]);
      if (images[1].rgba[i] != 0 || at[1] > -0.3 * ballMm || at[1] < -0.7 * ballMm) return;
      found += static_cast<double>(images[0].rgba[i]);
      expected += 0.5 * albedoOfFloor *
                  irradianceFromFloor(at, unit(at), double{floorMm}, double{lampMm}, shadowMm);
    });
    EXPECT_NEAR(found / expected, 1, 0.06) << clusters;
  }
}

// A polished black ball mirrors light from the ground by Fresnel, where the mirrored ray meets lit
// ground. Nothing else shines there.
TEST_F(GroundTest, ATranslucentBallMirrorsIt) {
  RenderOptions options = GroundTest::options();
  options.roughness = 0.05F;
  Scene scene = ballOnGround(darkness(), {0.8F, 0.8F, 0.8F});
  const Vector camera{0, 20, 300};
  scene.camera = {toVec3(camera), {}, {0, 1, 0}, 5};
  scene.lighting.directional.push_back({{0, 0.8F, 0.6F}, {2, 3, 4}});
  const auto without = render(scene, options, {Aov::Radiance, Aov::Object, Aov::Position})[0];
  options.specular = true;
  const auto images = render(options, {Aov::Radiance, Aov::Object, Aov::Position});
  ErrorsOfGround errors;
  int seen = 0;
  forEachCovered(images[0], [&](std::size_t i) {
    if (images[1].rgba[i] != 0) return;
    const Vector at = toVector(&images[2].rgba[i]);
    const Vector normal = unit(at);
    const Vector toCamera = unit(camera - at);
    const double cosine = dot(normal, toCamera);
    const Vector mirrored = 2 * cosine * normal - toCamera;
    if (mirrored[1] > -0.1 || cosine < 0.4) return;
    const Vector met = at + (-double{ballMm} - at[1]) / mirrored[1] * mirrored;
    // At least a cluster's width away from the shadow's cylinder.
    const double along = 0.8 * met[1] + 0.6 * met[2];
    if (std::sqrt(dot(met, met) - along * along) < 1.3 * double{ballMm}) return;
    const double expected = bssrdf::fresnelReflectance(darkness().eta, cosine) * 0.8 * 0.8 * 3 / pi;
    errors.add(double{images[0].rgba[i + 1] - without.rgba[i + 1]} / expected - 1);
    ++seen;
  });
  ASSERT_GT(seen, 100);
  EXPECT_LT(errors.rms(), 0.02);
}

// A sphere wholly above a surface element hides (R/r)² cos θ of its sky.
TEST_F(GroundTest, TheBallHidesItsPartOfTheSky) {
  RenderOptions options = finelyDivided(GroundTest::options());
  options.bounces = 0;
  Scene scene = ballOnGround(darkness(), {0.5F, 0.5F, 0.5F});
  scene.lighting.ambient = {1, 1, 1};
  for (const Transport transport : {Transport::Boundary, Transport::BetterDipole}) {
    options.transport = transport;
    ErrorsOfGround errors;
    forEachOfGround(look(scene, options), 1.5 * ballMm, 5 * ballMm,
                    [&](const Vector& found, const Vector&, double distance) {
                      const double radius{ballMm};
                      const double hidden = std::pow(radius / std::hypot(distance, radius), 3);
                      errors.add(found[1] / (0.5 * pi) - (1 - hidden));
                    });
    EXPECT_LT(errors.rms(), 0.02);
    EXPECT_NEAR(errors.mean(), 0, 0.01);
  }
}

TEST_F(GroundTest, InAWhiteFurnaceItIsAsBrightAsEverythingElse) {
  RenderOptions options = GroundTest::options();
  options.bounces = 8;
  Scene scene = ballOnGround(whiteness(), {1, 1, 1});
  scene.lighting.ambient = {1, 1, 1};
  ErrorsOfGround errors;
  forEachOfGround(
      look(scene, options), ballMm, 5 * ballMm,
      [&](const Vector& found, const Vector&, double) { errors.add(found[1] / pi - 1); });
  EXPECT_LT(errors.rms(), 0.005);
  EXPECT_LT(errors.largest(), 0.015);
}

TEST_F(GroundTest, ItsColourTintsWhatStandsOnIt) {
  Scene scene = sceneOf(sphere({0, 0, 0}, ballMm, 4), whiteness(), {0, 0, 60}, ballMm);
  scene.lighting.directional.push_back({{0, 0.6F, 0.8F}, {1, 1, 1}});
  Scene standing = scene;
  standing.objects.push_back(groundUnder(scene, {.color = {0.9F, 0, 0}}));
  const auto below = [&](const Scene& seen) {
    return toVector(look(seen, options())[0].pixel(pixels / 2, 3 * pixels / 4));
  };
  const Vector alone = below(scene);
  const Vector tinted = below(standing);
  EXPECT_GT(tinted[0], 1.1 * alone[0]);
  EXPECT_NEAR(tinted[1], alone[1], 0.02 * alone[1]);  // the ground reflects no green
}

TEST_F(GroundTest, DoesNotMoveAndHidesWhatShinesFromBelow) {
  Scene scene = ballOnGround(darkness(), {1, 1, 1});
  scene.lighting.directional.push_back({{0, -1, 0}, {1, 1, 1}});
  scene.lighting.points.push_back({{0, -2 * ballMm, 0}, {1e4F, 1e4F, 1e4F}});
  scene.deformers.push_back({.kind = DeformerKind::Twist, .amount = 1});
  const auto images = look(scene, options());
  forEachOfGround(images, 0, 5 * ballMm, [&](const Vector& found, const Vector& at, double) {
    EXPECT_EQ(found[1], 0);
    EXPECT_NEAR(at[1], -double{ballMm}, 1e-3);
  });
}

// Lambert's ball: a share of the irradiance, which is proportional to the cosine.
TEST_F(GroundTest, OtherOpaqueBodiesGiveBackLightAsWell) {
  Scene scene = sceneOf(sphere({0, 0, 0}, ballMm, 4), marble(), {0, 0, 60}, ballMm);
  scene.objects[0].opaque = mattMaterial({0.9F, 0.6F, 0.3F});
  scene.lighting.directional.push_back({{0, 0, 1}, {1, 1, 1}});
  const auto images = look(scene, options());
  int seen = 0;
  for (int y = 0; y < pixels; ++y)
    for (int x = 0; x < pixels; ++x) {
      if (images[0].pixel(x, y)[3] == 0) continue;
      const double cosine = toVector(images[2].pixel(x, y))[2] / double{ballMm};
      if (cosine < 0.3) continue;
      ++seen;
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(double{images[0].pixel(x, y)[c]}, (0.9 - 0.3 * static_cast<double>(c)) * cosine,
                    0.01);
    }
  EXPECT_GT(seen, 500);
}

// Without bounces it gives nothing back, so light in a body above it is the same, bit by bit.
TEST_F(GroundTest, DoesNotChangeTheLightInABodyFarAboveIt) {
  Scene scene = builtInBear();
  scene.objects[0].medium = marble();
  scene.lighting = {.directional = {{{0.5F, 0.5F, 0.7F}, {3, 3, 3}}}};
  RenderOptions options = finelyDivided(GroundTest::options());
  options.bounces = 0;
  const Image alone = render(scene, options, {Aov::Exitance})[0];
  for (const float heightMm : {-60.0F, -2000.0F}) {
    Scene above = scene;
    above.objects.push_back(groundUnder(scene, {.heightMm = heightMm}));
    const auto images = render(above, options, {Aov::Exitance, Aov::Object});
    int seen = 0;
    for (std::size_t i = 0; i < alone.rgba.size(); i += 4) {
      if (alone.rgba[i + 3] == 0 || images[1].rgba[i] != 0) continue;
      ++seen;
      for (std::size_t c = 0; c < 3; ++c) ASSERT_EQ(images[0].rgba[i + c], alone.rgba[i + c]);
    }
    EXPECT_GT(seen, 500);
  }
}

TEST_F(GroundTest, CountsForNoSize) {
  const Scene alone = sceneOf(sphere({0, 0, 0}, ballMm, 2), marble(), {0, 0, 60}, ballMm);
  Scene scene = alone;
  scene.objects.push_back(groundUnder(scene));
  EXPECT_EQ(diagonalMm(scene), diagonalMm(alone));
  EXPECT_EQ(defaultCamera(scene).positionMm, defaultCamera(alone).positionMm);
}

TEST_F(GroundTest, IsRefusedByThePatternAndAnywhereButLast) {
  Scene scene = ballOnGround(marble(), {1, 1, 1});
  RenderOptions options = GroundTest::options();
  options.transport = Transport::Dipole;
  options.sum = Sum::Pattern;
  EXPECT_THROW(look(scene, options), UsageError);
  std::swap(scene.objects[0], scene.objects[1]);
  EXPECT_THROW(renderer().setScene(scene), Error);
  std::swap(scene.objects[0], scene.objects[1]);
  scene.objects[1].opaque->baseColor = {2, 0, 0};
  EXPECT_THROW(renderer().setScene(scene), Error);
}

}  // namespace
}  // namespace opaline
