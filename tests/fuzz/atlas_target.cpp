#include "paper/atlas/atlas.h"

#include <gtest/gtest.h>

#include <vector>

#include "input.h"
#include "paper/atlas/geodesic.h"
#include "paper/atlas/neighbourhood.h"
#include "paper/atlas/texel_area.h"

// Any mesh, as it comes.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace opaline;
  fuzz::Input input(data, size);
  const int mapSize = 64 << input.below(2);
  const int gutter = 1 + static_cast<int>(input.below(16));
  const auto walkMm = static_cast<double>(input.magnitude());
  constexpr std::size_t quicklyPacked = 12;
  const awkward::Shape shape = fuzz::meshFrom(input, quicklyPacked);
  const core::RestSurface surface{shape.positions, shape.triangles, shape.objects};
  const atlas::Atlas made = atlas::makeAtlas(surface, {mapSize, gutter});
  EXPECT_EQ(made.triangles.size(), shape.triangles.size());
  for (const AtlasVertex& vertex : made.vertices) {
    EXPECT_LT(vertex.vertex, shape.positions.size());
    for (const float x : vertex.uv) EXPECT_TRUE(x >= 0 && x <= 1) << x;
  }
  for (const Triangle& triangle : made.triangles)
    for (const std::uint32_t corner : triangle) EXPECT_LT(corner, made.vertices.size());
  const auto neighbourhoods =
      atlas::makeNeighbourhoods(surface, made, {.mapSize = mapSize, .reach = 8, .maxSize = 512});
  EXPECT_LE(neighbourhoods.size, 512);
  for (const atlas::TexelArea& texel : atlas::texelAreas(made, mapSize))
    EXPECT_TRUE(texel.area >= 0 && texel.area <= 1.001F) << texel.area;
  drawAtlas(made, mapSize);
  atlas::walkFromVertices(surface, std::vector<double>(shape.positions.size(), walkMm));
  return 0;
}
