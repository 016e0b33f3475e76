#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "opaline/atlas.h"
#include "opaline/error.h"
#include "opaline/mesh.h"

namespace opaline {
namespace {

double doubledArea(const Vec2& a, const Vec2& b, const Vec2& c) {
  return double{b[0] - a[0]} * double{c[1] - a[1]} - double{b[1] - a[1]} * double{c[0] - a[0]};
}

// A square of 4 mm² and one of 36 mm², two triangles each.
Scene squares() {
  Scene scene;
  for (const float edgeMm : {2.F, 6.F}) {
    Object& object = scene.objects.emplace_back();
    object.mesh = makeMesh({{0, 0, 0}, {edgeMm, 0, 0}, {edgeMm, edgeMm, 0}, {0, edgeMm, 0}},
                           {{0, 1, 2}, {0, 2, 3}});
  }
  return scene;
}

TEST(SceneAtlas, EveryTriangleHasItsTrueAreaAndEveryObjectItsCharts) {
  const Atlas atlas = makeAtlas(squares(), {.mapSize = 256});
  ASSERT_EQ(atlas.triangles.size(), 4U);
  ASSERT_EQ(atlas.chartOfTriangle.size(), 4U);
  EXPECT_EQ(atlas.statistics.charts, 2U);
  EXPECT_EQ(atlas.chartOfTriangle[0], atlas.chartOfTriangle[1]);
  EXPECT_NE(atlas.chartOfTriangle[1], atlas.chartOfTriangle[2]);
  const double areaMm2[] = {2, 2, 18, 18};
  for (std::size_t t = 0; t < 4; ++t) {
    const auto& [a, b, c] = atlas.triangles[t];
    const double flat =
        doubledArea(atlas.vertices[a].uv, atlas.vertices[b].uv, atlas.vertices[c].uv) / 2;
    EXPECT_NEAR(std::abs(flat) * atlas.mmPerUnit * atlas.mmPerUnit, areaMm2[t], 1e-3);
    for (const std::uint32_t corner : {a, b, c})
      EXPECT_EQ(atlas.vertices[corner].vertex / 4, t / 2) << "vertices count through the objects";
  }
}

TEST(SceneAtlas, ItsPictureHasTheCharts) {
  constexpr int size = 128;
  const Atlas atlas = makeAtlas(squares(), {.mapSize = 256});
  const Image image = drawAtlas(atlas, size);
  ASSERT_EQ(image.width, size);
  ASSERT_EQ(image.height, size);
  const auto colorAt = [&](const Vec2& uv) {
    const float* pixel =
        image.pixel(static_cast<int>(uv[0] * size), static_cast<int>(uv[1] * size));
    return Rgb{pixel[0], pixel[1], pixel[2]};
  };
  std::set<Rgb> colors;
  for (const Triangle& triangle : atlas.triangles) {
    Vec2 middle{};
    for (const std::uint32_t corner : triangle)
      for (std::size_t i = 0; i < 2; ++i) middle[i] += atlas.vertices[corner].uv[i] / 3;
    colors.insert(colorAt(middle));
  }
  EXPECT_EQ(colors.size(), 4U) << "triangles are shaded apart";
  std::map<Rgb, int> pixels;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    ++pixels[{image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]}];
  int ground = 0;  // more pixels than any triangle has
  for (const auto& [color, count] : pixels) ground = std::max(ground, count);
  EXPECT_NEAR(static_cast<double>(ground) / (size * size), 1 - atlas.statistics.coverage, 0.06)
      << "but for the outlines";
}

TEST(SceneAtlas, RefusesWhatMakesNoSense) {
  EXPECT_THROW(makeAtlas(squares(), {.mapSize = 32}), UsageError);
  EXPECT_THROW(makeAtlas(squares(), {.gutter = 0}), UsageError);
  Scene scene = squares();
  scene.objects[0].mesh.positionsMm[2][1] = NAN;
  EXPECT_THROW(makeAtlas(scene), UsageError);
  scene = squares();
  scene.objects[1].mesh.triangles[0][2] = 4;
  EXPECT_THROW(makeAtlas(scene), UsageError);
  const Atlas atlas = makeAtlas(squares(), {.mapSize = 64});
  EXPECT_THROW(drawAtlas(atlas, 8), UsageError);
  EXPECT_THROW(drawAtlas(atlas, 20000), UsageError);
}

}  // namespace
}  // namespace opaline
