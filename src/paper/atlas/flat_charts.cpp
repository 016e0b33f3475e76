#include "paper/atlas/flat_charts.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <thread>
#include <utility>

namespace opaline::atlas {
namespace {

constexpr double mostAreaDistortion = .06;
constexpr double mostStretch = 1.4;

std::optional<SurfaceChart> finish(const Topology& topology, const Chart& chart) {
  SurfaceChart finished = {chart, extract(topology, chart), {}};
  auto flat = flatten(finished.mesh);
  if (!flat) return std::nullopt;
  const bool isSplittable = chart.size() > 1;
  if (isSplittable &&
      (flat->areaDistortionRms > mostAreaDistortion || flat->stretch > mostStretch)) {
    return std::nullopt;
  }
  finished.flat = std::move(*flat);
  return finished;
}

/// A triangle by itself, in its own shape.
SurfaceChart singleTriangle(const Topology& topology, std::uint32_t triangle) {
  const Chart chart = {triangle};
  SurfaceChart finished = {chart, extract(topology, chart), {}};
  const auto& p = finished.mesh.positions;
  const Point3 ab = subtract(p[1], p[0]);
  const Point3 ac = subtract(p[2], p[0]);
  const double base = length(ab);
  finished.flat.places = {{0, 0}, {base, 0}, {dot(ab, ac) / base, length(cross(ab, ac)) / base}};
  return finished;
}

/// Runs work(i) for every i below count on two threads.
template <typename Work>
void inParallel(std::size_t count, const Work& work) {
  std::atomic<std::size_t> next = 0;
  const auto loop = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  std::jthread other;
  if (count > 1) other = std::jthread(loop);
  loop();
}

/// Flattens the charts and divides those that do not lie flat until all do; a single triangle
/// always does.
std::vector<SurfaceChart> flattenAll(const Topology& topology, std::vector<Chart> charts) {
  std::vector<SurfaceChart> result;
  while (!charts.empty()) {
    std::vector<std::optional<SurfaceChart>> finished(charts.size());
    std::vector<std::vector<Chart>> parts(charts.size());
    inParallel(charts.size(), [&](std::size_t i) {
      if (charts[i].size() == 1) {
        finished[i] = singleTriangle(topology, charts[i].front());
      } else {
        finished[i] = finish(topology, charts[i]);
      }
      if (!finished[i]) parts[i] = split(topology, charts[i]);
    });
    charts.clear();
    for (std::size_t i = 0; i < finished.size(); ++i) {
      if (finished[i]) result.push_back(std::move(*finished[i]));
      for (Chart& part : parts[i]) charts.push_back(std::move(part));
    }
  }
  return result;
}

/// Two charts that share part of their borders, and how large that part is of the smaller border.
struct Neighbours {
  std::size_t a, b;
  double sharedPart;
};

/// Joins charts pair by pair while the union of two still lies flat well. Pairs that share most of
/// their borders come first, which keeps charts compact.
class Joiner {
 public:
  Joiner(const Topology& topology, std::vector<SurfaceChart> charts)
      : topology_(topology), charts_(std::move(charts)) {
    std::size_t triangles = 0;
    for (const SurfaceChart& chart : charts_) triangles += chart.triangles.size();
    mostWork_ = workPerTriangle * triangles;
  }

  std::vector<SurfaceChart> run() {
    while (work_ < mostWork_) {
      const std::vector<Neighbours> pairs = nextPairs();
      if (pairs.empty()) break;
      std::vector<std::optional<SurfaceChart>> joined(pairs.size());
      inParallel(pairs.size(), [&](std::size_t i) {
        Chart triangles;
        std::merge(charts_[pairs[i].a].triangles.begin(), charts_[pairs[i].a].triangles.end(),
                   charts_[pairs[i].b].triangles.begin(), charts_[pairs[i].b].triangles.end(),
                   std::back_inserter(triangles));
        joined[i] = finish(topology_, triangles);
      });
      for (std::size_t i = 0; i < pairs.size(); ++i) settle(pairs[i], std::move(joined[i]));
    }
    std::erase_if(charts_, [](const SurfaceChart& chart) { return chart.triangles.empty(); });
    return std::move(charts_);
  }

 private:
  static constexpr std::size_t workPerTriangle = 4;  // flattened again and again

  static constexpr double largestPart = .08;  // of all triangles, in one joined chart
  static constexpr std::size_t mostTriangles = 16000;
  static constexpr double leastSharedPart = .12;

  void settle(const Neighbours& pair, std::optional<SurfaceChart> joined) {
    work_ += charts_[pair.a].triangles.size() + charts_[pair.b].triangles.size();
    if (!joined) {
      refused_.insert({pair.a, pair.b});
      return;
    }
    // The union is a chart of its own, so whatever either refused is tried again with it.
    charts_[pair.a] = {};
    charts_[pair.b] = {};
    charts_.push_back(std::move(*joined));
  }

  /// The best pairs of which no two have a chart in common.
  std::vector<Neighbours> nextPairs() const {
    std::vector<Neighbours> pairs = neighbours();
    std::stable_sort(pairs.begin(), pairs.end(), [](const Neighbours& a, const Neighbours& b) {
      return a.sharedPart > b.sharedPart;
    });
    std::vector<bool> taken(charts_.size(), false);
    std::erase_if(pairs, [&](const Neighbours& pair) {
      if (taken[pair.a] || taken[pair.b]) return true;
      taken[pair.a] = taken[pair.b] = true;
      return false;
    });
    return pairs;
  }

  std::vector<Neighbours> neighbours() const {
    std::vector<std::uint32_t> chartOf(topology_.triangles.size(), none);
    for (std::size_t c = 0; c < charts_.size(); ++c) {
      for (const std::uint32_t t : charts_[c].triangles) chartOf[t] = static_cast<std::uint32_t>(c);
    }
    std::vector<double> border(charts_.size(), 0);
    std::map<std::pair<std::size_t, std::size_t>, double> shared;
    for (std::uint32_t t = 0; t < chartOf.size(); ++t) {
      if (chartOf[t] == none) continue;
      for (std::size_t e = 0; e < 3; ++e) {
        const std::uint32_t n = topology_.neighbours[t][e];
        if (n != none && chartOf[n] == chartOf[t]) continue;
        const Triangle& v = topology_.triangles[t];
        const double size =
            length(subtract(topology_.positions[v[e]], topology_.positions[v[(e + 1) % 3]]));
        border[chartOf[t]] += size;
        if (n != none && chartOf[t] < chartOf[n]) shared[{chartOf[t], chartOf[n]}] += size;
      }
    }
    std::vector<Neighbours> pairs;
    for (const auto& [pair, size] : shared) {
      const double part = size / std::min(border[pair.first], border[pair.second]);
      const std::size_t triangles =
          charts_[pair.first].triangles.size() + charts_[pair.second].triangles.size();
      if (part < leastSharedPart || triangles > mostTriangles ||
          static_cast<double>(triangles) >
              largestPart * static_cast<double>(topology_.triangles.size()) ||
          refused_.contains(pair))
        continue;
      pairs.push_back({pair.first, pair.second, part});
    }
    return pairs;
  }

  const Topology& topology_;
  std::vector<SurfaceChart> charts_;
  std::set<std::pair<std::size_t, std::size_t>> refused_;
  std::size_t work_ = 0;
  std::size_t mostWork_ = 0;
};

}  // namespace

std::vector<SurfaceChart> flattenCharts(const Topology& topology, std::vector<Chart> charts) {
  return Joiner(topology, flattenAll(topology, std::move(charts))).run();
}

}  // namespace opaline::atlas
