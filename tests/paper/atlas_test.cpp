#include "paper/atlas/atlas.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "awkward_meshes.h"
#include "builtin/builtin.h"
#include "shared_files.h"

namespace opaline::atlas {
namespace {

constexpr int fineMap = 2048;  // on which two triangles must not share a texel

std::array<double, 2> uvOf(const Atlas& atlas, std::size_t t, std::size_t corner, double scale) {
  const Vec2& uv = atlas.vertices[atlas.triangles[t][corner]].uv;
  return {scale * uv[0], scale * uv[1]};
}

double flatArea(const Atlas& atlas, std::size_t t) {
  const auto a = uvOf(atlas, t, 0, 1);
  const auto b = uvOf(atlas, t, 1, 1);
  const auto c = uvOf(atlas, t, 2, 1);
  return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
}

/// Doubled area and longest edge.
std::pair<double, double> sizeInSpace(const core::RestSurface& surface, std::size_t t) {
  std::array<std::array<double, 3>, 3> edges{};
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& p = surface.positionsMm[surface.triangles[t][i]];
    const Vec3& q = surface.positionsMm[surface.triangles[t][(i + 1) % 3]];
    for (std::size_t k = 0; k < 3; ++k) edges[i][k] = static_cast<double>(q[k]) - p[k];
    longest = std::max(longest, std::hypot(edges[i][0], edges[i][1], edges[i][2]));
  }
  const auto& [a, b, c] = edges;
  return {
      std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]),
      longest};
}

constexpr std::uint32_t nobody = 0xffffffffU;

/// The chart of each texel whose centre lies strictly inside a triangle; counts texels in two
/// triangles.
struct Raster {
  int size;
  std::vector<std::uint32_t> chart;
  std::size_t doubles = 0;

  Raster(const Atlas& atlas, int mapSize)
      : size(mapSize),
        chart(static_cast<std::size_t>(mapSize) * static_cast<std::size_t>(mapSize), nobody) {
    for (std::size_t t = 0; t < atlas.triangles.size(); ++t) add(atlas, t);
  }

  std::uint32_t at(int x, int y) const {
    return chart[static_cast<std::size_t>(y) * static_cast<std::size_t>(size) +
                 static_cast<std::size_t>(x)];
  }

 private:
  void add(const Atlas& atlas, std::size_t t) {
    std::array<std::array<double, 2>, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = uvOf(atlas, t, i, size);
    const auto [lowX, highX] = std::minmax({p[0][0], p[1][0], p[2][0]});
    const auto [lowY, highY] = std::minmax({p[0][1], p[1][1], p[2][1]});
    for (int y = static_cast<int>(lowY); y <= std::min(size - 1, static_cast<int>(highY)); ++y) {
      for (int x = static_cast<int>(lowX); x <= std::min(size - 1, static_cast<int>(highX)); ++x) {
        bool inside = true;
        for (std::size_t i = 0; i < 3; ++i) {
          const auto& a = p[i];
          const auto& b = p[(i + 1) % 3];
          inside =
              inside && (b[0] - a[0]) * (y + .5 - a[1]) - (b[1] - a[1]) * (x + .5 - a[0]) > 1e-9;
        }
        if (!inside) continue;
        auto& texel = chart[static_cast<std::size_t>(y) * static_cast<std::size_t>(size) +
                            static_cast<std::size_t>(x)];
        if (texel != nobody) ++doubles;
        texel = atlas.chartOfTriangle[t];
      }
    }
  }
};

void expectTrianglesKept(const core::RestSurface& surface, const Atlas& atlas) {
  ASSERT_EQ(atlas.triangles.size(), surface.triangles.size());
  ASSERT_EQ(atlas.chartOfTriangle.size(), surface.triangles.size());
  for (std::size_t t = 0; t < atlas.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      ASSERT_LT(atlas.triangles[t][i], atlas.vertices.size());
      ASSERT_EQ(atlas.vertices[atlas.triangles[t][i]].vertex, surface.triangles[t][i]);
    }
    ASSERT_LT(atlas.chartOfTriangle[t], std::max<std::size_t>(atlas.statistics.charts, 1));
  }
  for (const AtlasVertex& v : atlas.vertices) {
    for (const float x : v.uv) ASSERT_TRUE(x >= 0 && x <= 1) << x;
  }
}

void expectNothingMirrored(const core::RestSurface& surface, const Atlas& atlas) {
  for (std::size_t t = 0; t < atlas.triangles.size(); ++t) {
    const double flat = flatArea(atlas, t);
    const auto [doubled, longest] = sizeInSpace(surface, t);
    // A triangle whose height in the atlas is some float steps can tell its sides; a thinner one
    // may round to a line but not turn over by more than a step.
    const double step = 6e-8 * longest / atlas.mmPerUnit;
    if (doubled > 2e-5 * longest * longest &&
        doubled / 2 / atlas.mmPerUnit / atlas.mmPerUnit > 4 * step) {
      ASSERT_GT(flat, 0) << "triangle " << t;
    } else if (atlas.mmPerUnit > 0) {
      ASSERT_GE(flat, -2 * step) << "triangle " << t;
    }
  }
}

void expectGutters(const Atlas& atlas, const AtlasOptions& options) {
  const Raster raster(atlas, options.mapSize);
  const int reach = options.gutter;
  for (int y = 0; y < raster.size; ++y) {
    for (int x = 0; x < raster.size; ++x) {
      if (raster.at(x, y) == nobody) continue;
      for (int ny = y; ny <= std::min(raster.size - 1, y + reach); ++ny) {
        for (int nx = std::max(0, x - reach); nx <= std::min(raster.size - 1, x + reach); ++nx) {
          const std::uint32_t other = raster.at(nx, ny);
          ASSERT_TRUE(other == nobody || other == raster.at(x, y))
              << "charts " << other << " and " << raster.at(x, y) << " at " << x << ", " << y;
        }
      }
    }
  }
}

/// Inside a chart, triangles on both sides of an edge share its atlas vertices, unless more than
/// two triangles of the surface meet there or the chart was laid out with that edge as a border.
void expectSeamsOnlyAtBorders(const core::RestSurface& surface, const Atlas& atlas) {
  struct Use {
    std::size_t triangle, corner;
  };
  using Key = std::pair<Vec3, Vec3>;
  std::map<Key, std::vector<Use>> uses;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& a = surface.positionsMm[surface.triangles[t][i]];
      const Vec3& b = surface.positionsMm[surface.triangles[t][(i + 1) % 3]];
      uses[std::minmax(a, b)].push_back({t, i});
    }
  }
  for (const auto& [key, pair] : uses) {
    if (pair.size() != 2) continue;
    const auto [a, b] = std::tie(pair[0], pair[1]);
    const auto from = [&](const Use& use, std::size_t end) {
      return uvOf(atlas, use.triangle, (use.corner + end) % 3, 1);
    };
    const bool opposed = surface.positionsMm[surface.triangles[a.triangle][a.corner]] ==
                         surface.positionsMm[surface.triangles[b.triangle][(b.corner + 1) % 3]];
    if (!opposed || key.first == key.second) continue;
    if (sizeInSpace(surface, a.triangle).first < 1e-4 ||
        sizeInSpace(surface, b.triangle).first < 1e-4)
      continue;
    const bool together = from(a, 0) == from(b, 1) && from(a, 1) == from(b, 0);
    EXPECT_EQ(together, atlas.chartOfTriangle[a.triangle] == atlas.chartOfTriangle[b.triangle])
        << "triangles " << a.triangle << " and " << b.triangle;
  }
}

class AwkwardMesh : public testing::TestWithParam<awkward::Shape> {};

TEST_P(AwkwardMesh, GetsAValidAtlas) {
  const awkward::Shape& shape = GetParam();
  const core::RestSurface surface = {shape.positions, shape.triangles, shape.objects};
  const AtlasOptions options;
  const Atlas atlas = makeAtlas(surface, options);
  expectTrianglesKept(surface, atlas);
  expectNothingMirrored(surface, atlas);
  EXPECT_EQ(Raster(atlas, fineMap).doubles, 0U);
  expectGutters(atlas, options);
  expectSeamsOnlyAtBorders(surface, atlas);
  EXPECT_LE(atlas.statistics.areaDistortionRms, .06);
}

INSTANTIATE_TEST_SUITE_P(Atlas, AwkwardMesh, testing::ValuesIn(awkward::all()),
                         [](const auto& shape) { return shape.param.name; });

TEST(Atlas, IsTheSameEveryTime) {
  for (const awkward::Shape& shape :
       {awkward::sphere(), awkward::degenerates(), awkward::moebiusStrip()}) {
    const Atlas a = makeAtlas({shape.positions, shape.triangles, shape.objects});
    const Atlas b = makeAtlas({shape.positions, shape.triangles, shape.objects});
    ASSERT_EQ(a.vertices.size(), b.vertices.size());
    for (std::size_t i = 0; i < a.vertices.size(); ++i) {
      ASSERT_EQ(a.vertices[i].uv, b.vertices[i].uv);
    }
    EXPECT_EQ(a.triangles, b.triangles);
    EXPECT_EQ(a.chartOfTriangle, b.chartOfTriangle);
  }
}

class TinyMeshes : public testing::TestWithParam<awkward::Shape (*)(unsigned)> {};

TEST_P(TinyMeshes, GetAnAtlas) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    const awkward::Shape shape = GetParam()(seed);
    SCOPED_TRACE(shape.name);
    const core::RestSurface surface = {shape.positions, shape.triangles, {}};
    const Atlas atlas = makeAtlas(surface, {.mapSize = 64});
    expectTrianglesKept(surface, atlas);
    expectNothingMirrored(surface, atlas);
  }
}

INSTANTIATE_TEST_SUITE_P(Atlas, TinyMeshes, testing::Values(awkward::dust, awkward::crumbs),
                         [](const auto& family) { return family.index == 0 ? "Dust" : "Crumbs"; });

TEST(Atlas, LongBordersAreDrawnAndPacked) {
  for (const awkward::Shape& shape : {awkward::needleFan(4000), awkward::star(8000)}) {
    SCOPED_TRACE(shape.name);
    const core::RestSurface surface = {shape.positions, shape.triangles, {}};
    const Atlas atlas = makeAtlas(surface);
    expectTrianglesKept(surface, atlas);
    expectNothingMirrored(surface, atlas);
    EXPECT_EQ(drawAtlas(atlas, 1024).width, 1024);
  }
}

TEST(Atlas, KeepsObjectsApart) {
  const awkward::Shape shape = awkward::twoObjects();
  const Atlas atlas = makeAtlas({shape.positions, shape.triangles, shape.objects});
  std::map<std::uint32_t, std::uint32_t> objectOfChart;
  for (std::size_t t = 0; t < shape.triangles.size(); ++t) {
    const auto place = objectOfChart.emplace(atlas.chartOfTriangle[t], shape.objects[t]).first;
    ASSERT_EQ(place->second, shape.objects[t]);
  }
}

TEST(Atlas, WeldsVerticesThatShareAPosition) {
  // A sheet that is torn into separate triangles is one chart.
  const awkward::Shape sheet = awkward::flatSheet();
  awkward::Shape torn{"torn", {}, {}, {}};
  for (const Triangle& t : sheet.triangles) {
    const auto first = static_cast<std::uint32_t>(torn.positions.size());
    for (const std::uint32_t v : t) torn.positions.push_back(sheet.positions[v]);
    torn.triangles.push_back({first, first + 1, first + 2});
  }
  const Atlas whole = makeAtlas({sheet.positions, sheet.triangles, {}});
  const Atlas atlas = makeAtlas({torn.positions, torn.triangles, {}});
  EXPECT_EQ(atlas.statistics.charts, whole.statistics.charts);
  EXPECT_EQ(atlas.vertices.size(), torn.positions.size());
}

TEST(Atlas, FlatSheetIsOneChartWithoutDistortion) {
  const awkward::Shape sheet = awkward::flatSheet();
  const Atlas atlas = makeAtlas({sheet.positions, sheet.triangles, {}});
  EXPECT_EQ(atlas.statistics.charts, 1U);
  EXPECT_LT(atlas.statistics.areaDistortionRms, 1e-4);
  // A 3 by 2 rectangle in a square: at most two thirds of it, the edge then 3 mm.
  EXPECT_NEAR(atlas.mmPerUnit, 3, .05);
  EXPECT_NEAR(atlas.statistics.coverage, 2. / 3, .02);
}

TEST(Atlas, GutterWidensWithTheOption) {
  const awkward::Shape shape = awkward::torus();
  const AtlasOptions options = {.mapSize = 300, .gutter = 7};
  expectGutters(makeAtlas({shape.positions, shape.triangles, {}}, options), options);
  const AtlasOptions large = {.mapSize = 1600, .gutter = 5};
  expectGutters(makeAtlas({shape.positions, shape.triangles, {}}, large), large);
}

TEST(Atlas, PictureShowsEveryChart) {
  const awkward::Shape shape = awkward::torus();
  const Atlas atlas = makeAtlas({shape.positions, shape.triangles, {}});
  const Image image = drawAtlas(atlas, 256);
  ASSERT_EQ(image.width, 256);
  std::size_t bright = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    bright += image.rgba[i] + image.rgba[i + 1] + image.rgba[i + 2] > .3F ? 1U : 0U;
  }
  // Outlines are a pixel wide, so the picture shows a little more than the coverage.
  const double part = static_cast<double>(bright) / (256. * 256.);
  EXPECT_GT(part, atlas.statistics.coverage - .02);
  EXPECT_LT(part, atlas.statistics.coverage + .15);
}

void expectFigures(const std::string& name, const Mesh& mesh) {
  const core::RestSurface surface = {mesh.positionsMm, mesh.triangles, {}};
  const AtlasOptions options;
  const Atlas atlas = makeAtlas(surface, options);
  expectTrianglesKept(surface, atlas);
  expectNothingMirrored(surface, atlas);
  expectGutters(atlas, options);
  EXPECT_EQ(Raster(atlas, fineMap).doubles, 0U) << name;
  EXPECT_LE(atlas.statistics.areaDistortionRms, .05) << name;
  EXPECT_GE(atlas.statistics.coverage, .65) << name;
  EXPECT_LE(atlas.statistics.charts, 120U) << name;

  double squares = 0;
  double total = 0;
  double flatTotal = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    total += sizeInSpace(surface, t).first / 2;
    flatTotal += flatArea(atlas, t);
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double area = sizeInSpace(surface, t).first / 2;
    const double flat = flatArea(atlas, t);
    if (!(area > 0) || !(flat > 0)) continue;
    const double l = std::log(flat / area * total / flatTotal);
    squares += area / total * l * l;
  }
  EXPECT_NEAR(atlas.statistics.areaDistortionRms, std::sqrt(squares), 1e-4) << name;
  EXPECT_NEAR(atlas.mmPerUnit, std::sqrt(total / flatTotal), 1e-6 * atlas.mmPerUnit) << name;
}

TEST(AtlasFigures, Bear) {
  expectFigures("bear", builtin::bearMesh());
}

/// Reads plain binary files, such as the models.
Mesh readPly(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::size_t vertices = 0;
  std::size_t faces = 0;
  for (std::string line; std::getline(file, line) && line != "end_header";) {
    if (line.starts_with("element vertex ")) vertices = std::stoul(line.substr(15));
    if (line.starts_with("element face ")) faces = std::stoul(line.substr(13));
  }
  Mesh mesh;
  mesh.positionsMm.resize(vertices);
  file.read(reinterpret_cast<char*>(mesh.positionsMm.data()),
            static_cast<std::streamsize>(12 * vertices));
  mesh.triangles.resize(faces);
  for (Triangle& t : mesh.triangles) {
    file.get();
    file.read(reinterpret_cast<char*>(t.data()), 12);
  }
  EXPECT_TRUE(file.good()) << path;
  return mesh;
}

class AtlasFiguresOf : public testing::TestWithParam<const char*> {};

TEST_P(AtlasFiguresOf, Model) {
  const auto path = test::sharedModel(std::string(GetParam()) + ".ply");
  if (!path) {
    GTEST_SKIP() << GetParam() << ".ply is not here; OPALINE_MODELS names the folder that has it.";
  }
  expectFigures(GetParam(), readPly(*path));
}

INSTANTIATE_TEST_SUITE_P(Table1, AtlasFiguresOf,
                         testing::Values("teapot", "buddha", "max_planck", "bunny", "bunny_egg_a"),
                         [](const auto& model) { return std::string(model.param); });

}  // namespace
}  // namespace opaline::atlas
