// The poke: press on the body and pull.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "gpu/gpu_fixture.h"
#include "gpu/helpers.h"
#include "opaline/error.h"
#include "renderer/shapes.h"
#include "soft_body/bodies.h"

namespace opaline {
namespace {

using namespace test;

constexpr double bearDiagonalMm = 50;

class SoftBodyTest : public gpu::GpuTest {
 protected:
  static const Mesh& bear() {
    static const Scene scene = builtInBear();
    return scene.objects[0].mesh;
  }
  static Field bearAtRest() {
    Field rest;
    for (const Vec3& p : bear().positionsMm) rest.push_back(toVector(p));
    return rest;
  }
  static SoftBodyMotion make(const Mesh& mesh, const SoftBodyOptions& options = {}) {
    return {device(), mesh.positionsMm, mesh.triangles, options};
  }
  /// Calls step() for some seconds at a rate.
  static void run(SoftBodyMotion& body, double callsPerSecond, double seconds) {
    const int calls = static_cast<int>(std::lround(callsPerSecond * seconds));
    for (int i = 0; i < calls; ++i) body.step(1 / callsPerSecond);
  }
};

TEST_F(SoftBodyTest, StandsStillUntilItIsTouched) {
  SoftBodyMotion body = make(bear());
  EXPECT_FALSE(body.moves());
  run(body, 10, 1);
  EXPECT_FALSE(body.moves());
  EXPECT_EQ(farthest(positionsOf(body), bearAtRest()), 0);
}

// At the turning point of a swing everything stands still for a moment.
TEST_F(SoftBodyTest, MovesUntilTheSwingIsOver) {
  for (const bool holds : {false, true}) {
    const Mesh mesh = bar(3, 12);
    SoftBodyOptions options;
    options.settleSeconds = 3;
    SoftBodyMotion body = make(mesh, options);
    body.grab({0, 12, 0}, 2);
    body.pull({2, 12, 0});
    run(body, 10, 4);
    if (holds)
      body.pull({1, 12, 0});
    else
      body.release();
    std::vector<Field> film;
    while (body.moves() && film.size() < 10'000) {
      body.step(0.005);
      film.push_back(positionsOf(body));
    }
    EXPECT_GT(film.size(), 200U);
    const Field last = film.back();
    for (int i = 0; i < 100; ++i) body.step(0.1);
    EXPECT_EQ(farthest(positionsOf(body), last), 0);
  }
}

class SoftBodyAtRate : public SoftBodyTest, public testing::WithParamInterface<double> {};

// Hard pulls towards a place 0.6 diagonals away, in four directions in turn.
TEST_P(SoftBodyAtRate, PulledHardItKeepsItsVolumeAndComesBack) {
  SoftBodyMotion body = make(bear());
  const Field rest = bearAtRest();
  const double volume = volumeOf(rest, bear().triangles);
  const auto look = [&](double seconds) {
    run(body, GetParam(), seconds);
    const Field now = positionsOf(body);
    EXPECT_TRUE(isFinite(now));
    EXPECT_NEAR(volumeOf(now, bear().triangles) / volume, 1, 0.05);
    return farthest(now, rest);
  };
  for (const Vec3& to : {Vec3{30, 39, 0}, Vec3{0, 69, 0}, Vec3{-20, 20, 20}, Vec3{0, 9, 0}}) {
    body.grab({0, 39, 0}, 4);
    body.pull(to);
    for (int i = 0; i < 5; ++i) look(0.1);
    EXPECT_GT(look(0.5), 0.25 * bearDiagonalMm);
    EXPECT_TRUE(body.moves());
    body.release();
    for (int i = 0; i < 10; ++i) look(0.1);
  }
  run(body, GetParam(), 2);
  EXPECT_LT(farthest(positionsOf(body), rest), 0.01 * bearDiagonalMm);
  run(body, GetParam(), 4);
  EXPECT_FALSE(body.moves());
  EXPECT_EQ(farthest(positionsOf(body), rest), 0);
}

// Pulled a quarter of the height away, the held place follows almost completely.
TEST_P(SoftBodyAtRate, FollowsWhereItIsPulled) {
  SoftBodyMotion body = make(bear());
  std::size_t top = 0;
  const Field rest = bearAtRest();
  for (std::size_t v = 0; v < rest.size(); ++v)
    if (rest[v][1] > rest[top][1]) top = v;
  body.grab(bear().positionsMm[top], 5);
  Vec3 to = bear().positionsMm[top];
  to[0] += 10;
  body.pull(to);
  run(body, GetParam(), 3);
  EXPECT_NEAR(positionsOf(body)[top][0], rest[top][0] + 10, 2.5);
}

INSTANTIATE_TEST_SUITE_P(FrameRates, SoftBodyAtRate, testing::Values(10.0, 240.0));

TEST_F(SoftBodyTest, TheSameMotionAtAnyRate) {
  std::vector<Field> ends;
  for (const double rate : {10.0, 240.0, 60.0}) {
    SoftBodyMotion body = make(bear());
    body.grab({6, 36, 0}, 4);
    body.pull({26, 40, 10});
    run(body, rate, 0.5);
    body.release();
    run(body, rate, 0.3);
    ends.push_back(positionsOf(body));
  }
  // One substep more or less of the 300 that the body has made.
  EXPECT_GT(farthest(ends[0], bearAtRest()), 0.02 * bearDiagonalMm);
  EXPECT_LT(farthest(ends[0], ends[1]), 0.005 * bearDiagonalMm);
  EXPECT_LT(farthest(ends[0], ends[2]), 0.005 * bearDiagonalMm);
}

// Whole substeps give equal results, however they are divided into calls.
TEST_F(SoftBodyTest, TheSameBitsForTheSameSubsteps) {
  std::vector<Field> ends;
  for (const int together : {1, 7, 70}) {
    SoftBodyMotion body = make(bear());
    const double h = body.dynamics().substepSeconds;
    body.grab({6, 36, 0}, 4);
    body.pull({26, 40, 10});
    for (int i = 0; i < 140; i += together) {
      if (i == 70) body.release();
      body.step((together + 1e-6) * h);
    }
    ends.push_back(positionsOf(body));
  }
  EXPECT_EQ(ends[0], ends[1]);
  EXPECT_EQ(ends[0], ends[2]);
}

TEST_F(SoftBodyTest, TwoRunsAreTheSame) {
  const auto end = [&] {
    SoftBodyMotion body = make(bear());
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(-30, 60);
    for (int i = 0; i < 40; ++i) {
      if (i % 8 == 0) body.grab({place(random), place(random), place(random)}, 8);
      body.pull({place(random), place(random), place(random)});
      body.step(0.021 * (i % 3));
    }
    return positionsOf(body);
  };
  EXPECT_EQ(end(), end());
}

TEST_F(SoftBodyTest, StaysFiniteAndInReachWhateverIsDone) {
  std::mt19937 random(11);
  const auto uniform = [&](float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
  };
  const auto anywhere = [&] {
    const float scale = std::pow(10.0F, uniform(0, 38));
    return Vec3{uniform(-1, 1) * scale, uniform(-1, 1) * scale, uniform(-1, 1) * scale};
  };
  const auto near = [&] { return Vec3{uniform(-15, 15), uniform(0, 40), uniform(-12, 12)}; };
  SoftBodyMotion body = make(bear());
  const Field rest = bearAtRest();
  for (int i = 0; i < 500; ++i) {
    switch (random() % 5) {
      case 0:
        body.grab(random() % 4 == 0 ? anywhere() : near(),
                  random() % 4 == 0 ? 1e38F : uniform(0, 20));
        break;
      case 1:
        body.release();
        break;
      case 2:
        body.pull(near());
        break;
      default:
        body.pull(anywhere());
    }
    body.step(random() % 20 == 0 ? 1e30 : static_cast<double>(uniform(0, 0.06F)));
    if (i % 10 != 9) continue;
    const Field now = positionsOf(body);
    ASSERT_TRUE(isFinite(now)) << i;
    ASSERT_LT(farthest(now, rest), 1.5 * bearDiagonalMm) << i;
  }
  body.release();
  run(body, 10, 10);
  EXPECT_FALSE(body.moves());
  EXPECT_EQ(farthest(positionsOf(body), rest), 0);
}

TEST_F(SoftBodyTest, OddBodiesMove) {
  const std::vector<std::pair<const char*, Mesh>> odd{
      {"sheet that stands", sheet({0, 5, 0}, {5, 0, 0}, {0, 5, 0})},
      {"sheet that lies", sheet({0, 0, 0}, {5, 0, 0}, {0, 0, 5})},
      {"open half", sheet({1e6F, 5, 0}, {5, 0, 0}, {0, 5, 5})},
      {"triangle", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, {{0, 1, 2}}, false}},
      {"needle", {{{0, 0, 0}, {0, 7, 0}, {0, 3, 0}}, {}, {{0, 1, 2}}, false}},
      {"tiny", sphere({0, 0, 0}, 1e-6F, 2)},
      {"huge", sphere({0, 0, 0}, 1e15F, 2)},
      {"solid", box({0, 0, 0}, {5, 5, 5})},
      {"spare vertex", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {99, 0, 9}}, {}, {{0, 1, 2}}, false}}};
  for (const auto& [name, mesh] : odd) {
    SCOPED_TRACE(name);
    SoftBodyOptions options;
    options.cells = 10;
    SoftBodyMotion body = make(mesh, options);
    EXPECT_LE(body.cage().nodes.size(), shared::maxSoftNodes);
    const Field rest = positionsOf(body);
    Vec3 at = mesh.positionsMm[0];
    for (const Triangle& t : mesh.triangles)
      for (const std::uint32_t v : t)
        if (mesh.positionsMm[v][1] > at[1]) at = mesh.positionsMm[v];
    const auto cell = static_cast<float>(body.cage().cellMm);
    body.grab(at, cell);
    body.pull({at[0] + 4 * cell, at[1] + 2 * cell, at[2]});
    run(body, 20, 1);
    EXPECT_TRUE(isFinite(positionsOf(body)));
    EXPECT_GT(farthest(positionsOf(body), rest), 0.05 * body.cage().cellMm);
    body.release();
    run(body, 20, 10);
    EXPECT_LT(farthest(positionsOf(body), rest), 0.01 * body.cage().cellMm * 16);
  }
}

TEST_F(SoftBodyTest, RefusesWhatMakesNoSense) {
  const Mesh mesh = sphere({0, 0, 0}, 5, 2);
  const auto with = [&](auto change) {
    SoftBodyOptions options;
    change(options);
    make(mesh, options);
  };
  EXPECT_THROW(with([](SoftBodyOptions& o) { o.cells = 1; }), UsageError);
  EXPECT_THROW(with([](SoftBodyOptions& o) { o.cells = 17; }), UsageError);
  EXPECT_THROW(with([](SoftBodyOptions& o) { o.swingHz = 0; }), UsageError);
  EXPECT_THROW(with([](SoftBodyOptions& o) { o.settleSeconds = -1; }), UsageError);
  EXPECT_THROW(with([](SoftBodyOptions& o) { o.heldFraction = 1; }), UsageError);
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(with([](SoftBodyOptions& o) { o.reach = nan; }), UsageError);
  Mesh bad = mesh;
  bad.positionsMm[7][1] = nan;
  EXPECT_THROW(make(bad), UsageError);
  bad = mesh;
  bad.triangles[3][0] = 1'000'000;
  EXPECT_THROW(make(bad), UsageError);
  bad = mesh;
  bad.triangles.clear();
  EXPECT_THROW(make(bad), UsageError);
  bad = mesh;
  for (Vec3& p : bad.positionsMm) p = {1, 2, 3};
  EXPECT_THROW(make(bad), UsageError);

  SoftBodyMotion body = make(mesh);
  EXPECT_THROW(body.grab({0, nan, 0}, 1), UsageError);
  EXPECT_THROW(body.grab({0, 0, 0}, -1), UsageError);
  EXPECT_THROW(body.grab({0, 0, 0}, nan), UsageError);
  EXPECT_THROW(body.pull({0, 0, std::numeric_limits<float>::infinity()}), UsageError);
  EXPECT_THROW(body.step(-0.1), UsageError);
  EXPECT_THROW(body.step(std::numeric_limits<double>::quiet_NaN()), UsageError);
  EXPECT_FALSE(body.moves());
}

}  // namespace
}  // namespace opaline
