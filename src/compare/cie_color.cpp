#include "compare/cie_color.h"

#include <cmath>
#include <cstddef>

namespace opaline::compare {

namespace {

using Matrix = std::array<Triple, 3>;

Triple product(const Matrix& m, const Triple& v) {
  Triple result{};
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  }
  return result;
}

Matrix inverse(const Matrix& m) {
  Matrix result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t r = (j + 1) % 3;
      const std::size_t s = (j + 2) % 3;
      const std::size_t p = (i + 1) % 3;
      const std::size_t q = (i + 2) % 3;
      result[i][j] = m[r][p] * m[s][q] - m[r][q] * m[s][p];
    }
  }
  const double determinant =
      m[0][0] * result[0][0] + m[0][1] * result[1][0] + m[0][2] * result[2][0];
  for (Triple& row : result) {
    for (double& value : row) value /= determinant;
  }
  return result;
}

/// X, Y and Z of a chromaticity at luminance 1.
Triple xyzAt(double x, double y) {
  return {x / y, 1, (1 - x - y) / y};
}

/// From the chromaticities of IEC 61966-2-1: primaries, and D65 as white.
Matrix makeRelativeXyzFromRgb() {
  const Triple white = xyzAt(0.3127, 0.3290);
  const Triple red = xyzAt(0.64, 0.33);
  const Triple green = xyzAt(0.30, 0.60);
  const Triple blue = xyzAt(0.15, 0.06);
  Matrix result{};
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = {red[i] / white[i], green[i] / white[i], blue[i] / white[i]};
  }
  const Triple scale = product(inverse(result), {1, 1, 1});
  for (Triple& row : result) {
    for (std::size_t j = 0; j < 3; ++j) row[j] *= scale[j];
  }
  return result;
}

const Matrix relativeXyzFromRgb = makeRelativeXyzFromRgb();
const Matrix rgbFromRelativeXyz = inverse(relativeXyzFromRgb);

// CIE 15:2004, 8.2.1: a cube root, replaced by a line near zero.
constexpr double knee = 6.0 / 29;

double compressed(double t) {
  return t > knee * knee * knee ? std::cbrt(t) : t / (3 * knee * knee) + 4.0 / 29;
}

double expanded(double f) {
  return f > knee ? f * f * f : 3 * knee * knee * (f - 4.0 / 29);
}

}  // namespace

Triple relativeXyz(const Triple& linearRgb) {
  return product(relativeXyzFromRgb, linearRgb);
}

Triple linearRgbFromRelativeXyz(const Triple& xyz) {
  return product(rgbFromRelativeXyz, xyz);
}

Triple lab(const Triple& linearRgb) {
  const Triple xyz = relativeXyz(linearRgb);
  const double y = compressed(xyz[1]);
  return {116 * y - 16, 500 * (compressed(xyz[0]) - y), 200 * (y - compressed(xyz[2]))};
}

Triple linearRgbFromLab(const Triple& lab) {
  const double y = (lab[0] + 16) / 116;
  return linearRgbFromRelativeXyz(
      {expanded(y + lab[1] / 500), expanded(y), expanded(y - lab[2] / 200)});
}

}  // namespace opaline::compare
