#pragma once

#include <array>

#include "opaline/motion.h"
#include "scene/vector_math.h"

namespace opaline::scene {

/// An affine map: column-major 3 × 4. The last row of the 4 × 4 matrix would be 0 0 0 1.
struct Matrix4 {
  std::array<Double3, 4> column{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}};

  Double3 direction(const Double3& v) const {
    return v[0] * column[0] + v[1] * column[1] + v[2] * column[2];
  }
  Double3 point(const Double3& p) const { return direction(p) + column[3]; }
  /// Cofactors times the normal: the inverse transpose up to a positive factor.
  Double3 normal(const Double3& n) const {
    const Double3 mapped = n[0] * cross(column[1], column[2]) + n[1] * cross(column[2], column[0]) +
                           n[2] * cross(column[0], column[1]);
    return determinant() < 0 ? -1.0 * mapped : mapped;
  }
  double determinant() const { return dot(column[0], cross(column[1], column[2])); }
};

inline Matrix4 operator*(const Matrix4& a, const Matrix4& b) {
  return {{a.direction(b.column[0]), a.direction(b.column[1]), a.direction(b.column[2]),
           a.point(b.column[3])}};
}

inline Matrix4 matrixFrom(const Affine& affine) {
  Matrix4 result;
  for (std::size_t c = 0; c < 4; ++c) result.column[c] = toDouble(affine.columns[c]);
  return result;
}

inline Affine affineFrom(const Matrix4& matrix) {
  Affine result;
  for (std::size_t c = 0; c < 4; ++c) result.columns[c] = toFloat(matrix.column[c]);
  return result;
}

inline bool isFinite(const Affine& affine) {
  return isFinite(affine.columns[0]) && isFinite(affine.columns[1]) &&
         isFinite(affine.columns[2]) && isFinite(affine.columns[3]);
}

/// The sum of weighted maps that linear blend skinning moves a vertex by.
class MatrixSum {
 public:
  void add(double weight, const Matrix4& matrix) {
    for (std::size_t c = 0; c < 4; ++c) {
      sum_.column[c] = sum_.column[c] + weight * matrix.column[c];
    }
    weight_ += weight;
  }
  double weight() const { return weight_; }
  /// Their mean; requires a weight above 0.
  Matrix4 mean() const {
    Matrix4 result = sum_;
    for (Double3& column : result.column) column = (1 / weight_) * column;
    return result;
  }

 private:
  Matrix4 sum_{{Double3{}, Double3{}, Double3{}, Double3{}}};
  double weight_ = 0;
};

/// From 16 numbers, column by column.
template <typename Numbers>
Matrix4 matrixFromColumns(const Numbers& m) {
  Matrix4 result;
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::size_t r = 0; r < 3; ++r) result.column[c][r] = static_cast<double>(m[4 * c + r]);
  }
  return result;
}

/// Scale, then rotate by the quaternion x y z w of any length above 0, then translate.
inline Matrix4 matrixFromParts(const Double3& translation, const std::array<double, 4>& rotation,
                               const Double3& scale) {
  const auto [x, y, z, w] = rotation;
  const double norm = x * x + y * y + z * z + w * w;
  const double s = norm > 0 ? 2 / norm : 0;
  Matrix4 result;
  result.column[0] =
      scale[0] * Double3{1 - s * (y * y + z * z), s * (x * y + w * z), s * (x * z - w * y)};
  result.column[1] =
      scale[1] * Double3{s * (x * y - w * z), 1 - s * (x * x + z * z), s * (y * z + w * x)};
  result.column[2] =
      scale[2] * Double3{s * (x * z + w * y), s * (y * z - w * x), 1 - s * (x * x + y * y)};
  result.column[3] = translation;
  return result;
}

}  // namespace opaline::scene
