#include "scene/repair/repair.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "opaline/error.h"
#include "opaline/mesh.h"
#include "scene/mesh/normals.h"
#include "scene/repair/topology.h"
#include "scene/shapes.h"

namespace opaline::scene {
namespace {

using test::countOf;
using test::cube;
using Repairs = std::vector<Repair>;

/// A ball of stacked rings: closed, facing outwards, with distinct vertices.
RawMesh ball(std::uint32_t rings, std::uint32_t sides) {
  RawMesh mesh;
  mesh.positions.push_back({0, 1, 0});
  for (std::uint32_t r = 1; r < rings; ++r) {
    const double theta = std::numbers::pi * r / rings;
    for (std::uint32_t s = 0; s < sides; ++s) {
      const double phi = 2 * std::numbers::pi * s / sides;
      mesh.positions.push_back({static_cast<float>(std::sin(theta) * std::cos(phi)),
                                static_cast<float>(std::cos(theta)),
                                static_cast<float>(std::sin(theta) * std::sin(phi))});
    }
  }
  mesh.positions.push_back({0, -1, 0});
  const auto at = [&](std::uint32_t r, std::uint32_t s) { return 1 + (r - 1) * sides + s % sides; };
  const auto last = static_cast<std::uint32_t>(mesh.positions.size() - 1);
  for (std::uint32_t s = 0; s < sides; ++s) {
    mesh.triangles.push_back({0, at(1, s + 1), at(1, s)});
    for (std::uint32_t r = 1; r + 1 < rings; ++r) {
      mesh.triangles.push_back({at(r, s), at(r, s + 1), at(r + 1, s)});
      mesh.triangles.push_back({at(r, s + 1), at(r + 1, s + 1), at(r + 1, s)});
    }
    mesh.triangles.push_back({last, at(rings - 1, s), at(rings - 1, s + 1)});
  }
  return mesh;
}

double volumeOf(const RawMesh& mesh) {
  return test::signedVolume(mesh.positions, mesh.triangles);
}

// A ball whose last column of vertices lies slightly beside its first, as sin 2π is not exactly 0.
RawMesh ballWithASeam(std::uint32_t rings, std::uint32_t sides, float beside) {
  RawMesh mesh = ball(rings, sides);
  const auto first = [&](std::uint32_t ring) { return 1 + (ring - 1) * sides; };
  std::vector<std::uint32_t> last(mesh.positions.size());
  for (std::uint32_t v = 0; v < last.size(); ++v) last[v] = v;
  for (std::uint32_t ring = 1; ring < rings; ++ring) {
    last[first(ring)] = static_cast<std::uint32_t>(mesh.positions.size());
    Vec3 position = mesh.positions[first(ring)];
    position[2] -= beside;
    mesh.positions.push_back(position);
  }
  // At the last side of the seam, triangles have z < 0.
  for (Triangle& t : mesh.triangles) {
    const bool below = std::any_of(t.begin(), t.end(),
                                   [&](std::uint32_t v) { return mesh.positions[v][2] < -1e-3F; });
    if (below)
      for (std::uint32_t& v : t) v = last[v];
  }
  return mesh;
}

TEST(Repair, SeamsOfRoundBodiesAreClosed) {
  RawMesh mesh = ballWithASeam(8, 12, 1.7e-7F);
  ASSERT_FALSE(factsOf(mesh.positions, mesh.triangles).closed);
  EXPECT_EQ(countOf(repairMesh(mesh, "ball"), "vertices beside their seam"), 7U);
  EXPECT_TRUE(factsOf(mesh.positions, mesh.triangles).closed);
  // A deliberate gap stays.
  mesh = ballWithASeam(8, 12, 1e-4F);
  EXPECT_EQ(countOf(repairMesh(mesh, "ball"), "vertices beside their seam"), 0U);
  EXPECT_FALSE(factsOf(mesh.positions, mesh.triangles).closed);
}

TEST(Repair, CleanMeshesStayAsTheyAre) {
  for (RawMesh mesh : {cube(), ball(8, 12)}) {
    ASSERT_GT(volumeOf(mesh), 0);
    const RawMesh before = mesh;
    EXPECT_TRUE(repairMesh(mesh, "clean").empty());
    EXPECT_EQ(mesh.positions, before.positions);
    EXPECT_EQ(mesh.triangles, before.triangles);
  }
}

TEST(Repair, UnusedVerticesGo) {
  RawMesh mesh = cube();
  mesh.positions.insert(mesh.positions.begin() + 3, {9, 9, 9});
  mesh.positions.push_back({8, 8, 8});
  for (Triangle& t : mesh.triangles) {
    for (std::uint32_t& v : t) v += v >= 3 ? 1U : 0U;
  }
  const Repairs repairs = repairMesh(mesh, "unused");
  EXPECT_EQ(repairs.size(), 1U);
  EXPECT_EQ(countOf(repairs, "unused vertices"), 2U);
  EXPECT_EQ(mesh.positions, cube().positions);
  EXPECT_EQ(mesh.triangles, cube().triangles);
}

TEST(Repair, SoupIsSewn) {
  RawMesh mesh = test::soup(cube());
  const Repairs repairs = repairMesh(mesh, "soup");
  EXPECT_EQ(repairs.size(), 1U);
  EXPECT_EQ(countOf(repairs, "duplicate vertices"), 36U - 8U);
  EXPECT_EQ(mesh.positions.size(), 8U);
}

TEST(Repair, VerticesWithOtherNormalsOrTagsStayApart) {
  RawMesh mesh = test::soup(cube());
  for (const Triangle& t : mesh.triangles) {
    // The flat normal of an axis-aligned cube.
    const Vec3& a = mesh.positions[t[0]];
    Vec3 normal{0, 0, 0};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool constant =
          mesh.positions[t[1]][axis] == a[axis] && mesh.positions[t[2]][axis] == a[axis];
      if (constant) normal[axis] = a[axis] > 0 ? 1.0F : -1.0F;
    }
    for (int i = 0; i < 3; ++i) mesh.normals.push_back(normal);
  }
  RawMesh tagged = mesh;
  EXPECT_EQ(countOf(repairMesh(mesh, "flat"), "duplicate vertices"), 36U - 24U);
  tagged.tags.resize(36);
  for (std::size_t i = 0; i < 36; ++i) tagged.tags[i] = i;
  EXPECT_TRUE(repairMesh(tagged, "tagged").empty());
  EXPECT_EQ(tagged.positions.size(), 36U);
}

TEST(Repair, SurfacesThatTouchInAPointAreNotJoined) {
  RawMesh mesh = cube();
  test::append(mesh, cube({1, 1, 1}));
  EXPECT_TRUE(repairMesh(mesh, "touching").empty());
  EXPECT_EQ(mesh.positions.size(), 16U);
}

TEST(Repair, StackedClosedBodiesStay) {
  RawMesh mesh = cube();
  test::append(mesh, cube({1, 0, 0}));
  EXPECT_TRUE(repairMesh(mesh, "stacked").empty());
  EXPECT_EQ(mesh.triangles.size(), 24U);
}

TEST(Repair, DuplicateFacesGo) {
  RawMesh mesh = cube();
  const Triangle t = mesh.triangles[5];
  mesh.triangles.push_back(t);
  mesh.triangles.push_back({t[1], t[2], t[0]});  // the same turn
  mesh.triangles.push_back({t[0], t[2], t[1]});  // the reverse of the same surface
  const Repairs repairs = repairMesh(mesh, "twice");
  EXPECT_EQ(countOf(repairs, "duplicate faces"), 3U);
  EXPECT_EQ(repairs.size(), 1U);
  EXPECT_EQ(mesh.triangles, cube().triangles);
}

TEST(Repair, ASecondCopyWithVerticesOfItsOwnGoes) {
  RawMesh mesh = cube();
  test::append(mesh, cube());
  const Repairs repairs = repairMesh(mesh, "two in one place");
  EXPECT_EQ(countOf(repairs, "duplicate faces"), 12U);
  EXPECT_EQ(mesh.positions.size(), 8U);
  EXPECT_EQ(mesh.triangles.size(), 12U);
}

TEST(Repair, DegenerateTrianglesGo) {
  RawMesh mesh = cube();
  mesh.triangles.push_back({0, 0, 1});
  mesh.positions.push_back({0.5F, 0, 0});
  mesh.triangles.push_back({0, 8, 1});  // on one line
  mesh.badPolygons = 1;                 // a face of two corners
  const Repairs repairs = repairMesh(mesh, "degenerate");
  EXPECT_EQ(countOf(repairs, "degenerate triangles"), 3U);
  EXPECT_EQ(repairs.size(), 1U);
  EXPECT_EQ(mesh.positions.size(), 8U);
}

TEST(Repair, TinyBodiesAreNotDegenerate) {
  RawMesh mesh = cube({0, 0, 0}, 1e-18F);
  EXPECT_TRUE(repairMesh(mesh, "tiny").empty());
}

TEST(Repair, TrianglesThatDisagreeAreTurned) {
  RawMesh mesh = ball(8, 12);
  const double volume = volumeOf(mesh);
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) test::turn(mesh.triangles[i]);
  const std::size_t turned = (mesh.triangles.size() + 2) / 3;
  const Repairs repairs = repairMesh(mesh, "mixed");
  EXPECT_EQ(repairs.size(), 1U);
  EXPECT_EQ(countOf(repairs, "inconsistent orientation"), turned);
  EXPECT_NEAR(volumeOf(mesh), volume, 1e-6);
}

TEST(Repair, OutwardsWinsOverTheMajority) {
  RawMesh mesh = ball(8, 12);
  const double volume = volumeOf(mesh);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (i % 3 != 0) test::turn(mesh.triangles[i]);
  }
  repairMesh(mesh, "mostly inwards");
  EXPECT_NEAR(volumeOf(mesh), volume, 1e-6);
}

TEST(Repair, InwardComponentsAreTurned) {
  RawMesh mesh = cube();
  for (Triangle& t : mesh.triangles) test::turn(t);
  test::append(mesh, cube({5, 0, 0}));
  const Repairs repairs = repairMesh(mesh, "one inside out");
  EXPECT_EQ(repairs.size(), 1U);
  EXPECT_EQ(countOf(repairs, "inward orientation"), 12U);
  EXPECT_NEAR(volumeOf(mesh), 2, 1e-6);
}

TEST(Repair, CavitiesStay) {
  RawMesh mesh = cube({0, 0, 0}, 4);
  RawMesh hole = cube({1, 1, 1}, 2);
  for (Triangle& t : hole.triangles) test::turn(t);
  test::append(mesh, hole);
  EXPECT_TRUE(repairMesh(mesh, "hollow").empty());
  EXPECT_NEAR(volumeOf(mesh), 64 - 8, 1e-5);
}

// An edge whose ends lie exactly opposite each other as seen from the cavity's first corner, or
// from the middle of its first triangle. Rounding decides on which side of it a ray passes.
TEST(Repair, CavitiesStayBehindAnEdge) {
  for (const Vec3& at : {Vec3{0, 0, 0}, Vec3{-0.25F, -0.5F, 0}}) {
    RawMesh hole = cube(at, 0.75F);
    for (Triangle& t : hole.triangles) test::turn(t);
    for (int k = 1; k <= 200; ++k) {
      const auto y = static_cast<float>(17 + k % 7);
      const auto z = static_cast<float>(5 + k % 11);
      const auto away = static_cast<float>(3 + k);
      RawMesh mesh;
      mesh.positions = {{9, 5 * y, 5 * z}, {9, -away * y, -away * z}, {-9, -99, 99}, {-9, 99, -99}};
      mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
      if (volumeOf(mesh) < 0)
        for (Triangle& t : mesh.triangles) test::turn(t);
      test::append(mesh, hole);
      EXPECT_TRUE(repairMesh(mesh, "hollow").empty()) << k;
    }
  }
}

TEST(Repair, CavitiesStayThatTouchTheirBody) {
  RawMesh mesh = cube({0, 0, 0}, 4);
  RawMesh hole;
  hole.positions = {{0, 0, 0}, {2, 1, 1}, {1, 2, 1}, {1, 1, 2}};
  hole.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  ASSERT_LT(volumeOf(hole), 0);
  test::append(mesh, hole);
  EXPECT_EQ(countOf(repairMesh(mesh, "touched"), "inward orientation"), 0U);
}

TEST(Repair, OpenBodiesAreToldByTheVolumeTheyAlmostEnclose) {
  RawMesh open = ball(8, 12);
  open.triangles.resize(open.triangles.size() - 14);  // one segment is missing
  RawMesh inward = open;
  for (Triangle& t : inward.triangles) test::turn(t);
  EXPECT_EQ(countOf(repairMesh(open, "open"), "inward orientation"), 0U);
  EXPECT_EQ(countOf(repairMesh(inward, "open"), "inward orientation"), inward.triangles.size());
  EXPECT_EQ(inward.triangles.size(), open.triangles.size());
}

TEST(Repair, FlatSheetsKeepTheirSide) {
  for (const bool turned : {false, true}) {
    RawMesh sheet;
    sheet.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.1F}};
    sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
    if (turned) {
      for (Triangle& t : sheet.triangles) test::turn(t);
    }
    EXPECT_TRUE(repairMesh(sheet, "sheet").empty());
  }
}

TEST(Repair, FinIsCutFromItsSheet) {
  // Three triangles share the edge 0-1.
  RawMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0.5F, 1, 0}, {0.5F, -1, 0}, {0.5F, 0, 1}};
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  const Repairs repairs = repairMesh(mesh, "fin");
  EXPECT_EQ(repairs.size(), 1U);
  EXPECT_EQ(countOf(repairs, "non-manifold edges"), 1U);
  EXPECT_EQ(test::badEdges(mesh.triangles), 0U);
  EXPECT_EQ(mesh.triangles.size(), 3U);
}

TEST(Repair, CubesThatShareAnEdgeBecomeTwoClosedCubes) {
  RawMesh mesh = cube();
  test::append(mesh, cube({1, 1, 0}));
  // Vertices 3 and 7 at (1,1,0) and (1,1,1) are 8 and 12 of the second cube.
  for (Triangle& t : mesh.triangles) {
    for (std::uint32_t& v : t) v = v == 8 ? 3 : v == 12 ? 7 : v;
  }
  const Repairs repairs = repairMesh(mesh, "shared edge");
  EXPECT_EQ(countOf(repairs, "non-manifold edges"), 1U);
  EXPECT_EQ(mesh.positions.size(), 16U);
  EXPECT_EQ(test::badEdges(mesh.triangles), 0U);
  EXPECT_NEAR(volumeOf(mesh), 2, 1e-6);
  EXPECT_TRUE(factsOf(mesh.positions, mesh.triangles).closed);
}

TEST(Repair, MoebiusBandIsCutOnce) {
  RawMesh mesh;
  constexpr std::uint32_t steps = 20;
  for (std::uint32_t s = 0; s < steps; ++s) {
    const double phi = 2 * std::numbers::pi * s / steps;
    for (const double side : {-0.3, 0.0, 0.3}) {
      const double radius = 1 + side * std::cos(phi / 2);
      mesh.positions.push_back({static_cast<float>(radius * std::cos(phi)),
                                static_cast<float>(radius * std::sin(phi)),
                                static_cast<float>(side * std::sin(phi / 2))});
    }
  }
  for (std::uint32_t s = 0; s < steps; ++s) {
    for (std::uint32_t k = 0; k < 2; ++k) {
      const std::uint32_t a = 3 * s + k;
      const std::uint32_t b = a + 1;
      const bool last = s + 1 == steps;
      const std::uint32_t c = last ? 2 - k : a + 3;
      const std::uint32_t d = last ? 1 - k : b + 3;
      mesh.triangles.push_back({a, c, b});
      mesh.triangles.push_back({b, c, d});
    }
  }
  const std::size_t count = mesh.triangles.size();
  const Repairs repairs = repairMesh(mesh, "band");
  EXPECT_GE(countOf(repairs, "non-manifold edges"), 2U);
  EXPECT_EQ(test::badEdges(mesh.triangles), 0U);
  EXPECT_EQ(mesh.triangles.size(), count);
}

TEST(Repair, BookOfManyPagesComesApart) {
  RawMesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 1, 0}};
  for (std::uint32_t page = 0; page < 40; ++page) {
    const double angle = 2 * std::numbers::pi * page / 40;
    mesh.positions.push_back(
        {static_cast<float>(std::cos(angle)), 0.5F, static_cast<float>(std::sin(angle))});
    mesh.triangles.push_back({0, 1, page + 2});
  }
  const Repairs repairs = repairMesh(mesh, "book");
  EXPECT_EQ(countOf(repairs, "non-manifold edges"), 1U);
  EXPECT_EQ(test::badEdges(mesh.triangles), 0U);
  EXPECT_EQ(mesh.triangles.size(), 40U);
}

TEST(Repair, WhatHasNoSurfaceIsAnError) {
  RawMesh none = cube();
  none.triangles.clear();
  EXPECT_THAT(test::messageOf([&] { repairMesh(none, "a.ply"); }), testing::HasSubstr("a.ply"));
  RawMesh flat = cube();
  flat.triangles = {{0, 0, 1}, {2, 2, 2}};
  EXPECT_THAT(test::messageOf([&] { repairMesh(flat, "a.ply"); }),
              testing::HasSubstr("degenerate"));
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    RawMesh mesh = cube();
    mesh.positions[2][1] = bad;
    EXPECT_THAT(test::messageOf([&] { repairMesh(mesh, "a.ply"); }),
                testing::HasSubstr("vertex 2"));
  }
}

TEST(Normals, WeighsByAngle) {
  // At a cube's corner every side has a right angle, however it is cut into triangles.
  RawMesh mesh = cube();
  repairMesh(mesh, "cube");
  for (std::size_t v = 0; v < 8; ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float expected = (mesh.positions[v][axis] > 0 ? 1.0F : -1.0F) / std::sqrt(3.0F);
      EXPECT_NEAR(mesh.normals[v][axis], expected, 1e-6F);
    }
  }
}

TEST(Normals, GivenOnesAreNormalisedReplacedAndTurned) {
  RawMesh mesh = cube();
  const RawMesh straight = mesh;
  for (const Vec3& p : mesh.positions) {
    // Outwards from the middle with length 0.87, then inwards like the triangles.
    mesh.normals.push_back({0.5F - p[0], 0.5F - p[1], 0.5F - p[2]});
  }
  mesh.normals[1] = {0, 0, 0};
  mesh.normals[2] = {std::numeric_limits<float>::quiet_NaN(), 0, 1};
  for (Triangle& t : mesh.triangles) test::turn(t);
  const Repairs repairs = repairMesh(mesh, "inside out");
  EXPECT_EQ(countOf(repairs, "inward orientation"), 12U);
  EXPECT_EQ(countOf(repairs, "unusable normals"), 2U);
  for (std::size_t v = 0; v < 8; ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float expected = (straight.positions[v][axis] > 0 ? 1.0F : -1.0F) / std::sqrt(3.0F);
      EXPECT_NEAR(mesh.normals[v][axis], expected, 1e-5F);
    }
  }
}

}  // namespace
}  // namespace opaline::scene
