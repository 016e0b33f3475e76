#include "paper/atlas/measure.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "paper/atlas/initial_map.h"
#include "paper/atlas/texel_row.h"

namespace opaline::atlas {
namespace {

Point2 placeOf(const Atlas& atlas, std::uint32_t vertex) {
  const Vec2& uv = atlas.vertices[vertex].uv;
  return {uv[0], uv[1]};
}

double coverage(const Atlas& atlas, int mapSize) {
  const auto edge = static_cast<std::size_t>(mapSize);
  std::vector<bool> covered(edge * edge, false);
  for (const Triangle& t : atlas.triangles) {
    std::array<Point2, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = placeOf(atlas, t[i]);
      for (double& x : p[i]) x *= mapSize;
    }
    const auto [low, high] = std::minmax({p[0][1], p[1][1], p[2][1]});
    const int first = std::max(0, static_cast<int>(std::ceil(low - .5)));
    const int last = std::min(mapSize - 1, static_cast<int>(std::floor(high - .5)));
    for (int y = first; y <= last; ++y) {
      const auto [from, to] = texelsInRow(p, y, 0, mapSize);
      for (int x = from; x < to; ++x) {
        covered[static_cast<std::size_t>(y) * edge + static_cast<std::size_t>(x)] = true;
      }
    }
  }
  const auto count = std::count(covered.begin(), covered.end(), true);
  return static_cast<double>(count) / static_cast<double>(covered.size());
}

}  // namespace

void measure(const Topology& topology, int mapSize, Atlas& atlas) {
  std::vector<double> flat;
  double flatTotal = 0;
  double total = 0;
  for (std::size_t t = 0; t < atlas.triangles.size(); ++t) {
    const Triangle& v = atlas.triangles[t];
    flat.push_back(signedArea(placeOf(atlas, v[0]), placeOf(atlas, v[1]), placeOf(atlas, v[2])));
    flatTotal += flat.back();
    total += topology.areas[t];
  }
  atlas.statistics.coverage = coverage(atlas, mapSize);
  if (!(total > 0) || !(flatTotal > 0)) return;
  atlas.mmPerUnit = std::sqrt(total / flatTotal);
  double squares = 0;
  for (std::size_t t = 0; t < flat.size(); ++t) {
    if (!(topology.areas[t] > 0) || !(flat[t] > 0)) continue;
    const double logarithm = std::log(flat[t] / topology.areas[t] * (total / flatTotal));
    squares += topology.areas[t] / total * logarithm * logarithm;
  }
  atlas.statistics.areaDistortionRms = std::sqrt(squares);
}

}  // namespace opaline::atlas
