// Surfaces of few triangles, many mean free paths long.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "bssrdf/fresnel.h"
#include "bssrdf/profile.h"
#include "opaline/media.h"
#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"

namespace opaline {
namespace {

using namespace test;

using LargeSurfaceTest = RendererTest;

constexpr double marbleFreePathMm = 1 / (3.0 + 0.0071);  // of blue, where it is shortest

Mesh square(float halfMm, int cells = 1) {
  return sheet({0, 0, 0}, {halfMm, 0, 0}, {0, halfMm, 0}, cells);
}

RenderOptions optionsAt(Site site, int maxSurfels) {
  RenderOptions options = smallOptions();
  options.width = options.height = 32;
  options.site = site;
  options.maxSurfels = maxSurfels;
  return options;
}

// ∫ R_d over a square around a place in it, by the angle: (1/2π) ∫ D(ρ(θ)) dθ, where ρ is the
// distance to the border.
double overSquare(const bssrdf::Profile& profile, double halfMm, double x, double y) {
  constexpr int angles = 180;
  double sum = 0;
  for (int i = 0; i < angles; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.5) / angles;
    const double u = std::cos(angle);
    const double v = std::sin(angle);
    const double alongX = (halfMm - (u > 0 ? x : -x)) / std::abs(u);
    const double alongY = (halfMm - (v > 0 ? y : -y)) / std::abs(v);
    sum += profile.disc(std::min(alongX, alongY));
  }
  return sum / angles;
}

// Largest deviation from E ∫ R_d over the square, relative to its value in the middle.
double deviationOf(const std::vector<Image>& images, bssrdf::Model model, double halfMm) {
  double largest = 0;
  const std::array<bssrdf::Profile, 3> profiles = bssrdf::makeProfiles(model, marble());
  const double entering = 3 * (1 - bssrdf::fresnelReflectance(1.5, 1));
  std::array<double, 3> middle{};
  for (std::size_t c = 0; c < 3; ++c) middle[c] = entering * overSquare(profiles[c], halfMm, 0, 0);
  const int seen = forEachCovered(images[0], [&](std::size_t i) {
    const double x = static_cast<double>(images[1].rgba[i]);
    const double y = static_cast<double>(images[1].rgba[i + 1]);
    if (std::max(std::abs(x), std::abs(y)) > 0.9 * halfMm) return;
    for (std::size_t c = 0; c < 3; ++c) {
      const double exact = entering * overSquare(profiles[c], halfMm, x, y);
      largest = std::max(largest, std::abs(double{images[0].rgba[i + c]} - exact) / middle[c]);
    }
  });
  EXPECT_GT(seen, 400);
  return largest;
}

Scene litSquare(float halfMm) {
  Scene scene = sceneOf(square(halfMm), marble(), {0, 0, 4 * halfMm}, halfMm);
  scene.lighting.directional = {{{0, 0, 1}, {3, 3, 3}}};
  return scene;
}

// The result must not depend on the size of the square: 10 to 100,000 mean free paths.
TEST_F(LargeSurfaceTest, ASquareOfTwoTrianglesIsTheIntegralAtAnySize) {
  for (const double inFreePaths : {1e1, 1e2, 1e3, 1e4, 1e5}) {
    const double halfMm = inFreePaths * marbleFreePathMm / 2;
    renderer().setScene(litSquare(static_cast<float>(halfMm)));
    for (const auto& [transport, model] :
         {std::pair{Transport::Dipole, bssrdf::Model::Dipole},
          std::pair{Transport::BetterDipole, bssrdf::Model::BetterDipole},
          std::pair{Transport::Boundary, bssrdf::Model::BetterDipole}})
      for (const Sum sum : {Sum::Tree, Sum::All}) {
        if (transport != Transport::Dipole && (sum == Sum::All || inFreePaths > 1e3)) continue;
        RenderOptions options = optionsAt(Site::Auto, sum == Sum::Tree ? 16'384 : 1024);
        options.transport = transport;
        options.sum = sum;
        const std::vector<Image> images =
            render(options, {Aov::Exitance, Aov::Position, Aov::Evaluations});
        EXPECT_LT(deviationOf(images, model, halfMm), 0.02) << inFreePaths;
        if (sum == Sum::All) continue;
        forEachCovered(images[2], [&](std::size_t i) { ASSERT_LT(images[2].rgba[i], 600); });
      }
  }
}

// At the corners, too, the light that enters leaves, as a mean free path is tiny compared to the
// square.
TEST_F(LargeSurfaceTest, CornersOfAHugeSquareAreAsBrightAsItsMiddle) {
  const double halfMm = 5e4 * marbleFreePathMm;
  renderer().setScene(litSquare(static_cast<float>(halfMm)));
  const std::vector<Image> images =
      render(optionsAt(Site::Vertex, 32'768), {Aov::Exitance, Aov::Position});
  EXPECT_LT(deviationOf(images, bssrdf::Model::Dipole, halfMm), 0.02);
}

// A shadow's border, and places deep in the shadow. Sources are a third of a mean free path wide,
// or some mean free paths apart.
TEST_F(LargeSurfaceTest, ShadowsOnItAreThoseOfAFineGrid) {
  Scene scene = sceneOf(square(24), marble(), {0, 0, 80}, 22);
  scene.objects.push_back({"shade", sheet({44, 0, 30}, {30, 0, 0}, {0, 60, 0}, 1), marble()});
  scene.lighting.directional = {{toVec3(unit({1, 0, 1})), {3, 3, 3}}};
  RenderOptions options = optionsAt(Site::Fragment, 400'000);
  options.width = options.height = 64;
  const std::vector<Image> fine = render(scene, options, {Aov::Exitance, Aov::Object});
  float brightest = 0;
  forEachCovered(fine[0], [&](std::size_t i) { brightest = std::max(brightest, fine[0].rgba[i]); });
  // The border is known to half the spacing of the sources. Deep in the shadow, light from that
  // border dominates.
  struct Bound {
    int maxSurfels;
    float ofBrightest;
    float deep;
  };
  for (const Bound& bound : {Bound{1024, 0.08F, 0.5F}, Bound{4096, 0.04F, 0.12F}}) {
    options.maxSurfels = bound.maxSurfels;
    const std::vector<Image> coarse = render(options, {Aov::Exitance, Aov::Evaluations});
    int pixels = 0;
    forEachCovered(fine[0], [&](std::size_t i) {
      if (fine[1].rgba[i] != 0) return;
      ++pixels;
      for (std::size_t c = 0; c < 3; ++c) {
        const float exact = fine[0].rgba[i + c];
        const float off = std::abs(coarse[0].rgba[i + c] - exact);
        ASSERT_LT(off, bound.ofBrightest * brightest) << bound.maxSurfels;
        if (exact < 0.05F * brightest) {
          ASSERT_LT(off, bound.deep * std::max(exact, 1e-3F * brightest)) << bound.maxSurfels;
        }
      }
    });
    EXPECT_GT(pixels, 1500);
    forEachCovered(coarse[1], [&](std::size_t i) { ASSERT_LT(coarse[1].rgba[i], 1000); });
  }
}

// A fine body and a coarse floor in one mesh, with shadows between the floor's corners.
TEST_F(LargeSurfaceTest, AFineBodyDoesNotDecideForTheFloorUnderIt) {
  Scene scene = sceneOf(together(sphere({0, 0, 2}, 1, 4), square(100)), marble(), {0, 0, 300}, 100);
  scene.lighting.directional = {{{0, 0, 1}, {3, 3, 3}}};
  renderer().setScene(scene);
  const Image chosen = render(optionsAt(Site::Auto, 4096), {Aov::Exitance})[0];
  const Image fragment = render(optionsAt(Site::Fragment, 4096), {Aov::Exitance})[0];
  EXPECT_TRUE(chosen.rgba == fragment.rgba);
}

struct Spread {
  double mean = 0;
  double rms = 0;  // of the difference from it, over the mean
};

// Of a channel over places in the middle of a plate.
Spread spreadOf(const Image& image, const Image& position, std::size_t channel, float halfMm) {
  double sum = 0;
  double squares = 0;
  int seen = 0;
  forEachCovered(image, [&](std::size_t i) {
    if (std::max(std::abs(position.rgba[i]), std::abs(position.rgba[i + 1])) > halfMm) return;
    const auto value = static_cast<double>(image.rgba[i + channel]);
    sum += value;
    squares += value * value;
    ++seen;
  });
  EXPECT_GT(seen, 1000);
  const double mean = sum / seen;
  return {mean, std::sqrt(squares / seen - mean * mean) / mean};
}

RenderOptions ofPlates(int maxClusters) {
  RenderOptions options = optionsAt(Site::Fragment, 65'536);
  options.transport = Transport::Boundary;
  options.width = options.height = 128;
  options.maxClusters = maxClusters;
  return options;
}

// Light through a plate 20 times as wide as thick must be even in its middle, even if clusters are
// two mean free paths apart and larger than shape and medium ask for.
TEST_F(LargeSurfaceTest, APlateLitFromBehindIsEven) {
  Scene scene = sceneOf(box({0, 0, 0}, {88, 88, 4}, 1), *findMedium("chicken1"), {0, 0, 300}, 44);
  scene.lighting.directional = {{{0, 0, -1}, {3, 3, 3}}};
  const std::vector<Image> images = render(scene, ofPlates(2048), {Aov::Exitance, Aov::Position});
  for (std::size_t c = 0; c < 2; ++c)  // too little blue gets through
    EXPECT_LT(spreadOf(images[0], images[1], c, 44).rms, 0.05) << c;
}

struct SheetCase {
  const char* name;
  float thicknessMm;
  float toLight;  // along z; the camera is on the side of +z
  std::array<double, 3> exitance;
};

class AbsorbingSheetTest : public LargeSurfaceTest,
                           public testing::WithParamInterface<SheetCase> {};

// A third of a mean free path is less than the edge of a cluster. Expected is what discrete
// ordinates between smooth boundaries give (class Slab of tools/exit_law.py).
TEST_P(AbsorbingSheetTest, IsEvenAndOfTheRightBrightness) {
  const SheetCase& sheet = GetParam();
  Scene scene = sceneOf(box({0, 0, 0}, {15, 15, sheet.thicknessMm / 2}, 60),
                        *findMedium("gummy-red"), {0, 0, 58}, 20);
  scene.lighting.directional = {{{0, 0, sheet.toLight}, {3, 3, 3}}};
  RenderOptions options = ofPlates(8192);
  options.bounces = 0;
  const std::vector<Image> images = render(scene, options, {Aov::Exitance, Aov::Position});
  for (std::size_t c = 0; c < 3; ++c) {
    const Spread spread = spreadOf(images[0], images[1], c, 8);
    EXPECT_NEAR(spread.mean, sheet.exitance[c], 0.055 * sheet.exitance[c]) << c;
    EXPECT_LT(spread.rms, 0.02) << c;
  }
}

INSTANTIATE_TEST_SUITE_P(
    LitFrom, AbsorbingSheetTest,
    testing::Values(SheetCase{"BehindThin", 0.5F, -1, {0.3799, 0.2186, 0.2049}},
                    SheetCase{"InFrontThin", 0.5F, 1, {0.3816, 0.2200, 0.2063}},
                    SheetCase{"BehindThick", 2, -1, {0.9668, 0.4397, 0.3914}},
                    SheetCase{"InFrontThick", 2, 1, {1.0370, 0.4906, 0.4435}}),
    [](const auto& sheet) { return std::string(sheet.param.name); });

}  // namespace
}  // namespace opaline
