// Rays through deformed surfaces on the device against all triangles in double precision.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "gpu/gpu_fixture.h"
#include "passes/ray_bodies.h"
#include "passes/ray_tracer.h"
#include "shared_files.h"

namespace opaline::passes {
namespace {

using namespace test;
using opaline::test::operator+;
using opaline::test::operator-;
using opaline::test::operator*;
using opaline::test::box;
using opaline::test::dot;
using opaline::test::length;
using opaline::test::sphere;
using opaline::test::toVec3;
using opaline::test::toVector;
using opaline::test::unit;

namespace fs = std::filesystem;

/// Who casts the rays.
enum class By { ComputeShaders, RayQueries };

std::string nameOf(By by) {
  return by == By::RayQueries ? "by_ray_queries" : "by_compute_shaders";
}

class RaysTest : public testing::TestWithParam<By> {
 protected:
  void SetUp() override {
    shared().open();
    if (shared().device != nullptr) return;
    if (GetParam() == By::RayQueries) GTEST_SKIP() << shared().reason;
    FAIL() << "GPU tests need a Vulkan device and the validation layer: " << shared().reason;
  }
  void TearDown() override { shared().reportMessages(); }

  static gpu::SharedDevice& shared() {
    return GetParam() == By::RayQueries ? gpu::sharedRayQueryDevice() : gpu::sharedDevice();
  }
  static gpu::Device& device() { return *shared().device; }
};

INSTANTIATE_TEST_SUITE_P(Ways, RaysTest, testing::Values(By::ComputeShaders, By::RayQueries),
                         [](const auto& tested) { return nameOf(tested.param); });

class Random {
 public:
  double between(double low, double high) { return low + (high - low) * uniform_(generator_); }
  std::uint32_t below(std::size_t count) {
    return static_cast<std::uint32_t>(generator_() % count);
  }
  Vector direction() {
    while (true) {
      const Vector v{between(-1, 1), between(-1, 1), between(-1, 1)};
      if (dot(v, v) > 0.01 && dot(v, v) < 1) return unit(v);
    }
  }
  Vector within(double mm) { return {between(-mm, mm), between(-mm, mm), between(-mm, mm)}; }

 private:
  std::mt19937 generator_{7};
  std::uniform_real_distribution<double> uniform_{0, 1};
};

Ray rayOf(const Vector& origin, const Vector& direction) {
  return {.origin = toVec3(origin), .direction = toVec3(direction)};
}

std::vector<Ray> randomRays(const Body& body, std::size_t count) {
  Random random;
  const double reachMm = body.reachMm();
  std::vector<Ray> rays;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector origin = random.within((i % 3 == 0 ? 2.5 : 1) * reachMm);
    Vector direction = random.direction();
    if (i % 2 == 0) {
      const Vector target = body.place(random.below(body.moved.size()));
      direction = target + random.within(0.01 * reachMm) - origin;
    }
    if (i % 5 == 0) direction[random.below(3)] = 0;
    if (i % 7 == 0) direction = {0, random.below(2) == 0 ? -1.0 : 1.0, 0};
    rays.push_back(rayOf(origin, direction));
    if (i % 11 == 0) rays.back().to = static_cast<float>(random.between(0, 2));
    if (i % 13 == 0) rays.back().from = static_cast<float>(random.between(0, 1));
  }
  return rays;
}

std::array<Vector, 3> cornersOf(const Body& body, const surfels::Piece& piece) {
  const Triangle& triangle = body.triangles[piece.triangle];
  std::array<Vector, 3> corners{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto v = static_cast<double>(piece.corners[i][0]);
    const auto w = static_cast<double>(piece.corners[i][1]);
    corners[i] = (1 - v - w) * body.place(triangle[0]) + v * body.place(triangle[1]) +
                 w * body.place(triangle[2]);
  }
  return corners;
}

/// How far rounding moves edges for a ray.
double roundingMm(double reachMm, const Ray& ray) {
  for (const float x : ray.origin) reachMm = std::max(reachMm, static_cast<double>(std::abs(x)));
  return 1e-6 * reachMm;
}

/// Expects hits where all triangles have them, in the stated pieces.
void compare(const Body& body, const RayTracer& tracer, const std::vector<Ray>& rays,
             const std::vector<Hit>& hits, std::uint32_t firstObject, std::uint32_t endObject) {
  std::size_t found = 0;
  std::size_t unsure = 0;
  const double reachMm = body.reachMm();
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const double rounding = roundingMm(reachMm, rays[i]);
    const Expected expected = expectedHit(body, rays[i], rounding, firstObject, endObject);
    const auto distance = static_cast<double>(hits[i].distance);
    ASSERT_TRUE(std::isfinite(distance)) << i;
    if (expected.earliest < expected.latest - 1e-3 * expected.earliest) ++unsure;
    ASSERT_EQ(hits[i].blocked, hits[i].piece == noPiece ? 0U : 1U) << i;
    if (hits[i].piece == noPiece) {
      ASSERT_EQ(hits[i].distance, rays[i].to) << i;
      ASSERT_EQ(expected.latest, std::numeric_limits<double>::infinity()) << i;
      continue;
    }
    ++found;
    ASSERT_GE(distance, expected.earliest) << i;
    ASSERT_LE(distance, expected.latest) << i;
    ASSERT_LT(hits[i].piece, tracer.made().pieces.size());
    const surfels::Piece& piece = tracer.made().pieces[hits[i].piece];
    ASSERT_GT(piece.fraction, 0) << i;
    ASSERT_EQ(hits[i].object, body.objectOfTriangle[piece.triangle]) << i;
    const std::array<Vector, 3> corners = cornersOf(body, piece);
    const Vector normal = unit(cross(corners[1] - corners[0], corners[2] - corners[0]));
    ASSERT_LT(length(toVector(hits[i].normal.data()) - normal), 1e-4) << i;
    const PlaneHit there = meet(rays[i], corners);
    ASSERT_GE(there.insideMm, -4 * rounding / there.cosine) << i;
  }
  EXPECT_GT(found, rays.size() / 10);
  EXPECT_LT(found, rays.size());
  EXPECT_LT(unsure, rays.size() / 50);
}

void expectExact(gpu::Device& device, const Body& body, double spacingMm, std::size_t maxSurfels,
                 std::size_t count) {
  RayTracer tracer(device, body, spacingMm, maxSurfels);
  const std::vector<Ray> rays = randomRays(body, count);
  compare(body, tracer, rays, tracer.nearest(rays), 0, body.objects);
}

/// Whether two crossings are so close that rounding may merge them.
bool hasCrossingsTogether(const Body& body, const Ray& ray, double apartMm) {
  const double rounding = roundingMm(body.reachMm(), ray);
  std::vector<std::pair<double, double>> crossings;  // distance and its uncertainty
  for (const Triangle& triangle : body.triangles) {
    const PlaneHit hit =
        meet(ray, {body.place(triangle[0]), body.place(triangle[1]), body.place(triangle[2])});
    if (hit.insideMm > -rounding) crossings.emplace_back(hit.distance, rounding / hit.cosine);
  }
  std::sort(crossings.begin(), crossings.end());
  for (std::size_t i = 1; i < crossings.size(); ++i) {
    const double offMm = crossings[i].second + crossings[i - 1].second;
    if (crossings[i].first - crossings[i - 1].first < apartMm + offMm) return true;
  }
  return false;
}

void expectEvenCrossings(gpu::Device& device, const Body& body, double spacingMm, double apart) {
  RayTracer tracer(device, body, spacingMm, 1 << 20);
  Random random;
  const double reachMm = body.reachMm();
  std::vector<Ray> rays;
  for (int i = 0; i < 20'000; ++i) {
    const Vector origin = (4 * reachMm) * random.direction();
    rays.push_back(rayOf(origin, unit(random.within(0.5 * reachMm) - origin)));
  }
  const std::vector<std::uint32_t> counts =
      tracer.crossings(rays, static_cast<float>(apart * reachMm));
  std::size_t met = 0;
  std::size_t unsure = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (counts[i] % 2 != 0) {
      ASSERT_TRUE(hasCrossingsTogether(body, rays[i], apart * reachMm)) << i << ' ' << counts[i];
      ++unsure;
    }
    met += counts[i] > 0 ? 1U : 0U;
  }
  EXPECT_GT(met, rays.size() / 20);
  EXPECT_LT(unsure, 5U);
}

Body twistedBox() {
  Body body = bodyOf(box({1, 2, 3}, {8, 12, 5}, 3));
  body.move(twisted);
  return body;
}

Body threeObjects() {
  Body body = bodyOf(sphere({0, 0, 0}, 10, 3));
  body.add(box({3, 0, 0}, {3, 4, 2}, 3));
  body.add(sphere({-3, 0, 0}, 4, 2));
  body.move(twisted);
  return body;
}

TEST_P(RaysTest, MeetsTheBear) {
  expectExact(device(), bodyOf(builtin::bearMesh()), 100, 1 << 20, 500);
}

TEST_P(RaysTest, MeetsTheTwistedBear) {
  Body body = bodyOf(builtin::bearMesh());
  body.move(twisted);
  expectExact(device(), body, 100, 1 << 20, 500);
}

TEST_P(RaysTest, MeetsTheBunny) {
  const std::optional<fs::path> file = opaline::test::sharedModel("bunny_closed.ply");
  if (!file) GTEST_SKIP() << "OPALINE_MODELS has no bunny_closed.ply";
  LoadOptions load;
  load.diagonalMm = 50.0F;
  const Body body = bodyOf(loadScene(*file, load).objects[0].mesh);
  expectExact(device(), body, 100, 1 << 20, 400);
  expectEvenCrossings(device(), body, 100, 1e-5);
}

TEST_P(RaysTest, MeetsDividedTriangles) {
  const Body body = twistedBox();
  expectExact(device(), body, 0.5, 1 << 20, 20'000);
}

TEST_P(RaysTest, MeetsJoinedSurfels) {
  const Body body = threeObjects();
  RayTracer tracer(device(), body, 100, 300);
  ASSERT_GT(tracer.made().piecesPerSurfel, 1U);
  ASSERT_GT(tracer.made().pieces.size(), body.triangles.size());  // some fill up
  const std::vector<Ray> rays = randomRays(body, 10'000);
  compare(body, tracer, rays, tracer.nearest(rays), 0, body.objects);
}

TEST_P(RaysTest, MeetsOnlyTheObjectsAskedFor) {
  const Body body = threeObjects();
  RayTracer tracer(device(), body, 1, 1 << 20);
  const std::vector<Ray> rays = randomRays(body, 5000);
  for (std::uint32_t object = 0; object < body.objects; ++object)
    compare(body, tracer, rays, tracer.nearest(rays, object), object, object + 1);
  compare(body, tracer, rays, tracer.nearest(rays), 0, body.objects);
}

// The faces, edges and pieces' edges of the box lie in planes in which rays run or start.
TEST_P(RaysTest, MeetsBoxesAlongTheAxes) {
  Body body = bodyOf(box({0, 0, 0}, {8, 8, 8}, 4));
  RayTracer tracer(device(), body, 1, 1 << 20);
  std::vector<Ray> rays;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (int i = -7; i <= 7; ++i) {
      for (int k = -7; k <= 7; ++k) {
        for (const float side : {-1.0F, 1.0F}) {
          for (const float start : {0.0F, 20.0F}) {
            Ray ray;
            ray.origin[axis] = -side * start;
            ray.origin[(axis + 1) % 3] = static_cast<float>(i);
            ray.origin[(axis + 2) % 3] = static_cast<float>(k);
            ray.direction[axis] = side;
            rays.push_back(ray);
          }
        }
      }
    }
  }
  const std::vector<Hit> hits = tracer.nearest(rays);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const bool outside = i % 2 == 1;
    ASSERT_NE(hits[i].piece, noPiece) << i;
    ASSERT_NEAR(hits[i].distance, outside ? 12 : 8, 1e-4) << i;
  }
}

/// From inside, rays to vertices and to places on edges of triangles and pieces must hit something
/// no later than there, unless they just pass a protruding edge.
void expectNoCracks(gpu::Device& device, const Body& body, const Vector& inside, double spacingMm) {
  RayTracer tracer(device, body, spacingMm, 1 << 20);
  Random random;
  const double reachMm = body.reachMm();
  std::vector<Ray> rays;
  const auto aimAt = [&](const Vector& place) {
    const Vector origin = inside + random.within(0.01 * reachMm);
    rays.push_back(rayOf(origin, place - origin));
  };
  const auto aimAround = [&](const std::array<Vector, 3>& corners) {
    for (std::size_t i = 0; i < 3; ++i) {
      aimAt(corners[i]);
      aimAt(corners[i] + random.between(0, 1) * (corners[(i + 1) % 3] - corners[i]));
    }
  };
  for (const Triangle& t : body.triangles)
    aimAround({body.place(t[0]), body.place(t[1]), body.place(t[2])});
  for (const surfels::Piece& piece : tracer.made().pieces) aimAround(cornersOf(body, piece));

  const std::vector<Hit> hits = tracer.nearest(rays);
  std::size_t missed = 0;
  std::size_t passedBy = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (hits[i].piece == noPiece) ++missed;
    if (hits[i].piece == noPiece || hits[i].distance < 1.0001F || ++passedBy % 50 != 0) continue;
    const Expected expected =
        expectedHit(body, rays[i], roundingMm(reachMm, rays[i]), 0, body.objects);
    EXPECT_LE(static_cast<double>(hits[i].distance), expected.latest) << i;
  }
  EXPECT_EQ(missed, 0U) << "of " << rays.size();
  EXPECT_LT(passedBy, rays.size() / 100);
}

TEST_P(RaysTest, NoRaySlipsThroughASphere) {
  expectNoCracks(device(), bodyOf(sphere({50, 3, -20}, 10, 5)), {50, 3, -20}, 1);
}

TEST_P(RaysTest, NoRaySlipsThroughTheBear) {
  Body body = bodyOf(builtin::bearMesh());
  body.move(twisted);
  expectNoCracks(device(), body, {0, 15, 0}, 100);
}

// Neighbouring triangles are divided differently, so that corners of pieces lie on edges of others.
TEST_P(RaysTest, NoRaySlipsBetweenPieces) {
  Mesh mesh = sphere({0, 0, 0}, 10, 2);
  for (Vec3& p : mesh.positionsMm) p[1] = 1.7F * p[1] + 0.8F * p[0];
  Body body = bodyOf(mesh);
  body.move([](const Vector& p) {
    return Vector{p[0] + 40, 1.3 * p[1] - 30, p[2] + 0.3 * p[1] + 20};
  });
  expectNoCracks(device(), body, {40, -30, 20}, 0.2);
}

TEST_P(RaysTest, ClosedSurfacesAreCrossedEvenly) {
  Body bear = bodyOf(builtin::bearMesh());
  expectEvenCrossings(device(), bear, 100, 1e-5);
  bear.move(twisted);
  expectEvenCrossings(device(), bear, 100, 1e-5);
}

// A ray may hit both of two adjacent pieces, one slightly later than the other.
TEST_P(RaysTest, ClosedSurfacesOfPiecesAreCrossedEvenly) {
  Body body = bodyOf(sphere({1, 2, 3}, 10, 3));
  body.move(twisted);
  expectEvenCrossings(device(), body, 0.5, 1e-4);
}

// Triangles without area, points or lines, are never hit; flat ones with area are.
TEST_P(RaysTest, NothingIsHitThatHasNoArea) {
  Random random;
  Body body = bodyOf(sphere({0, 0, 0}, 10, 2));
  RayTracer tracer(device(), body, 1, 1 << 20);
  const std::vector<Ray> rays = randomRays(body, 5000);
  for (const Vector& stays : {Vector{0, 0, 0}, Vector{0, 1, 0}}) {
    body.move([&](const Vector& p) { return dot(stays, p) * stays + Vector{1, 2, 3}; });
    tracer.moveTo(body.moved);
    std::vector<Ray> aimed = rays;
    for (const Ray& ray : rays) {
      const Vector origin = toVector(ray.origin.data());
      aimed.push_back(rayOf(origin, body.place(random.below(body.moved.size())) - origin));
    }
    const std::vector<Hit> hits = tracer.nearest(aimed);
    for (std::size_t i = 0; i < aimed.size(); ++i) {
      ASSERT_EQ(hits[i].piece, noPiece) << i;
      ASSERT_EQ(hits[i].distance, aimed[i].to) << i;
    }
  }
  body.move([](const Vector& p) { return Vector{p[0], 0, p[2]}; });
  tracer.moveTo(body.moved);
  compare(body, tracer, rays, tracer.nearest(rays), 0, 1);
}

}  // namespace
}  // namespace opaline::passes
