#include "paper/atlas/geodesic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "awkward_meshes.h"

namespace opaline::atlas {
namespace {

using Vector = std::array<double, 3>;

using std::numbers::pi;

Vector toVector(const Vec3& p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

double distance(const Vector& a, const Vector& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

Vector placeOf(const awkward::Shape& shape, const SurfacePoint& point) {
  Vector place{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector corner = toVector(shape.positions[shape.triangles[point.triangle][i]]);
    for (std::size_t axis = 0; axis < 3; ++axis)
      place[axis] += static_cast<double>(point.barycentric[i]) * corner[axis];
  }
  return place;
}

std::vector<GeodesicStar> starsOf(const awkward::Shape& shape, double distanceMm) {
  const std::vector<double> distances(shape.positions.size(), distanceMm);
  return walkFromVertices({shape.positions, shape.triangles, shape.objects}, distances);
}

void expectSound(const awkward::Shape& shape, const GeodesicStar& star, double distanceMm) {
  for (const SurfacePoint& point : star) {
    if (point.triangle == SurfacePoint::nowhere) continue;
    ASSERT_LT(point.triangle, shape.triangles.size()) << shape.name;
    ASSERT_GE(point.walkedMm, 0) << shape.name;
    ASSERT_LE(static_cast<double>(point.walkedMm), distanceMm * (1 + 1e-6)) << shape.name;
    float sum = 0;
    for (const float weight : point.barycentric) {
      ASSERT_GE(weight, 0) << shape.name;
      sum += weight;
    }
    ASSERT_NEAR(sum, 1, 1e-5) << shape.name;
  }
}

std::uint32_t vertexAt(const awkward::Shape& shape, const Vector& place) {
  const auto nearer = [&](const Vec3& a, const Vec3& b) {
    return distance(toVector(a), place) < distance(toVector(b), place);
  };
  return static_cast<std::uint32_t>(
      std::min_element(shape.positions.begin(), shape.positions.end(), nearer) -
      shape.positions.begin());
}

double angleOf(std::size_t walk) {
  return (static_cast<double>(walk) + 0.5) * pi / 4;
}

// In the plane z = 0, 8 mm wide and high, cells of unequal size.
awkward::Shape sheet() {
  awkward::Shape shape{"sheet", {}, {}, {}};
  awkward::addGrid(shape, 16, 8, [](double u, double v) {
    return awkward::vec(8 * u + 0.1 * std::sin(2 * pi * u), 8 * v, 0);
  });
  return shape;
}

// A cylinder around the y axis whose facets touch a radius of 2 mm with their edges.
constexpr int facets = 96;
awkward::Shape cylinder() {
  awkward::Shape shape{"cylinder", {}, {}, {}};
  awkward::addGrid(shape, facets, 20, [](double u, double v) {
    return awkward::vec(2 * std::cos(awkward::turn(u)), 10 * v - 5,
                        -2 * std::sin(awkward::turn(u)));
  });
  return shape;
}

awkward::Shape cube() {
  awkward::Shape shape{"cube", {}, {}, {}};
  const auto face = [&](const auto& place) { awkward::addGrid(shape, 4, 4, place); };
  face([](double u, double v) { return awkward::vec(u, v, 1); });
  face([](double u, double v) { return awkward::vec(v, u, 0); });
  face([](double u, double v) { return awkward::vec(1, u, v); });
  face([](double u, double v) { return awkward::vec(0, v, u); });
  face([](double u, double v) { return awkward::vec(v, 1, u); });
  face([](double u, double v) { return awkward::vec(u, 0, v); });
  return shape;
}

// An icosahedron whose triangles are halved again and again, on the unit sphere.
awkward::Shape icosphere(int levels) {
  awkward::Shape shape{"icosphere", {}, {}, {}};
  const double g = std::numbers::phi;
  for (const double a : {-1.0, 1.0})
    for (const double b : {-g, g})
      for (const auto& [x, y, z] : {Vector{0, a, b}, {a, b, 0}, {b, 0, a}})
        awkward::addVertex(shape, x, y, z);
  for (std::uint32_t i = 0; i < 12; ++i)
    for (std::uint32_t j = i + 1; j < 12; ++j)
      for (std::uint32_t k = j + 1; k < 12; ++k) {
        const Vector p = toVector(shape.positions[i]);
        const Vector q = toVector(shape.positions[j]);
        const Vector r = toVector(shape.positions[k]);
        if (std::max({distance(p, q), distance(q, r), distance(r, p)}) > 2.1) continue;
        const double outside = p[0] * (q[1] * r[2] - q[2] * r[1]) +
                               p[1] * (q[2] * r[0] - q[0] * r[2]) +
                               p[2] * (q[0] * r[1] - q[1] * r[0]);
        shape.triangles.push_back(outside > 0 ? Triangle{i, j, k} : Triangle{i, k, j});
      }
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> halves;
    const auto half = [&](std::uint32_t a, std::uint32_t b) {
      const auto [found, isNew] = halves.try_emplace(std::minmax(a, b), 0U);
      if (isNew) {
        const Vector p = toVector(shape.positions[a]);
        const Vector q = toVector(shape.positions[b]);
        found->second =
            awkward::addVertex(shape, (p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2);
      }
      return found->second;
    };
    std::vector<Triangle> fine;
    for (const auto& [a, b, c] : shape.triangles) {
      const std::uint32_t ab = half(a, b);
      const std::uint32_t bc = half(b, c);
      const std::uint32_t ca = half(c, a);
      for (const Triangle& t : {Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
        fine.push_back(t);
    }
    shape.triangles = fine;
    for (Vec3& p : shape.positions) {
      const auto length = static_cast<float>(distance(toVector(p), {}));
      p = {p[0] / length, p[1] / length, p[2] / length};
    }
  }
  return shape;
}

TEST(Geodesic, IsStraightInAPlane) {
  const awkward::Shape shape = sheet();
  const std::vector<GeodesicStar> stars = starsOf(shape, 2.5);
  int inside = 0;
  for (std::size_t v = 0; v < stars.size(); ++v) {
    const Vector from = toVector(shape.positions[v]);
    expectSound(shape, stars[v], 2.5);
    for (std::size_t i = 0; i < 8; ++i) {
      // Counter-clockwise from the rise along +y, as seen from the side to which the normal +z
      // points.
      const Vector end{from[0] - 2.5 * std::sin(angleOf(i)), from[1] + 2.5 * std::cos(angleOf(i)),
                       0};
      if (std::min(end[0], end[1]) < 0 || std::max(end[0], end[1]) > 8) continue;
      ++inside;
      ASSERT_NE(stars[v][i].triangle, SurfacePoint::nowhere);
      ASSERT_NEAR(stars[v][i].walkedMm, 2.5, 1e-6);
      ASSERT_LT(distance(placeOf(shape, stars[v][i]), end), 1e-5) << "vertex " << v << ' ' << i;
    }
  }
  EXPECT_GT(inside, 500);
}

TEST(Geodesic, EndsAtABorderAndSaysHowFarItCame) {
  const awkward::Shape shape = sheet();
  const std::uint32_t vertex = vertexAt(shape, {2, 3, 0});
  const Vector from = toVector(shape.positions[vertex]);
  const GeodesicStar star = starsOf(shape, 100)[vertex];
  for (std::size_t i = 0; i < 8; ++i) {
    const double x = -std::sin(angleOf(i));
    const double y = std::cos(angleOf(i));
    const double walked =
        std::min((x > 0 ? 8 - from[0] : -from[0]) / x, (y > 0 ? 8 - from[1] : -from[1]) / y);
    ASSERT_NE(star[i].triangle, SurfacePoint::nowhere);
    EXPECT_NEAR(star[i].walkedMm, walked, 1e-5) << i;
    EXPECT_LT(distance(placeOf(shape, star[i]), {from[0] + walked * x, from[1] + walked * y, 0}),
              1e-5)
        << i;
  }
}

// Only two of the eight directions from a corner of the sheet lead over it.
TEST(Geodesic, StartsNowhereWhereNoSurfaceLies) {
  const awkward::Shape shape = sheet();
  const GeodesicStar star = starsOf(shape, 1)[vertexAt(shape, {0, 0, 0})];
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_EQ(star[i].triangle != SurfacePoint::nowhere, i == 6 || i == 7) << i;
}

// A great circle's chord is 2 sin(d/2), and directions from one point meet the circle of their ends
// 45° apart.
TEST(Geodesic, FollowsGreatCircles) {
  const awkward::Shape shape = icosphere(4);
  ASSERT_EQ(shape.triangles.size(), 5120U);
  for (const double d : {0.3, 1.0, 2.0}) {
    const std::vector<GeodesicStar> stars = starsOf(shape, d);
    for (std::size_t v = 0; v < stars.size(); v += 11) {
      const Vector from = toVector(shape.positions[v]);
      if (std::abs(from[1]) > 0.99) continue;  // no rise along y
      const double flat = std::hypot(from[0], from[2]);
      const Vector rise{-from[0] * from[1] / flat, flat, -from[2] * from[1] / flat};
      const Vector side{from[1] * rise[2] - from[2] * rise[1],
                        from[2] * rise[0] - from[0] * rise[2],
                        from[0] * rise[1] - from[1] * rise[0]};
      for (std::size_t i = 0; i < 8; ++i) {
        ASSERT_NE(stars[v][i].triangle, SurfacePoint::nowhere);
        ASSERT_NEAR(stars[v][i].walkedMm, d, 1e-5);
        const Vector end = placeOf(shape, stars[v][i]);
        ASSERT_NEAR(distance(end, from) / (2 * std::sin(d / 2)), 1, 0.01) << "d " << d;
        const double along = end[0] * rise[0] + end[1] * rise[1] + end[2] * rise[2];
        const double aside = end[0] * side[0] + end[1] * side[1] + end[2] * side[2];
        const double turn = std::remainder(std::atan2(aside, along) - angleOf(i), 2 * pi);
        ASSERT_LT(std::abs(turn) * 180 / pi, 3) << "d " << d << ", vertex " << v << ", walk " << i;
      }
    }
  }
}

// A helix: the height grows with the cosine, the way around with the sine.
TEST(Geodesic, WindsAroundACylinder) {
  const awkward::Shape shape = cylinder();
  const double d = 4.5;
  const GeodesicStar star = starsOf(shape, d)[vertexAt(shape, {2, 0, 0})];
  for (std::size_t i = 0; i < 8; ++i) {
    ASSERT_NE(star[i].triangle, SurfacePoint::nowhere);
    const Vector end = placeOf(shape, star[i]);
    const double turn = d * std::sin(angleOf(i)) / 2;  // counter-clockwise from +x: towards +z
    EXPECT_NEAR(star[i].walkedMm, d, 1e-5);
    EXPECT_NEAR(end[1], d * std::cos(angleOf(i)), 0.01 * d) << i;
    EXPECT_LT(std::abs(std::remainder(std::atan2(end[2], end[0]) - turn, 2 * pi)), 0.02) << i;
  }
}

TEST(Geodesic, UnfoldsOverTheEdgesOfACube) {
  const awkward::Shape shape = cube();
  const double d = 0.9;
  const std::vector<GeodesicStar> stars = starsOf(shape, d);
  const GeodesicStar& star = stars[vertexAt(shape, {0.5, 0.5, 1})];
  for (std::size_t i = 0; i < 8; ++i) {
    // In the plane of the face z = 1, and folded down where it leaves the face.
    Vector end{0.5 - d * std::sin(angleOf(i)), 0.5 + d * std::cos(angleOf(i)), 1};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double inFace = std::clamp(end[axis], 0.0, 1.0);
      end[2] -= std::abs(end[axis] - inFace);
      end[axis] = inFace;
    }
    ASSERT_NE(star[i].triangle, SurfacePoint::nowhere);
    EXPECT_LT(distance(placeOf(shape, star[i]), end), 1e-5) << i;
    EXPECT_NEAR(star[i].walkedMm, d, 1e-6) << i;
  }
}

TEST(Geodesic, VerticesAtOnePlaceShareAStar) {
  const awkward::Shape shape = cube();
  const std::vector<GeodesicStar> stars = starsOf(shape, 0.4);
  int shared = 0;
  for (std::size_t a = 0; a < stars.size(); ++a)
    for (std::size_t b = a + 1; b < stars.size(); ++b) {
      if (shape.positions[a] != shape.positions[b]) continue;
      ++shared;
      for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(stars[a][i].triangle, stars[b][i].triangle);
        EXPECT_EQ(stars[a][i].barycentric, stars[b][i].barycentric);
        EXPECT_EQ(stars[a][i].walkedMm, stars[b][i].walkedMm);
      }
    }
  EXPECT_EQ(shared, 12 * 3 + 8 * 3);  // inside the edges, two faces each; at corners three
}

TEST(Geodesic, EveryVertexWalksItsOwnDistance) {
  const awkward::Shape shape = sheet();
  std::vector<double> distances;
  for (std::size_t v = 0; v < shape.positions.size(); ++v)
    distances.push_back(0.01 * static_cast<double>(v % 7));
  const auto stars = walkFromVertices({shape.positions, shape.triangles, {}}, distances);
  for (std::size_t v = 0; v < stars.size(); ++v)
    for (const SurfacePoint& point : stars[v])
      if (point.triangle != SurfacePoint::nowhere) {
        ASSERT_NEAR(static_cast<double>(point.walkedMm), distances[v], 1e-6);
        ASSERT_NEAR(distance(placeOf(shape, point), toVector(shape.positions[v])), distances[v],
                    1e-5);
      }
}

TEST(Geodesic, SurvivesAnySurface) {
  for (const awkward::Shape& shape : awkward::all())
    for (const double d : {0.0, 0.05, 3.0}) {
      const std::vector<GeodesicStar> stars = starsOf(shape, d);
      ASSERT_EQ(stars.size(), shape.positions.size());
      for (const GeodesicStar& star : stars) expectSound(shape, star, d);
    }
  for (const GeodesicStar& star : starsOf(awkward::onlyDegenerate(), 1))
    for (const SurfacePoint& point : star) EXPECT_EQ(point.triangle, SurfacePoint::nowhere);
}

// Degenerate triangles are borders, where walks over the others end.
TEST(Geodesic, TakesNoNoticeOfDegenerateTriangles) {
  awkward::Shape shape = sheet();
  const std::vector<GeodesicStar> clean = starsOf(shape, 1);
  for (std::uint32_t i = 0; i < 20; ++i) shape.triangles.push_back({i, i, i + 1});
  shape.triangles.push_back({3, 3, 3});
  const std::vector<GeodesicStar> stars = starsOf(shape, 1);
  for (std::size_t v = 0; v < stars.size(); ++v)
    for (std::size_t i = 0; i < 8; ++i) {
      ASSERT_EQ(stars[v][i].triangle, clean[v][i].triangle);
      ASSERT_EQ(stars[v][i].barycentric, clean[v][i].barycentric);
    }
}

}  // namespace
}  // namespace opaline::atlas
