// What is seen through bodies by light that they do not scatter, against Snell's, Fresnel's and
// Beer's laws. The bodies hardly scatter, so nothing else comes from them.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>

#include "bssrdf/fresnel.h"
#include "environment/lat_long.h"
#include "renderer/boundary_fixture.h"

namespace opaline {
namespace {

using namespace test;

using SeenThroughTest = RendererTest;

constexpr double etaOfGlass = 1.4;

Medium glass() {
  return {"glass", {1e-4F, 1e-4F, 1e-4F}, {0.1F, 0.3F, 0.6F}, static_cast<float>(etaOfGlass)};
}

RenderOptions withoutReflection(int edge) {
  RenderOptions options = boundaryOptions(edge);
  options.specular = false;
  return options;
}

double cosineInGlass(double cosine) {
  return std::sqrt(1 - (1 - cosine * cosine) / (etaOfGlass * etaOfGlass));
}

/// What gets in and out at equal angles, and through so much glass.
double throughGlass(std::size_t channel, double lengthMm, double cosine) {
  const double entering = 1 - bssrdf::fresnelReflectance(etaOfGlass, cosine);
  return entering * entering * std::exp(-glass().sigmaAPerMm[channel] * lengthMm);
}

std::array<double, 3> middleOf(const Image& image) {
  const float* pixel = image.pixel(image.width / 2, image.height / 2);
  return {pixel[0], pixel[1], pixel[2]};
}

/// A pane 1 mm thick, seen at so many degrees, with the camera at a distance of 20 mm.
Scene pane(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return sceneOf(
      box({0, 0, 0}, {40, 40, 0.5F}, 20), glass(),
      {static_cast<float>(20 * std::sin(angle)), 0, static_cast<float>(20 * std::cos(angle))}, 2);
}

TEST_F(SeenThroughTest, APaneShowsWhatIsBehindIt) {
  for (const bool light : {false, true})
    for (const double degrees : {0.0, 40.0, 60.0}) {
      Scene scene = pane(degrees);
      if (light) {
        scene.lighting.areas = {RectangleLight{{0, 0, -4}, {0, 90, 0}, {90, 0, 0}, {2, 2, 2}}};
        std::get<RectangleLight>(scene.lighting.areas[0]).twoSided = true;
      } else {
        Object floor{"floor", sheet({0, 0, -4}, {90, 0, 0}, {0, 90, 0}, 8), glass()};
        floor.opaque = mattMaterial({0, 0, 0});
        floor.opaque->emission = {2, 2, 2};
        scene.objects.push_back(floor);
      }
      const std::array<double, 3> seen =
          middleOf(renderBoundary(scene, withoutReflection(32), {Aov::Radiance}).images[0]);
      const double cosine = std::cos(degrees * std::numbers::pi / 180);
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(seen[c] / (2 * throughGlass(c, 1 / cosineInGlass(cosine), cosine)), 1, 0.005)
            << light << ' ' << degrees << ' ' << c;
    }
}

// A ball of glass shows the sky upside down.
TEST_F(SeenThroughTest, ABallRefractsTheSky) {
  const auto skyFrom = [](const Vector& d) { return 1 + 0.6 * d[0] + 0.3 * d[1]; };
  constexpr int rows = 128;
  Image sky(2 * rows, rows);
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < 2 * rows; ++x) {
      const Vector d = toVector(latLongDirection((x + 0.5) / (2 * rows), (y + 0.5) / rows));
      for (int c = 0; c < 3; ++c) sky.pixel(x, y)[c] = static_cast<float>(skyFrom(d));
    }
  constexpr double radiusMm = 2;
  const Vector camera{0, 0, 100};
  Scene scene =
      sceneOf(sphere({0, 0, 0}, static_cast<float>(radiusMm), 5), glass(), toVec3(camera), 2.2F);
  scene.lighting.environment = std::make_shared<const Image>(sky);
  const RenderResult result =
      renderBoundary(scene, withoutReflection(64), {Aov::Radiance, Aov::Position});
  int compared = 0;
  forEachCovered(result.images[1], [&](std::size_t i) {
    const Vector normal = unit(toVector(&result.images[1].rgba[i]));
    const Vector in = unit(radiusMm * normal - camera);
    const double cosine = -dot(in, normal);
    if (cosine < 0.55) return;  // where facets matter
    // In the plane of `in` and the normal, by the angles to the axis through the middle.
    const double inside = cosineInGlass(cosine);
    const double turned = 2 * (std::acos(cosine) - std::acos(inside));
    const Vector aside = in + cosine * normal;
    const Vector across = length(aside) > 0 ? unit(-1 * normal - dot(-1 * normal, in) * in) : aside;
    const Vector direction = std::cos(turned) * in + std::sin(turned) * across;
    for (std::size_t c = 0; c < 3; ++c) {
      const double expected = skyFrom(direction) * throughGlass(c, 2 * radiusMm * inside, cosine);
      ASSERT_NEAR(result.images[0].rgba[i + c], expected, 0.012 * expected) << cosine << ' ' << c;
    }
    ++compared;
  });
  EXPECT_GT(compared, 1500);
}

}  // namespace
}  // namespace opaline
