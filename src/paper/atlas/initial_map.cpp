#include "paper/atlas/initial_map.h"

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace opaline::atlas {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Entries = std::vector<Eigen::Triplet<double>>;

bool isUnmirrored(const ChartMesh& mesh, const std::vector<Point2>& places) {
  for (const Triangle& t : mesh.triangles) {
    if (!(signedArea(places[t[0]], places[t[1]], places[t[2]]) > 0)) return false;
  }
  return true;
}

Point3 areaVector(const ChartMesh& mesh, const Triangle& t) {
  return cross(subtract(mesh.positions[t[1]], mesh.positions[t[0]]),
               subtract(mesh.positions[t[2]], mesh.positions[t[0]]));
}

/// Empty where a triangle leans too far to be seen well along the mean normal.
std::vector<Point2> projection(const ChartMesh& mesh) {
  constexpr double leastCosine = .05;
  Point3 normal{};
  for (const Triangle& t : mesh.triangles) {
    const Point3 n = areaVector(mesh, t);
    for (std::size_t i = 0; i < 3; ++i) normal[i] += n[i];
  }
  const double size = length(normal);
  if (!(size > 0)) return {};
  for (double& x : normal) x /= size;
  for (const Triangle& t : mesh.triangles) {
    const Point3 n = areaVector(mesh, t);
    if (!(dot(n, normal) > leastCosine * length(n))) return {};
  }
  const Point3 helper = std::fabs(normal[0]) < .6 ? Point3{1, 0, 0} : Point3{0, 1, 0};
  Point3 x = cross(helper, normal);
  const double scale = 1 / length(x);
  for (double& c : x) c *= scale;
  const Point3 y = cross(normal, x);
  std::vector<Point2> places;
  for (const Point3& p : mesh.positions) places.push_back({dot(p, x), dot(p, y)});
  return places;
}

/// Lévy, Petitjean, Ray, Maillot 2002: Dirichlet energy less flat area, two far border vertices
/// held.
std::vector<Point2> conformalMap(const ChartMesh& mesh) {
  const auto& border = mesh.loops.front();
  const std::uint32_t heldA = border.front();
  std::uint32_t heldB = border[border.size() / 2];
  for (const std::uint32_t v : border) {
    if (length(subtract(mesh.positions[v], mesh.positions[heldA])) >
        length(subtract(mesh.positions[heldB], mesh.positions[heldA]))) {
      heldB = v;
    }
  }
  Entries entries;
  const auto add = [&](std::uint32_t row, int rowAxis, std::uint32_t column, int columnAxis,
                       double value) {
    entries.emplace_back(2 * static_cast<int>(row) + rowAxis,
                         2 * static_cast<int>(column) + columnAxis, value);
  };
  for (const Triangle& t : mesh.triangles) {
    const double doubled = length(areaVector(mesh, t));
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[(i + 1) % 3];
      const std::uint32_t b = t[(i + 2) % 3];
      const Point3 ea = subtract(mesh.positions[a], mesh.positions[t[i]]);
      const Point3 eb = subtract(mesh.positions[b], mesh.positions[t[i]]);
      const double half = dot(ea, eb) / doubled / 2;
      for (int axis = 0; axis < 2; ++axis) {
        add(a, axis, a, axis, half);
        add(b, axis, b, axis, half);
        add(a, axis, b, axis, -half);
        add(b, axis, a, axis, -half);
      }
    }
  }
  for (const auto& [a, b] : mesh.borders) {
    add(a, 0, b, 1, -.5);
    add(b, 1, a, 0, -.5);
    add(b, 0, a, 1, .5);
    add(a, 1, b, 0, .5);
  }
  const Eigen::Index unknowns = 2 * static_cast<Eigen::Index>(mesh.positions.size());
  Matrix matrix(unknowns, unknowns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::VectorXd held = Eigen::VectorXd::Zero(unknowns);
  held[2 * static_cast<Eigen::Index>(heldB)] =
      length(subtract(mesh.positions[heldB], mesh.positions[heldA]));
  Eigen::VectorXd right = -(matrix * held);
  // A held unknown keeps its value: its row and column give way to an identity of like size.
  const double diagonal = std::max(matrix.diagonal().mean(), 1e-12);
  const auto isHeld = [&](int i) {
    return i / 2 == static_cast<int>(heldA) || i / 2 == static_cast<int>(heldB);
  };
  matrix.prune([&](int row, int column, double) { return !isHeld(row) && !isHeld(column); });
  for (const std::uint32_t v : {heldA, heldB}) {
    for (int axis = 0; axis < 2; ++axis) {
      const int i = 2 * static_cast<int>(v) + axis;
      matrix.coeffRef(i, i) = diagonal;
      right[i] = diagonal * held[i];
    }
  }
  matrix.makeCompressed();
  const Eigen::SimplicialLDLT<Matrix> solver(matrix);
  if (solver.info() != Eigen::Success) return {};
  const Eigen::VectorXd solution = solver.solve(right);
  std::vector<Point2> places;
  places.reserve(mesh.positions.size());
  for (Eigen::Index i = 0; i < unknowns; i += 2) places.push_back({solution[i], solution[i + 1]});
  return places;
}

/// Tutte 1963: the longest border lies on a circle, every other vertex at the mean of its
/// neighbours; each hole is closed by a vertex. The map is one-to-one for every disc, but far from
/// true in shape.
std::vector<Point2> tutteMap(const ChartMesh& mesh) {
  const std::size_t count = mesh.positions.size() + mesh.loops.size() - 1;
  std::vector<Point2> places(count, Point2{});
  std::vector<bool> fixed(count, false);
  const auto& rim = mesh.loops.front();
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const double angle =
        2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(rim.size());
    places[rim[i]] = {std::cos(angle), std::sin(angle)};
    fixed[rim[i]] = true;
  }
  std::vector<int> unknown(count, -1);
  int unknowns = 0;
  for (std::size_t v = 0; v < count; ++v) {
    if (!fixed[v]) unknown[v] = unknowns++;
  }
  if (unknowns == 0) return places;
  Entries entries;
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(unknowns, 2);
  const auto spring = [&](std::size_t a, std::size_t b) {  // as seen from a
    if (fixed[a]) return;
    entries.emplace_back(unknown[a], unknown[a], 1);
    if (fixed[b]) {
      right(unknown[a], 0) += places[b][0];
      right(unknown[a], 1) += places[b][1];
    } else {
      entries.emplace_back(unknown[a], unknown[b], -1);
    }
  };
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      spring(t[i], t[(i + 1) % 3]);
      spring(t[(i + 1) % 3], t[i]);
    }
  }
  for (std::size_t hole = 1; hole < mesh.loops.size(); ++hole) {
    const auto& loop = mesh.loops[hole];
    const std::size_t middle = mesh.positions.size() + hole - 1;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      spring(loop[i], middle);
      spring(middle, loop[i]);
      spring(loop[i], loop[(i + 1) % loop.size()]);
      spring(loop[(i + 1) % loop.size()], loop[i]);
    }
  }
  Matrix matrix(unknowns, unknowns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Matrix> solver(matrix);
  if (solver.info() != Eigen::Success) return {};
  const Eigen::MatrixX2d solution = solver.solve(right);
  for (std::size_t v = 0; v < count; ++v) {
    if (!fixed[v]) places[v] = {solution(unknown[v], 0), solution(unknown[v], 1)};
  }
  places.resize(mesh.positions.size());
  return places;
}

}  // namespace

double signedArea(const Point2& a, const Point2& b, const Point2& c) {
  return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
}

std::optional<std::vector<Point2>> initialMap(const ChartMesh& mesh) {
  for (const auto& make : {projection, conformalMap, tutteMap}) {
    std::vector<Point2> places = make(mesh);
    if (!places.empty() && isUnmirrored(mesh, places)) return places;
  }
  return std::nullopt;
}

}  // namespace opaline::atlas
