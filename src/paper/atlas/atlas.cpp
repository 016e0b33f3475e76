#include "paper/atlas/atlas.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <cstddef>

#include "paper/atlas/charts.h"
#include "paper/atlas/flat_charts.h"
#include "paper/atlas/measure.h"
#include "paper/atlas/pack.h"
#include "paper/atlas/topology.h"

namespace opaline::atlas {
namespace {

Vec2 toUv(const Layout& layout, const Placement& placement, const Point2& p) {
  const double u =
      layout.scale * (placement.cosine * p[0] - placement.sine * p[1]) + placement.offset[0];
  const double v =
      layout.scale * (placement.sine * p[0] + placement.cosine * p[1]) + placement.offset[1];
  return {static_cast<float>(std::clamp(u, 0.0, 1.0)), static_cast<float>(std::clamp(v, 0.0, 1.0))};
}

Layout layOut(const std::vector<SurfaceChart>& charts, const AtlasOptions& options) {
  std::vector<Outline> outlines;
  for (const SurfaceChart& chart : charts) {
    double area = 0;
    for (const Triangle& t : chart.mesh.triangles) {
      const auto& p = chart.mesh.positions;
      area += length(cross(subtract(p[t[1]], p[t[0]]), subtract(p[t[2]], p[t[0]]))) / 2;
    }
    outlines.push_back({chart.flat.places, chart.mesh.borders, area});
  }
  return pack(outlines, options.mapSize, options.gutter);
}

/// Atlas vertices of the flat charts. A flat vertex that stands for several vertices of the surface
/// (of one position) becomes several.
void addChart(const core::RestSurface& surface, const SurfaceChart& chart, const Layout& layout,
              std::uint32_t index, Atlas& atlas) {
  std::vector<std::vector<std::uint32_t>> copies(chart.mesh.positions.size());
  for (std::size_t i = 0; i < chart.triangles.size(); ++i) {
    const std::uint32_t t = chart.triangles[i];
    atlas.chartOfTriangle[t] = index;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t vertex = surface.triangles[t][corner];
      const std::uint32_t place = chart.mesh.triangles[i][corner];
      const auto found =
          std::find_if(copies[place].begin(), copies[place].end(),
                       [&](std::uint32_t copy) { return atlas.vertices[copy].vertex == vertex; });
      if (found != copies[place].end()) {
        atlas.triangles[t][corner] = *found;
        continue;
      }
      const auto added = static_cast<std::uint32_t>(atlas.vertices.size());
      atlas.vertices.push_back(
          {vertex, toUv(layout, layout.placements[index], chart.flat.places[place])});
      copies[place].push_back(added);
      atlas.triangles[t][corner] = added;
    }
  }
}

/// A degenerate triangle shrinks to a point where one of its vertices already is, so that what is
/// looked up there belongs to the surface beside it.
void addDegenerate(const core::RestSurface& surface, const Topology& topology, Atlas& atlas) {
  std::vector<std::uint32_t> known(topology.positions.size(), none);
  std::vector<std::uint32_t> chart(topology.positions.size(), 0);
  for (std::size_t t = 0; t < topology.triangles.size(); ++t) {
    if (topology.degenerate[t]) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      known[topology.triangles[t][i]] = atlas.triangles[t][i];
      chart[topology.triangles[t][i]] = atlas.chartOfTriangle[t];
    }
  }
  for (std::size_t t = 0; t < topology.triangles.size(); ++t) {
    if (!topology.degenerate[t]) continue;
    Vec2 uv = {.5F, .5F};
    for (const std::uint32_t v : topology.triangles[t]) {
      if (known[v] == none) continue;
      uv = atlas.vertices[known[v]].uv;
      atlas.chartOfTriangle[t] = chart[v];
      break;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      atlas.triangles[t][i] = static_cast<std::uint32_t>(atlas.vertices.size());
      atlas.vertices.push_back({surface.triangles[t][i], uv});
    }
  }
}

}  // namespace

Atlas makeAtlas(const core::RestSurface& surface, const AtlasOptions& options) {
  assert(options.mapSize >= 64 && options.mapSize <= 4096);
  assert(options.gutter >= 1 && options.gutter <= 16);
  assert(surface.objectOfTriangle.empty() ||
         surface.objectOfTriangle.size() == surface.triangles.size());
  const auto start = std::chrono::steady_clock::now();
  const Topology topology = makeTopology(surface);
  const std::vector<SurfaceChart> charts = flattenCharts(topology, segment(topology));
  const Layout layout = layOut(charts, options);
  Atlas atlas;
  atlas.triangles.resize(surface.triangles.size());
  atlas.chartOfTriangle.resize(surface.triangles.size(), 0);
  for (std::size_t i = 0; i < charts.size(); ++i) {
    addChart(surface, charts[i], layout, static_cast<std::uint32_t>(i), atlas);
  }
  addDegenerate(surface, topology, atlas);
  measure(topology, options.mapSize, atlas);
  atlas.statistics.charts = charts.size();
  atlas.statistics.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return atlas;
}

}  // namespace opaline::atlas
