#include "boundary/gmres.h"

#include <cmath>

namespace opaline::test::boundary {

namespace {

double dotOf(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

GmresResult gmres(const std::function<void(std::span<const double>, std::span<double>)>& product,
                  std::span<const double> rightSide, std::span<const double> start,
                  const GmresOptions& options) {
  const std::size_t n = rightSide.size();
  GmresResult result;
  result.solution.assign(start.begin(), start.end());
  const double scale = std::sqrt(dotOf(rightSide, rightSide));
  if (scale == 0) {
    result.solution.assign(n, 0);
    return result;
  }
  std::vector<double> rest(n);
  product(result.solution, rest);
  for (std::size_t i = 0; i < n; ++i) rest[i] = rightSide[i] - rest[i];
  double size = std::sqrt(dotOf(rest, rest));
  if (size <= options.tolerance * scale) return result;
  std::vector<std::vector<double>> basis{rest};
  for (double& value : basis[0]) value /= size;
  std::vector<std::vector<double>> columns;  // upper triangular, after the rotations
  std::vector<double> cosines;
  std::vector<double> sines;
  std::vector<double> right{size};
  for (int step = 0; step < options.mostSteps; ++step) {
    std::vector<double> next(n);
    product(basis.back(), next);
    std::vector<double> column;
    for (const auto& earlier : basis) {
      const double along = dotOf(earlier, next);
      column.push_back(along);
      for (std::size_t i = 0; i < n; ++i) next[i] -= along * earlier[i];
    }
    const double left = std::sqrt(dotOf(next, next));
    for (std::size_t k = 0; k < cosines.size(); ++k) {
      const double upper = cosines[k] * column[k] + sines[k] * column[k + 1];
      column[k + 1] = -sines[k] * column[k] + cosines[k] * column[k + 1];
      column[k] = upper;
    }
    const double hypotenuse = std::hypot(column.back(), left);
    cosines.push_back(column.back() / hypotenuse);
    sines.push_back(left / hypotenuse);
    column.back() = hypotenuse;
    columns.push_back(column);
    right.push_back(-sines.back() * right.back());
    right[right.size() - 2] *= cosines.back();
    result.residuals.push_back(std::abs(right.back()) / scale);
    if (result.residuals.back() <= options.tolerance || left == 0) break;
    for (double& value : next) value /= left;
    basis.push_back(std::move(next));
  }
  std::vector<double> factors(columns.size());
  for (std::size_t k = columns.size(); k-- > 0;) {
    double value = right[k];
    for (std::size_t l = k + 1; l < columns.size(); ++l) value -= columns[l][k] * factors[l];
    factors[k] = value / columns[k][k];
  }
  for (std::size_t k = 0; k < factors.size(); ++k)
    for (std::size_t i = 0; i < n; ++i) result.solution[i] += factors[k] * basis[k][i];
  return result;
}

}  // namespace opaline::test::boundary
