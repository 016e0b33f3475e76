#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "input.h"
#include "paper/atlas/charts.h"
#include "paper/atlas/flat_charts.h"
#include "paper/atlas/initial_map.h"

// The charts of any mesh before they are packed, which takes most of an atlas's time.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace opaline;
  fuzz::Input input(data, size);
  const awkward::Shape shape = fuzz::meshFrom(input);
  const atlas::Topology topology =
      atlas::makeTopology({shape.positions, shape.triangles, shape.objects});
  std::vector<int> charts(shape.triangles.size(), 0);
  for (const atlas::SurfaceChart& chart :
       atlas::flattenCharts(topology, atlas::segment(topology))) {
    for (const std::uint32_t triangle : chart.triangles) ++charts.at(triangle);
    for (const atlas::Point2& p : chart.flat.places)
      EXPECT_TRUE(std::isfinite(p[0]) && std::isfinite(p[1]));
    for (const auto& [a, b, c] : chart.mesh.triangles)
      EXPECT_GT(atlas::signedArea(chart.flat.places.at(a), chart.flat.places.at(b),
                                  chart.flat.places.at(c)),
                0);
  }
  for (std::size_t t = 0; t < charts.size(); ++t)
    EXPECT_EQ(charts[t], topology.degenerate[t] ? 0 : 1) << t;
  return 0;
}
