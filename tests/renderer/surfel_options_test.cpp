// The options of sums over surfels: the budget, and changes from frame to frame.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "bssrdf/fresnel.h"
#include "bssrdf/profile.h"
#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"
#include "renderer/sums.h"

namespace opaline {
namespace {

using namespace test;

using SurfelOptionsTest = RendererTest;

RenderOptions optionsOf(int maxSurfels, Sum sum = Sum::Tree) {
  RenderOptions options = smallOptions();
  options.width = options.height = 32;
  options.dsmSize = 128;
  options.maxSurfels = maxSurfels;
  options.sum = sum;
  return options;
}

Scene ballInOneLight() {
  Scene scene = sceneOf(sphere({0, 0, 0}, 6, 3), skin(), {0, 3, 24}, 7);
  scene.lighting.directional = {{{0.45F, 0.35F, -0.82F}, {3, 3, 3}}};
  return scene;
}

TEST_F(SurfelOptionsTest, ABudgetThatBindsIsKeptAndSaid) {
  std::vector<std::string> notes;
  RendererOptions rendererOptions = sharedRenderer().options();
  rendererOptions.log = [&](LogLevel level, std::string_view message) {
    if (level == LogLevel::Note) notes.emplace_back(message);
  };
  Renderer fresh(rendererOptions);
  fresh.setScene(ballInOneLight());
  const std::size_t wanted = fresh.render(optionsOf(262'144)).report.sources;
  EXPECT_TRUE(notes.empty()) << notes.front();
  for (const int budget : {1024, 1500}) {
    notes.clear();
    const std::size_t made = fresh.render(optionsOf(budget)).report.sources;
    EXPECT_LE(made, static_cast<std::size_t>(budget));
    EXPECT_LT(made, wanted);
    EXPECT_GE(made, static_cast<std::size_t>(budget) / 3);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NE(notes[0].find(std::to_string(budget)), std::string::npos) << notes[0];
  }
}

// Four corners tell nothing of what lies between them; a fine grid does.
TEST_F(SurfelOptionsTest, SumsAtVerticesFarApartAreSaid) {
  std::vector<std::string> notes;
  RendererOptions rendererOptions = sharedRenderer().options();
  rendererOptions.log = [&](LogLevel level, std::string_view message) {
    if (level == LogLevel::Note) notes.emplace_back(message);
  };
  Renderer fresh(rendererOptions);
  const auto notesOf = [&](int cells, Site site) {
    notes.clear();
    fresh.setScene(sceneOf(sheet({}, {5, 0, 0}, {0, 5, 0}, cells), marble(), {0, 0, 40}, 6));
    RenderOptions options = optionsOf(262'144);
    options.site = site;
    fresh.render(options);
    return notes.size();
  };
  EXPECT_EQ(notesOf(1, Site::Auto), 0U);
  EXPECT_EQ(notesOf(24, Site::Vertex), 0U);
  ASSERT_EQ(notesOf(1, Site::Vertex), 1U);
  EXPECT_NE(notes[0].find("RenderOptions::site"), std::string::npos) << notes[0];
}

// A body far larger than the medium is deep wants millions of surfels; with the default budget they
// are coarse, and a sphere in uniform light is still B = E · D(2R).
TEST_F(SurfelOptionsTest, TheDefaultBudgetServesLargeBodies) {
  constexpr float radiusMm = 120;
  Scene scene = sceneOf(sphere({0, 0, 0}, radiusMm), marble(), {0, 0, 500}, 125);
  scene.lighting.ambient = {1, 1, 1};
  renderer().setScene(scene);
  for (const Site site : {Site::Fragment, Site::Vertex}) {
    RenderOptions options = optionsOf(262'144);
    options.site = site;
    const Image exitance = render(options, {Aov::Exitance})[0];
    double squares = 0;
    double largest = 0;
    const int covered = forEachCovered(exitance, [&](std::size_t i) {
      for (std::size_t c = 0; c < 3; ++c) {
        const double exact =
            std::numbers::pi * bssrdf::meanTransmittance(1.5) *
            bssrdf::makeProfile(bssrdf::Model::Dipole,
                                bssrdf::coefficients(marble(), static_cast<int>(c)))
                .disc(2 * static_cast<double>(radiusMm));
        const double off = static_cast<double>(exitance.rgba[i + c]) / exact - 1;
        squares += off * off / 3;
        largest = std::max(largest, std::abs(off));
      }
    });
    EXPECT_LT(std::sqrt(squares / covered), 0.01);
    EXPECT_LT(largest, 0.03);
  }
}

// Sums, budgets, transports and tolerances in any order: each picture is the one it was at first.
TEST_F(SurfelOptionsTest, ChangeFromFrameToFrame) {
  std::vector<RenderOptions> all;
  for (const int maxSurfels : {262'144, 1024})
    for (const Sum sum : {Sum::Tree, Sum::All, Sum::Pattern})
      all.push_back(optionsOf(maxSurfels, sum));
  all.push_back(all[0]);
  all.back().tolerance = 0.1F;
  all.push_back(all[0]);
  all.back().transport = Transport::BetterDipole;
  all.push_back(all[3]);
  all.back().transport = Transport::BetterDipole;
  std::vector<Image> first;
  for (const RenderOptions& options : all)
    first.push_back(render(ballInOneLight(), options, {Aov::Exitance})[0]);
  renderer().setScene(ballInOneLight());
  for (const std::size_t step : {1U, 5U}) {
    std::size_t at = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      at = (at + step) % all.size();
      EXPECT_TRUE(render(all[at], {Aov::Exitance})[0].rgba == first[at].rgba)
          << "options " << at << ", step " << step;
    }
  }
  EXPECT_FALSE(first[0].rgba == first[6].rgba);
  EXPECT_FALSE(first[0].rgba == first[3].rgba);
  EXPECT_FALSE(first[3].rgba == first[8].rgba);
}

TEST_F(SurfelOptionsTest, GivenPositionsSurviveAnotherBudget) {
  const Scene scene = ballInOneLight();
  renderer().setScene(scene);
  std::vector<Vec3> positions = scene.objects[0].mesh.positionsMm;
  for (Vec3& p : positions) p[1] *= 0.5F;
  renderer().replacePositions(0, positions);
  Scene moved = scene;
  moved.objects[0].mesh.positionsMm = positions;
  for (const int maxSurfels : {262'144, 1024, 262'144}) {
    const std::vector<Image> images = render(optionsOf(maxSurfels), {Aov::Exitance, Aov::Position});
    forEachCovered(images[1],
                   [&](std::size_t i) { ASSERT_LT(std::abs(images[1].rgba[i + 1]), 3.1F); });
    EXPECT_GT(meanOf(images[0])[0], 0);
  }
  renderer().restorePositions(0);
}

}  // namespace
}  // namespace opaline
