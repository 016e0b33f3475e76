#include "paper/atlas/flatten.h"

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "paper/atlas/border.h"
#include "paper/atlas/initial_map.h"

namespace opaline::atlas {
namespace {

constexpr int mostSteps = 10;
constexpr double angleWeight = .1;
constexpr double enoughProgress = 2e-3;  // part of the energy that a step must gain for another to
                                         // follow

using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;
using Vector4 = Eigen::Vector4d;
using Matrix4 = Eigen::Matrix4d;
using Matrix46 = Eigen::Matrix<double, 4, 6>;

/// Σ w [r + 1/r − 2 + λ (|J|²/r − 2)] over the triangles, J the map from the surface to the plane,
/// r = det J, w the triangle's share of the area, λ the weight of angles. Jacobians are stored as
/// (∂u/∂s, ∂u/∂t, ∂v/∂s, ∂v/∂t), places as u, v of each vertex in turn.
class EqualAreaEnergy {
 public:
  explicit EqualAreaEnergy(const ChartMesh& mesh) : mesh_(mesh) {
    double total = 0;
    for (const Triangle& t : mesh.triangles) {
      const Point3 ab = subtract(mesh.positions[t[1]], mesh.positions[t[0]]);
      const Point3 ac = subtract(mesh.positions[t[2]], mesh.positions[t[0]]);
      const double base = length(ab);
      const double height = length(cross(ab, ac)) / base;
      const double along = dot(ab, ac) / base;
      Matrix46 toJacobian = Matrix46::Zero();
      // Gradients of the three hat functions in the frame (along ab, across).
      const std::array<double, 3> ds = {-1 / base, 1 / base, 0};
      const std::array<double, 3> dt = {(along / base - 1) / height, -along / base / height,
                                        1 / height};
      for (Eigen::Index k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(k);
        toJacobian(0, 2 * k) = toJacobian(2, 2 * k + 1) = ds[i];
        toJacobian(1, 2 * k) = toJacobian(3, 2 * k + 1) = dt[i];
      }
      toJacobian_.push_back(toJacobian);
      weights_.push_back(base * height / 2);
      total += base * height / 2;
    }
    area_ = total;
    for (double& w : weights_) w /= total;
    layOutHessian();
  }

  double area() const { return area_; }

  double value(const Vector& places) const {
    double sum = 0;
    for (std::size_t t = 0; t < weights_.size(); ++t) {
      const Vector4 j = jacobian(t, places);
      const double r = determinant(j);
      if (!(r > 0)) return std::numeric_limits<double>::infinity();
      sum += weights_[t] * (r + 1 / r - 2 + angleWeight * (j.squaredNorm() / r - 2));
    }
    return sum;
  }

  /// Gradient, and a positive semidefinite stand-in for the second derivatives: those of the energy
  /// as a convex function of (J, r), and of r itself only what lets rotations cost nothing.
  void differentiate(const Vector& places, Vector& gradient) {
    gradient = Vector::Zero(places.size());
    std::fill_n(hessian_.valuePtr(), hessian_.nonZeros(), 0.0);
    for (std::size_t t = 0; t < weights_.size(); ++t) {
      const Vector4 j = jacobian(t, places);
      const double r = determinant(j);
      const Vector4 c(j[3], -j[2], -j[1], j[0]);  // dr/dJ
      const double m = j.squaredNorm() / r;
      const Vector4 slope = (1 - 1 / (r * r)) * c + angleWeight * ((2 / r) * j - (m / r) * c);
      const Matrix4 offset = Matrix4::Identity() - j * c.transpose() / r;
      Matrix4 curvature = offset.transpose() * offset;
      curvature(0, 3) -= 1;
      curvature(3, 0) -= 1;
      curvature(1, 2) += 1;
      curvature(2, 1) += 1;
      curvature *= 2 * angleWeight / r;
      curvature += (2 / (r * r * r)) * c * c.transpose();
      add(t, slope, curvature, gradient);
    }
    const double mean = hessian_.diagonal().mean();
    for (Eigen::Index i = 0; i < places.size(); ++i) *diagonal(i) += 1e-7 * mean;
  }

  /// Lower triangle of the stand-in for the second derivatives.
  const Matrix& hessian() const { return hessian_; }

  /// The longest step in a direction, at most 1, that keeps every triangle clear of collapse.
  double longestStep(const Vector& places, const Vector& direction) const {
    double step = 1;
    for (std::size_t t = 0; t < weights_.size(); ++t) {
      const Vector4 j = jacobian(t, places);
      const Vector4 d = jacobian(t, direction);
      const double a = determinant(d);
      const double b = j[0] * d[3] + d[0] * j[3] - j[1] * d[2] - d[1] * j[2];
      step = std::min(step, .8 * leastPositiveRoot(a, b, determinant(j)));
    }
    return step;
  }

  void measure(const Vector& places, FlatChart& chart) const {
    double squares = 0;
    double stretch = 0;
    for (std::size_t t = 0; t < weights_.size(); ++t) {
      const Vector4 j = jacobian(t, places);
      const double r = determinant(j);
      const double half = j.squaredNorm() / r / 2;
      squares += weights_[t] * std::log(r) * std::log(r);
      stretch += weights_[t] * (half + std::sqrt(std::max(half * half - 1, 0.0)));
    }
    chart.areaDistortionRms = std::sqrt(squares);
    chart.stretch = stretch;
  }

 private:
  static double determinant(const Vector4& j) { return j[0] * j[3] - j[1] * j[2]; }

  static double leastPositiveRoot(double a, double b, double c) {
    constexpr double never = 1e30;
    const double discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return never;
    const double q = -(b + std::copysign(std::sqrt(discriminant), b)) / 2;
    double least = never;
    if (a != 0 && q / a > 0) least = std::min(least, q / a);
    if (q != 0 && c / q > 0) least = std::min(least, c / q);
    return least;
  }

  Vector4 jacobian(std::size_t t, const Vector& places) const {
    const Triangle& v = mesh_.triangles[t];
    Eigen::Matrix<double, 6, 1> local;
    for (Eigen::Index k = 0; k < 3; ++k) {
      const auto i = static_cast<Eigen::Index>(v[static_cast<std::size_t>(k)]);
      local[2 * k] = places[2 * i];
      local[2 * k + 1] = places[2 * i + 1];
    }
    return toJacobian_[t] * local;
  }

  void add(std::size_t t, const Vector4& slope, const Matrix4& curvature, Vector& gradient) {
    const Matrix46& g = toJacobian_[t];
    const Eigen::Matrix<double, 6, 1> force = weights_[t] * (g.transpose() * slope);
    const Eigen::Matrix<double, 6, 6> block = weights_[t] * (g.transpose() * curvature * g);
    const std::array<int, 6> index = unknowns(t);
    std::size_t slot = 0;
    for (int k = 0; k < 6; ++k) {
      gradient[index[static_cast<std::size_t>(k)]] += force[k];
      for (int l = 0; l <= k; ++l) hessian_.valuePtr()[slots_[t][slot++]] += block(k, l);
    }
  }

  std::array<int, 6> unknowns(std::size_t t) const {
    std::array<int, 6> index{};
    for (std::size_t k = 0; k < 6; ++k) {
      index[k] = 2 * static_cast<int>(mesh_.triangles[t][k / 2]) + static_cast<int>(k % 2);
    }
    return index;
  }

  double* diagonal(Eigen::Index i) { return hessian_.valuePtr() + hessian_.outerIndexPtr()[i]; }

  /// Lays out the matrix once and finds where the entries of each triangle go.
  void layOutHessian() {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(21 * weights_.size());
    const auto forEntries = [&](std::size_t t, const auto& use) {
      const std::array<int, 6> index = unknowns(t);
      for (std::size_t k = 0; k < 6; ++k) {
        for (std::size_t l = 0; l <= k; ++l) {
          use(std::max(index[k], index[l]), std::min(index[k], index[l]));
        }
      }
    };
    for (std::size_t t = 0; t < weights_.size(); ++t) {
      forEntries(t, [&](int row, int column) { entries.emplace_back(row, column, 1); });
    }
    const auto size = 2 * static_cast<Eigen::Index>(mesh_.positions.size());
    hessian_.resize(size, size);
    hessian_.setFromTriplets(entries.begin(), entries.end());
    for (std::size_t t = 0; t < weights_.size(); ++t) {
      std::array<int, 21> slots{};
      std::size_t slot = 0;
      forEntries(t, [&](int row, int column) {
        const int* rows = hessian_.innerIndexPtr();
        const int* first = rows + hessian_.outerIndexPtr()[column];
        const int* last = rows + hessian_.outerIndexPtr()[column + 1];
        slots[slot++] = static_cast<int>(std::lower_bound(first, last, row) - rows);
      });
      slots_.push_back(slots);
    }
  }

  const ChartMesh& mesh_;
  std::vector<Matrix46> toJacobian_;
  std::vector<double> weights_;
  double area_ = 0;
  Matrix hessian_;
  std::vector<std::array<int, 21>> slots_;
};

double flatArea(const ChartMesh& mesh, const Vector& places) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    std::array<Point2, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto i = static_cast<Eigen::Index>(t[k]);
      p[k] = {places[2 * i], places[2 * i + 1]};
    }
    sum += signedArea(p[0], p[1], p[2]);
  }
  return sum;
}

void scaleToArea(const ChartMesh& mesh, double area, Vector& places) {
  places *= std::sqrt(area / flatArea(mesh, places));
}

/// Newton's method with a line search that never lets a triangle collapse (Smith, Schaefer 2015).
void minimise(EqualAreaEnergy& energy, Vector& places) {
  Eigen::SimplicialLDLT<Matrix, Eigen::Lower> solver;
  Vector gradient;
  double value = energy.value(places);
  for (int step = 0; step < mostSteps && std::isfinite(value); ++step) {
    energy.differentiate(places, gradient);
    if (step == 0) solver.analyzePattern(energy.hessian());
    solver.factorize(energy.hessian());
    if (solver.info() != Eigen::Success) return;
    const Vector direction = -solver.solve(gradient);
    const double slope = gradient.dot(direction);
    if (!(slope < 0)) return;
    double size = energy.longestStep(places, direction);
    double next = energy.value(places + size * direction);
    while (!(next <= value + 1e-4 * size * slope) && size > 1e-10) {
      size /= 2;
      next = energy.value(places + size * direction);
    }
    if (!(next < value)) return;
    places += size * direction;
    const double progress = value - next;
    value = next;
    if (progress < enoughProgress * value || progress < 1e-7) return;
  }
}

}  // namespace

std::optional<FlatChart> flatten(const ChartMesh& mesh) {
  if (mesh.handles != 0 || mesh.loops.empty()) return std::nullopt;
  const auto initial = initialMap(mesh);
  if (!initial) return std::nullopt;
  Vector places(2 * static_cast<Eigen::Index>(initial->size()));
  for (std::size_t v = 0; v < initial->size(); ++v) {
    places[2 * static_cast<Eigen::Index>(v)] = (*initial)[v][0];
    places[2 * static_cast<Eigen::Index>(v) + 1] = (*initial)[v][1];
  }
  EqualAreaEnergy energy(mesh);
  scaleToArea(mesh, energy.area(), places);
  minimise(energy, places);
  scaleToArea(mesh, energy.area(), places);
  if (!places.allFinite() || !std::isfinite(energy.value(places))) return std::nullopt;
  FlatChart chart;
  energy.measure(places, chart);
  for (Eigen::Index v = 0; v < places.size() / 2; ++v) {
    chart.places.push_back({places[2 * v], places[2 * v + 1]});
  }
  if (!isOneToOne(mesh, chart.places)) return std::nullopt;
  return chart;
}

}  // namespace opaline::atlas
