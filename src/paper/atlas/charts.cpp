// Charts as the cells of seeds that grow over the surface and are then centred, again and again
// (Lloyd 1982; Cohen-Steiner, Alliez, Desbrun 2004, "Variational shape approximation"), with a
// metric between distance and deviation from the chart's mean normal.

#include "paper/atlas/charts.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>

namespace opaline::atlas {
namespace {

constexpr int growthRounds = 14;   // in which seeds may be added
constexpr int settlingRounds = 4;  // in which they only move
constexpr int smoothingRounds = 6;
constexpr double normalWeight = 4;     // of deviation against distance
constexpr double mostCurvature = .22;  // area mean of 1 − cos(angle to the mean normal)
constexpr std::size_t mostTriangles = 12000;

struct Seed {
  std::uint32_t triangle;
  Point3 normal;
};

/// Cells of seeds on a part of the surface.
class Cells {
 public:
  /// `domain` lists the triangles to divide.
  Cells(const Topology& topology, const std::vector<std::uint32_t>& domain)
      : topology_(topology),
        domain_(domain),
        cell_(topology.triangles.size(), none),
        distance_(topology.triangles.size(), infinity),
        inside_(topology.triangles.size(), false) {
    for (const std::uint32_t t : domain) inside_[t] = true;
  }

  std::vector<Seed> seeds;

  /// Every triangle goes to the seed that reaches it first; a triangle that none reaches becomes a
  /// seed.
  void grow() {
    for (const std::uint32_t t : domain_) {
      cell_[t] = none;
      distance_[t] = infinity;
    }
    for (std::uint32_t c = 0; c < seeds.size(); ++c) push(seeds[c].triangle, c, 0);
    run();
    for (const std::uint32_t t : domain_) {
      if (cell_[t] != none) continue;
      seeds.push_back({t, topology_.normals[t]});
      push(t, static_cast<std::uint32_t>(seeds.size() - 1), 0);
      run();
    }
  }

  /// Moves each seed to the triangle deepest inside its cell and takes the cell's mean normal.
  void centre() {
    std::vector<Point3> sums(seeds.size(), Point3{});
    for (const std::uint32_t t : domain_) {
      for (std::size_t i = 0; i < 3; ++i) {
        sums[cell_[t]][i] += topology_.areas[t] * topology_.normals[t][i];
      }
    }
    const std::vector<double> depth = depths();
    std::vector<double> deepest(seeds.size(), -1);
    for (const std::uint32_t t : domain_) {
      const std::uint32_t c = cell_[t];
      if (depth[t] <= deepest[c]) continue;
      deepest[c] = depth[t];
      seeds[c].triangle = t;
    }
    for (std::size_t c = 0; c < seeds.size(); ++c) {
      const double size = length(sums[c]);
      seeds[c].normal = size > 0 ? Point3{sums[c][0] / size, sums[c][1] / size, sums[c][2] / size}
                                 : topology_.normals[seeds[c].triangle];
    }
  }

  /// Adds a seed at the far end of every cell that is too curved or too large; false if none is.
  bool addSeeds() {
    const std::size_t count = seeds.size();
    std::vector<double> deviation(count, 0);
    std::vector<double> area(count, 0);
    std::vector<std::size_t> triangles(count, 0);
    std::vector<std::uint32_t> farthest(count, none);
    for (const std::uint32_t t : domain_) {
      const std::uint32_t c = cell_[t];
      deviation[c] += topology_.areas[t] * (1 - dot(topology_.normals[t], seeds[c].normal));
      area[c] += topology_.areas[t];
      ++triangles[c];
      if (farthest[c] == none || distance_[t] > distance_[farthest[c]]) farthest[c] = t;
    }
    bool added = false;
    for (std::size_t c = 0; c < count; ++c) {
      if (triangles[c] < 4) continue;
      if (deviation[c] <= mostCurvature * area[c] && triangles[c] <= mostTriangles) continue;
      seeds.push_back({farthest[c], topology_.normals[farthest[c]]});
      added = true;
    }
    return added;
  }

  /// Straightens borders: a triangle with two neighbours in one other cell joins it.
  void smooth() {
    for (int round = 0; round < smoothingRounds; ++round) {
      for (const std::uint32_t t : domain_) {
        const auto& n = topology_.neighbours[t];
        for (std::size_t i = 0; i < 3; ++i) {
          const std::uint32_t a = cellAt(n[i]);
          if (a != none && a != cell_[t] && a == cellAt(n[(i + 1) % 3])) {
            cell_[t] = a;
            break;
          }
        }
      }
    }
  }

  /// Two cells with equal numbers of triangles, whatever these look like: the half that is reached
  /// first from the first triangle, edge by edge, and the rest.
  void halve() {
    for (const std::uint32_t t : domain_) cell_[t] = 1;
    std::size_t left = domain_.size() / 2;
    std::vector<std::uint32_t> reached;
    const auto take = [&](std::uint32_t t) {
      if (left == 0 || cell_[t] == 0) return;
      cell_[t] = 0;
      --left;
      reached.push_back(t);
    };
    for (const std::uint32_t first : domain_) {
      take(first);
      for (std::size_t i = 0; i < reached.size(); ++i) {
        for (const std::uint32_t n : topology_.neighbours[reached[i]]) {
          if (n != none && inside_[n]) take(n);
        }
      }
      reached.clear();
    }
  }

  /// The connected parts of all cells.
  std::vector<Chart> charts() const {
    std::vector<Chart> result;
    std::vector<bool> seen(cell_.size(), false);
    for (const std::uint32_t first : domain_) {
      if (seen[first]) continue;
      Chart chart = {first};
      seen[first] = true;
      for (std::size_t i = 0; i < chart.size(); ++i) {
        for (const std::uint32_t n : topology_.neighbours[chart[i]]) {
          if (n == none || !inside_[n] || seen[n] || cell_[n] != cell_[first]) continue;
          seen[n] = true;
          chart.push_back(n);
        }
      }
      std::sort(chart.begin(), chart.end());
      result.push_back(std::move(chart));
    }
    return result;
  }

  double distance(std::uint32_t triangle) const { return distance_[triangle]; }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  struct Arrival {
    double distance;
    std::uint32_t triangle;
    std::uint32_t cell;
    bool operator>(const Arrival& other) const {
      return std::tie(distance, triangle, cell) >
             std::tie(other.distance, other.triangle, other.cell);
    }
  };

  std::uint32_t cellAt(std::uint32_t t) const { return t == none || !inside_[t] ? none : cell_[t]; }

  void push(std::uint32_t triangle, std::uint32_t cell, double distance) {
    if (distance >= distance_[triangle]) return;
    distance_[triangle] = distance;
    queue_.push({distance, triangle, cell});
  }

  void run() {
    while (!queue_.empty()) {
      const Arrival a = queue_.top();
      queue_.pop();
      if (a.distance > distance_[a.triangle] || cell_[a.triangle] != none) continue;
      cell_[a.triangle] = a.cell;
      for (const std::uint32_t n : topology_.neighbours[a.triangle]) {
        if (n == none || !inside_[n] || cell_[n] != none) continue;
        const double step =
            length(subtract(topology_.centroids[n], topology_.centroids[a.triangle]));
        const double deviation = 1 - dot(topology_.normals[n], seeds[a.cell].normal);
        push(n, a.cell, a.distance + step * (1 + normalWeight * deviation));
      }
    }
  }

  /// Distance of each triangle from the border of its cell.
  std::vector<double> depths() const {
    std::vector<double> depth(cell_.size(), infinity);
    std::priority_queue<std::pair<double, std::uint32_t>,
                        std::vector<std::pair<double, std::uint32_t>>, std::greater<>>
        queue;
    for (const std::uint32_t t : domain_) {
      for (const std::uint32_t n : topology_.neighbours[t]) {
        if (cellAt(n) == cell_[t] || depth[t] == 0) continue;
        depth[t] = 0;
        queue.push({0, t});
      }
    }
    while (!queue.empty()) {
      const auto [d, t] = queue.top();
      queue.pop();
      if (d > depth[t]) continue;
      for (const std::uint32_t n : topology_.neighbours[t]) {
        if (cellAt(n) != cell_[t]) continue;
        const double next = d + length(subtract(topology_.centroids[n], topology_.centroids[t]));
        if (next >= depth[n]) continue;
        depth[n] = next;
        queue.push({next, n});
      }
    }
    return depth;
  }

  const Topology& topology_;
  const std::vector<std::uint32_t>& domain_;
  std::vector<std::uint32_t> cell_;
  std::vector<double> distance_;
  std::vector<bool> inside_;
  std::priority_queue<Arrival, std::vector<Arrival>, std::greater<>> queue_;
};

/// The part of a topology that a chart covers, with triangles renumbered in the chart's order.
Topology restricted(const Topology& topology, const Chart& chart) {
  Topology part;
  const auto local = [&](std::uint32_t t) {
    const auto place = std::lower_bound(chart.begin(), chart.end(), t);
    return t == none || place == chart.end() || *place != t
               ? none
               : static_cast<std::uint32_t>(place - chart.begin());
  };
  for (const std::uint32_t t : chart) {
    const auto& n = topology.neighbours[t];
    part.triangles.push_back(topology.triangles[t]);
    part.neighbours.push_back({local(n[0]), local(n[1]), local(n[2])});
    part.normals.push_back(topology.normals[t]);
    part.centroids.push_back(topology.centroids[t]);
    part.areas.push_back(topology.areas[t]);
  }
  return part;
}

/// Whether charts that were made of `whole` triangles are so much smaller that dividing them again
/// and again comes to an end soon: with a sixteenth less each time, after 16 log(whole) rounds.
bool areMuchSmaller(const std::vector<Chart>& charts, std::size_t whole) {
  return std::all_of(charts.begin(), charts.end(),
                     [&](const Chart& chart) { return chart.size() <= whole - (whole + 15) / 16; });
}

std::uint32_t farthest(const Cells& cells, std::size_t triangles) {
  std::uint32_t result = 0;
  for (std::uint32_t t = 1; t < triangles; ++t) {
    if (cells.distance(t) > cells.distance(result)) result = t;
  }
  return result;
}

}  // namespace

std::vector<Chart> segment(const Topology& topology) {
  std::vector<std::uint32_t> domain;
  for (std::uint32_t t = 0; t < topology.triangles.size(); ++t) {
    if (!topology.degenerate[t]) domain.push_back(t);
  }
  Cells cells(topology, domain);
  cells.grow();
  for (int round = 0; round < growthRounds; ++round) {
    cells.centre();
    if (!cells.addSeeds() && round > 0) break;
    cells.grow();
  }
  for (int round = 0; round < settlingRounds; ++round) {
    cells.centre();
    cells.grow();
  }
  cells.smooth();
  return cells.charts();
}

std::vector<Chart> split(const Topology& topology, const Chart& chart) {
  assert(chart.size() > 1);
  const Topology part = restricted(topology, chart);
  std::vector<std::uint32_t> domain(chart.size());
  std::iota(domain.begin(), domain.end(), 0U);
  Cells cells(part, domain);
  cells.seeds = {{0, part.normals[0]}};
  cells.grow();
  const std::uint32_t a = farthest(cells, chart.size());
  cells.seeds = {{a, part.normals[a]}};
  cells.grow();
  const std::uint32_t b = farthest(cells, chart.size());
  cells.seeds = {{a, part.normals[a]}, {b, part.normals[b]}};
  cells.grow();
  std::vector<Chart> rough = cells.charts();
  for (int round = 0; round < settlingRounds; ++round) {
    cells.centre();
    cells.grow();
  }
  cells.smooth();
  std::vector<Chart> charts = cells.charts();
  if (charts.size() < 2) charts = std::move(rough);
  // Where triangles lie upon each other, distances tell none of them apart.
  if (!areMuchSmaller(charts, chart.size())) {
    cells.halve();
    charts = cells.charts();
  }
  for (Chart& c : charts) {
    for (std::uint32_t& t : c) t = chart[t];
  }
  return charts;
}

}  // namespace opaline::atlas
