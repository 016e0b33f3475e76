#include "builtin/surface_net.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace opaline::builtin {
namespace {

using Point = std::array<double, 3>;

constexpr int spreadingRounds = 8;
constexpr int newtonSteps = 2;
constexpr std::size_t blockEdge = 4;
constexpr std::uint32_t noVertex = std::numeric_limits<std::uint32_t>::max();

Point difference(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double squaredDistance(const Point& a, const Point& b) {
  const Point d = difference(a, b);
  return dot(d, d);
}

/// The corners of the grid with the field's values there.
class Lattice {
 public:
  Lattice(const Field& field, const Grid& grid) : grid_(grid) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      corners_[axis] = 1 + static_cast<std::size_t>(
                               std::ceil((grid.high[axis] - grid.low[axis]) / grid.spacing));
    }
    values_.resize(corners_[0] * corners_[1] * corners_[2]);
    for (std::size_t k = 0; k < corners_[2]; k += blockEdge) {
      for (std::size_t j = 0; j < corners_[1]; j += blockEdge) {
        for (std::size_t i = 0; i < corners_[0]; i += blockEdge) fillBlock(field, {i, j, k});
      }
    }
  }

  using Index = std::array<std::size_t, 3>;

  const Index& corners() const { return corners_; }
  std::size_t offset(const Index& c) const {
    return (c[2] * corners_[1] + c[1]) * corners_[0] + c[0];
  }
  double value(const Index& c) const { return values_[offset(c)]; }
  Point position(const Index& c) const {
    return {grid_.low[0] + grid_.spacing * static_cast<double>(c[0]),
            grid_.low[1] + grid_.spacing * static_cast<double>(c[1]),
            grid_.low[2] + grid_.spacing * static_cast<double>(c[2])};
  }

 private:
  /// Far from the surface the value at the middle of a block stands for all of it; the factor 2
  /// covers fields that are distances to first order only.
  void fillBlock(const Field& field, const Index& first) {
    Point middle = position(first);
    for (double& x : middle) x += grid_.spacing * (blockEdge - 1) / 2;
    const double common = field.distance(middle);
    const bool isFar = std::fabs(common) > 2 * std::sqrt(3.0) / 2 * blockEdge * grid_.spacing;
    for (std::size_t k = first[2]; k < std::min(first[2] + blockEdge, corners_[2]); ++k) {
      for (std::size_t j = first[1]; j < std::min(first[1] + blockEdge, corners_[1]); ++j) {
        for (std::size_t i = first[0]; i < std::min(first[0] + blockEdge, corners_[0]); ++i) {
          values_[offset({i, j, k})] = isFar ? common : field.distance(position({i, j, k}));
        }
      }
    }
  }

  Grid grid_;
  Index corners_{};
  std::vector<double> values_;
};

struct Net {
  std::vector<Point> positions;
  std::vector<std::array<std::uint32_t, 4>> quads;  // counter-clockwise seen from outside
};

/// Mean of the points where the surface crosses the edges of a cell; false if it crosses none.
bool crossingMean(const Lattice& lattice, const Lattice::Index& cell, Point& mean) {
  Point sum{};
  int count = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t side = 0; side < 4; ++side) {
      Lattice::Index a = cell;
      a[(axis + 1) % 3] += side & 1U;
      a[(axis + 2) % 3] += side >> 1U;
      Lattice::Index b = a;
      ++b[axis];
      const double va = lattice.value(a);
      const double vb = lattice.value(b);
      if ((va < 0) == (vb < 0)) continue;
      const double t = va / (va - vb);
      const Point pa = lattice.position(a);
      const Point pb = lattice.position(b);
      for (std::size_t i = 0; i < 3; ++i) sum[i] += pa[i] + t * (pb[i] - pa[i]);
      ++count;
    }
  }
  if (count == 0) return false;
  for (std::size_t i = 0; i < 3; ++i) mean[i] = sum[i] / count;
  return true;
}

/// One quadrilateral around each edge that the surface crosses, joining the four cells at the edge.
void addQuads(const Lattice& lattice, const std::vector<std::uint32_t>& vertexOfCell,
              const Lattice::Index& corner, Net& net) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t right = (axis + 1) % 3;
    const std::size_t up = (axis + 2) % 3;
    if (corner[axis] + 1 >= lattice.corners()[axis]) continue;
    Lattice::Index next = corner;
    ++next[axis];
    const bool insideHere = lattice.value(corner) < 0;
    if (insideHere == (lattice.value(next) < 0)) continue;
    assert(corner[right] > 0 && corner[up] > 0);
    std::array<std::uint32_t, 4> quad{};
    constexpr std::array<std::array<std::size_t, 2>, 4> around = {{{1, 1}, {0, 1}, {0, 0}, {1, 0}}};
    for (std::size_t i = 0; i < 4; ++i) {
      Lattice::Index cell = corner;
      cell[right] -= around[i][0];
      cell[up] -= around[i][1];
      quad[i] = vertexOfCell[lattice.offset(cell)];
      assert(quad[i] != noVertex);
    }
    if (!insideHere) std::swap(quad[1], quad[3]);
    net.quads.push_back(quad);
  }
}

Net makeNet(const Lattice& lattice) {
  const auto [nx, ny, nz] = lattice.corners();
  Net net;
  std::vector<std::uint32_t> vertexOfCell(nx * ny * nz, noVertex);
  for (std::size_t k = 0; k + 1 < nz; ++k) {
    for (std::size_t j = 0; j + 1 < ny; ++j) {
      for (std::size_t i = 0; i + 1 < nx; ++i) {
        Point mean{};
        if (!crossingMean(lattice, {i, j, k}, mean)) continue;
        vertexOfCell[lattice.offset({i, j, k})] = static_cast<std::uint32_t>(net.positions.size());
        net.positions.push_back(mean);
      }
    }
  }
  for (std::size_t k = 0; k < nz; ++k) {
    for (std::size_t j = 0; j < ny; ++j) {
      for (std::size_t i = 0; i < nx; ++i) addQuads(lattice, vertexOfCell, {i, j, k}, net);
    }
  }
  return net;
}

/// Newton's method along the gradient.
void project(const Field& field, Point& position) {
  for (int step = 0; step < newtonSteps; ++step) {
    const auto [distance, gradient] = field.sample(position);
    const double slope = std::max(dot(gradient, gradient), 1e-12);
    for (std::size_t i = 0; i < 3; ++i) position[i] -= distance * gradient[i] / slope;
  }
}

/// Moves every vertex towards the mean of its quads' centres, within the tangent plane.
void spread(const Field& field, Net& net) {
  std::vector<Point> sums(net.positions.size(), Point{});
  std::vector<int> counts(net.positions.size(), 0);
  for (const auto& quad : net.quads) {
    Point centre{};
    for (const std::uint32_t v : quad) {
      for (std::size_t i = 0; i < 3; ++i) centre[i] += net.positions[v][i] / 4;
    }
    for (const std::uint32_t v : quad) {
      for (std::size_t i = 0; i < 3; ++i) sums[v][i] += centre[i];
      ++counts[v];
    }
  }
  for (std::size_t v = 0; v < net.positions.size(); ++v) {
    if (counts[v] == 0) continue;
    Point move{};
    for (std::size_t i = 0; i < 3; ++i) move[i] = sums[v][i] / counts[v] - net.positions[v][i];
    const auto [distance, gradient] = field.sample(net.positions[v]);
    const double slope = std::max(dot(gradient, gradient), 1e-12);
    const double away = (dot(move, gradient) + distance) / slope;
    for (std::size_t i = 0; i < 3; ++i) net.positions[v][i] += move[i] - away * gradient[i];
  }
}

Vec3 toFloat(const Point& p) {
  return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
}

}  // namespace

Mesh polygonise(const Field& field, const Grid& grid) {
  Net net = makeNet(Lattice(field, grid));
  for (int round = 0; round < spreadingRounds; ++round) spread(field, net);
  Mesh mesh;
  mesh.positionsMm.reserve(net.positions.size());
  mesh.normals.reserve(net.positions.size());
  mesh.triangles.reserve(2 * net.quads.size());
  for (Point& position : net.positions) {
    project(field, position);
    const Point gradient = field.sample(position).gradient;
    const double length = std::sqrt(dot(gradient, gradient));
    mesh.positionsMm.push_back(toFloat(position));
    mesh.normals.push_back(
        toFloat({gradient[0] / length, gradient[1] / length, gradient[2] / length}));
  }
  for (const auto& [a, b, c, d] : net.quads) {
    const auto& p = net.positions;
    if (squaredDistance(p[a], p[c]) <= squaredDistance(p[b], p[d])) {
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    } else {
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({b, c, d});
    }
  }
  return mesh;
}

}  // namespace opaline::builtin
