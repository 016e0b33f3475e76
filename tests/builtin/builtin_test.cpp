#include "builtin/builtin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "shared_files.h"

namespace opaline::builtin {
namespace {

using Double3 = std::array<double, 3>;

Double3 edge(const Vec3& a, const Vec3& b) {
  return {static_cast<double>(b[0]) - a[0], static_cast<double>(b[1]) - a[1],
          static_cast<double>(b[2]) - a[2]};
}

Double3 areaVector(const Mesh& mesh, const Triangle& t) {
  const Double3 a = edge(mesh.positionsMm[t[0]], mesh.positionsMm[t[1]]);
  const Double3 b = edge(mesh.positionsMm[t[0]], mesh.positionsMm[t[2]]);
  return {(a[1] * b[2] - a[2] * b[1]) / 2, (a[2] * b[0] - a[0] * b[2]) / 2,
          (a[0] * b[1] - a[1] * b[0]) / 2};
}

double dot(const Double3& a, const Vec3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double size(const Double3& a) {
  return std::hypot(a[0], a[1], a[2]);
}

/// How often each directed edge occurs.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> directedEdges(const Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
  }
  return edges;
}

double volume(const Mesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    sum += dot(areaVector(mesh, t), mesh.positionsMm[t[0]]) / 3;
  }
  return sum;
}

std::pair<Vec3, Vec3> box(const Mesh& mesh) {
  Vec3 low = mesh.positionsMm.front();
  Vec3 high = low;
  for (const Vec3& p : mesh.positionsMm) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  }
  return {low, high};
}

class Bear : public testing::Test {
 protected:
  const Mesh mesh = bearMesh();
};

TEST_F(Bear, HasAboutFiftyThousandTrianglesAndFiftyMillimetres) {
  EXPECT_GE(mesh.triangles.size(), 45000U);
  EXPECT_LE(mesh.triangles.size(), 55000U);
  const auto [low, high] = box(mesh);
  EXPECT_NEAR(size(edge(low, high)), 50, 1e-3);
  EXPECT_NEAR(low[1], 0, .1);
}

TEST_F(Bear, IsClosedManifoldAndOfGenusZero) {
  const auto edges = directedEdges(mesh);
  for (const auto& [e, count] : edges) {
    ASSERT_EQ(count, 1);
    ASSERT_TRUE(edges.contains({e.second, e.first}));
  }
  // χ = V − E + F = 2 for one closed surface without handles; E is half the directed edges. A
  // second component or a pinched vertex would change the sum.
  EXPECT_EQ(static_cast<int>(mesh.positionsMm.size()) - static_cast<int>(edges.size() / 2) +
                static_cast<int>(mesh.triangles.size()),
            2);
}

TEST_F(Bear, HasSoundTrianglesAndNormalsThatPointOutwards) {
  EXPECT_GT(volume(mesh), 0);
  ASSERT_EQ(mesh.normals.size(), mesh.positionsMm.size());
  double worst = 1;
  for (const Triangle& t : mesh.triangles) {
    const Double3 n = areaVector(mesh, t);
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      longest =
          std::max(longest, size(edge(mesh.positionsMm[t[i]], mesh.positionsMm[t[(i + 1) % 3]])));
      EXPECT_GT(dot(n, mesh.normals[t[i]]) / size(n), .6);
    }
    worst = std::min(worst, 2 * size(n) / (longest * longest));
  }
  EXPECT_GT(worst, .15);  // least ratio of height to longest edge
  for (const Vec3& n : mesh.normals) ASSERT_NEAR(std::hypot(n[0], n[1], n[2]), 1, 1e-5);
}

TEST_F(Bear, IsTheSameEveryTime) {
  const Mesh again = bearMesh();
  EXPECT_EQ(mesh.positionsMm, again.positionsMm);
  EXPECT_EQ(mesh.triangles, again.triangles);
}

TEST_F(Bear, FacesTheFront) {
  // Snout, paws and feet reach farther to +z than back and tail to -z of the body's middle, and the
  // bear is as wide to the left as to the right.
  const auto [low, high] = box(mesh);
  EXPECT_GT(high[2], -low[2]);
  EXPECT_NEAR(high[0], -low[0], .01 * high[0]);
  EXPECT_GT(high[1] - low[1], high[0] - low[0]);
}

/// Positions to a ten-thousandth of a unit, so that sets can be compared.
std::array<int, 3> rounded(const Vec3& p) {
  std::array<int, 3> key{};
  for (std::size_t i = 0; i < 3; ++i) key[i] = static_cast<int>(std::lround(1e4 * p[i]));
  return key;
}

TEST(Teapot, HasTheCountsOfThePaper) {
  const Mesh mesh = teapotMesh();
  EXPECT_EQ(mesh.positionsMm.size(), 1177U);
  EXPECT_EQ(mesh.triangles.size(), 2256U);
  const auto [low, high] = box(mesh);
  // The extent of Newell's patches, of which the spout's lip is not a control point.
  EXPECT_EQ(rounded(low), (std::array<int, 3>{-30000, 0, -20000}));
  EXPECT_NEAR(high[0], 3.43, .01);
  EXPECT_NEAR(high[1], 3.15, 1e-6);
  EXPECT_NEAR(high[2], 2, 1e-6);
}

TEST(Teapot, IsOrientedOutwardsWithSmoothNormals) {
  const Mesh mesh = teapotMesh();
  for (const auto& [e, count] : directedEdges(mesh)) ASSERT_EQ(count, 1);
  EXPECT_GT(volume(mesh), 0);
  std::size_t turned = 0;
  for (const Triangle& t : mesh.triangles) {
    const Double3 n = areaVector(mesh, t);
    for (const std::uint32_t v : t) turned += dot(n, mesh.normals[v]) > 0 ? 0U : 1U;
  }
  // Handle and body share one vertex whose two surfaces look in opposite directions.
  EXPECT_LE(turned, 6U);
}

TEST(Teapot, IsTheSharedModel) {
  const auto path = test::sharedModel("teapot.ply");
  if (!path) {
    GTEST_SKIP() << "teapot.ply is not here; OPALINE_MODELS names the folder that has it.";
  }
  std::ifstream file(*path, std::ios::binary);
  for (std::string line; std::getline(file, line) && line != "end_header";) {
  }
  std::vector<Vec3> positions(1177);
  file.read(reinterpret_cast<char*>(positions.data()), std::streamsize{12} * 1177);
  Mesh shared;
  shared.positionsMm = positions;
  shared.triangles.resize(2256);
  for (Triangle& t : shared.triangles) {
    file.get();
    file.read(reinterpret_cast<char*>(t.data()), 12);
  }
  ASSERT_TRUE(file.good());
  const Mesh mesh = teapotMesh();
  std::vector<std::array<int, 3>> ours;
  std::vector<std::array<int, 3>> theirs;
  std::transform(mesh.positionsMm.begin(), mesh.positionsMm.end(), std::back_inserter(ours),
                 rounded);
  std::transform(positions.begin(), positions.end(), std::back_inserter(theirs), rounded);
  std::sort(ours.begin(), ours.end());
  std::sort(theirs.begin(), theirs.end());
  std::size_t apart = 0;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) apart += std::abs(ours[i][k] - theirs[i][k]) > 1 ? 1U : 0U;
  }
  EXPECT_EQ(apart, 0U);
  // Orientation shows in the volume; each part adds its own.
  EXPECT_NEAR(volume(mesh), volume(shared), 1e-4 * volume(shared));
}

}  // namespace
}  // namespace opaline::builtin
