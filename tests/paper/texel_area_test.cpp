#include "paper/atlas/texel_area.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "awkward_meshes.h"

namespace opaline::atlas {
namespace {

using Point = std::array<double, 2>;

Point texelCorner(const Atlas& atlas, std::uint32_t corner, int mapSize) {
  const Vec2& uv = atlas.vertices[corner].uv;
  return {static_cast<double>(uv[0]) * mapSize, static_cast<double>(uv[1]) * mapSize};
}

struct Moments {
  double area = 0;
  Point first{};  // ∫ x dA, ∫ y dA
};

// By the closed form of a triangle, the atlas as a whole.
Moments momentsOfTriangles(const Atlas& atlas, int mapSize) {
  Moments sum;
  for (const Triangle& t : atlas.triangles) {
    const Point a = texelCorner(atlas, t[0], mapSize);
    const Point b = texelCorner(atlas, t[1], mapSize);
    const Point c = texelCorner(atlas, t[2], mapSize);
    const double area = std::abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
    sum.area += area;
    for (std::size_t i = 0; i < 2; ++i) sum.first[i] += area * (a[i] + b[i] + c[i]) / 3;
  }
  return sum;
}

Moments momentsOfTexels(const std::vector<TexelArea>& areas, int mapSize) {
  Moments sum;
  for (int y = 0; y < mapSize; ++y)
    for (int x = 0; x < mapSize; ++x) {
      const TexelArea& texel = areas[static_cast<std::size_t>(y * mapSize + x)];
      const auto area = static_cast<double>(texel.area);
      sum.area += area;
      sum.first[0] += static_cast<double>(texel.moment[0]) + area * (x + 0.5);
      sum.first[1] += static_cast<double>(texel.moment[1]) + area * (y + 0.5);
    }
  return sum;
}

// One triangle, its corners in texels.
Atlas triangleAtlas(const std::array<Point, 3>& corners, int mapSize) {
  Atlas atlas;
  for (std::uint32_t i = 0; i < 3; ++i)
    atlas.vertices.push_back({i,
                              {static_cast<float>(corners[i][0] / mapSize),
                               static_cast<float>(corners[i][1] / mapSize)}});
  atlas.triangles = {{0, 1, 2}};
  atlas.chartOfTriangle = {0};
  return atlas;
}

TEST(TexelArea, AddsUpToTheTriangles) {
  for (const awkward::Shape& shape : awkward::all()) {
    const Atlas atlas = makeAtlas({shape.positions, shape.triangles, shape.objects});
    for (const int mapSize : {64, 301}) {
      const std::vector<TexelArea> areas = texelAreas(atlas, mapSize);
      ASSERT_EQ(areas.size(), static_cast<std::size_t>(mapSize * mapSize));
      for (const TexelArea& texel : areas) {
        ASSERT_GE(texel.area, 0) << shape.name;
        ASSERT_LE(texel.area, 1 + 1e-4F) << shape.name;  // triangles do not overlap
        // No part of a texel lies further than half of one from its centre.
        ASSERT_LE(std::abs(texel.moment[0]), 0.5F * texel.area + 1e-6F) << shape.name;
        ASSERT_LE(std::abs(texel.moment[1]), 0.5F * texel.area + 1e-6F) << shape.name;
      }
      const Moments expected = momentsOfTriangles(atlas, mapSize);
      const Moments sum = momentsOfTexels(areas, mapSize);
      EXPECT_NEAR(sum.area, expected.area, 1e-5 * expected.area) << shape.name;
      for (std::size_t i = 0; i < 2; ++i)
        EXPECT_NEAR(sum.first[i], expected.first[i], 1e-5 * expected.first[i]) << shape.name;
    }
  }
}

// Area b h / 2; the centroid is the mean of the corners.
TEST(TexelArea, KnowsTheMomentsOfATriangleInOneTexel) {
  for (const bool mirrored : {false, true}) {
    std::array<Point, 3> corners{{{3.125, 2.125}, {3.875, 2.125}, {3.125, 2.875}}};
    if (mirrored) std::swap(corners[1], corners[2]);
    const std::vector<TexelArea> areas = texelAreas(triangleAtlas(corners, 8), 8);
    for (std::size_t i = 0; i < areas.size(); ++i) {
      const bool holdsIt = i == 2 * 8 + 3;
      EXPECT_FLOAT_EQ(areas[i].area, holdsIt ? 0.28125F : 0);
      for (const float moment : areas[i].moment)
        EXPECT_NEAR(moment, holdsIt ? -0.125 * 0.28125 : 0, 1e-7);
    }
  }
}

// The half of a texel on one side of its diagonal has its centroid a sixth from the centre.
TEST(TexelArea, CutsTexelsAlongADiagonal) {
  const std::vector<TexelArea> areas =
      texelAreas(triangleAtlas({{{0, 0}, {16, 0}, {0, 16}}}, 16), 16);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      const TexelArea& texel = areas[static_cast<std::size_t>(16 * y + x)];
      const double area = x + y < 15 ? 1 : x + y == 15 ? 0.5 : 0;
      EXPECT_NEAR(texel.area, area, 1e-6) << x << ' ' << y;
      for (const float moment : texel.moment)
        EXPECT_NEAR(moment, x + y == 15 ? -0.5 / 6 : 0, 1e-6) << x << ' ' << y;
    }
}

TEST(TexelArea, IsWholeInsideWhereverTheEdgesOfTrianglesRun) {
  awkward::Shape sheet{"sheet", {}, {}, {}};
  awkward::addGrid(sheet, 7, 11, [](double u, double v) { return awkward::vec(u, v, 0); });
  Atlas atlas;
  const double angle = 0.4;
  for (std::uint32_t i = 0; i < sheet.positions.size(); ++i) {
    const double x = static_cast<double>(sheet.positions[i][0]) - 0.5;
    const double y = static_cast<double>(sheet.positions[i][1]) - 0.5;
    atlas.vertices.push_back(
        {i,
         {static_cast<float>(0.5 + 0.6 * (std::cos(angle) * x - std::sin(angle) * y)),
          static_cast<float>(0.5 + 0.6 * (std::sin(angle) * x + std::cos(angle) * y))}});
  }
  atlas.triangles = sheet.triangles;
  atlas.chartOfTriangle.assign(sheet.triangles.size(), 0);

  constexpr int mapSize = 100;
  const std::vector<TexelArea> areas = texelAreas(atlas, mapSize);
  int whole = 0;
  for (int j = 0; j < mapSize; ++j)
    for (int i = 0; i < mapSize; ++i) {
      const double x = i + 0.5 - 50;
      const double y = j + 0.5 - 50;
      const double depth = 30 - std::max(std::abs(std::cos(angle) * x + std::sin(angle) * y),
                                         std::abs(-std::sin(angle) * x + std::cos(angle) * y));
      const TexelArea& texel = areas[static_cast<std::size_t>(mapSize * j + i)];
      if (depth > 0.75) {  // more than half of a texel's diagonal
        ++whole;
        ASSERT_NEAR(texel.area, 1, 1e-4) << i << ' ' << j;
        ASSERT_NEAR(texel.moment[0], 0, 1e-4) << i << ' ' << j;
        ASSERT_NEAR(texel.moment[1], 0, 1e-4) << i << ' ' << j;
      } else if (depth < -0.75) {
        ASSERT_EQ(texel.area, 0) << i << ' ' << j;
      }
    }
  EXPECT_GT(whole, 3000);
}

TEST(TexelArea, TakesNothingFromWhatHasNoArea) {
  for (const std::array<Point, 3>& corners : {std::array<Point, 3>{{{2, 3}, {2, 3}, {2, 3}}},
                                              {{{0, 0}, {8, 8}, {4, 4}}},
                                              {{{8, 8}, {8, 0}, {8, 4}}}})
    for (const TexelArea& texel : texelAreas(triangleAtlas(corners, 8), 8))
      EXPECT_NEAR(texel.area, 0, 1e-6);
  for (const TexelArea& texel : texelAreas(Atlas{}, 4)) EXPECT_EQ(texel.area, 0);
}

}  // namespace
}  // namespace opaline::atlas
