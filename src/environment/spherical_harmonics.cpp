#include "environment/spherical_harmonics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "bssrdf/fresnel.h"

namespace opaline {

namespace {

using std::numbers::pi;
constexpr std::array<std::size_t, 9> bandOf = {0, 1, 1, 1, 2, 2, 2, 2, 2};

/// Integrals over a solid angle of the monomials that the basis is made of.
struct Moments {
  double one;
  double x, y, z;
  double xy, yz, xz;
  double xx, yy, zz;
};

// Ramamoorthi and Hanrahan 2001, Eq. 3, with exact constants. Linear in the moments, so that those
// of a direction as well as those of a solid angle may be put in.
std::array<double, 9> basisFromMoments(const Moments& m) {
  const double y00 = 0.5 / std::sqrt(pi);
  const double y1 = std::sqrt(3.0 / (4.0 * pi));
  const double y2 = std::sqrt(15.0 / (4.0 * pi));
  const double y20 = std::sqrt(5.0 / (16.0 * pi));
  const double y22 = std::sqrt(15.0 / (16.0 * pi));
  return {y00 * m.one,
          y1 * m.y,
          y1 * m.z,
          y1 * m.x,
          y2 * m.xy,
          y2 * m.yz,
          y20 * (3.0 * m.zz - m.one),
          y2 * m.xz,
          y22 * (m.xx - m.yy)};
}

/// Σ over one row of pixels of radiance times the integrals over a pixel's φ of 1, sin φ, cos φ,
/// sin φ cos φ, sin² φ, cos² φ.
using RowSums = std::array<std::array<double, 3>, 6>;
using AzimuthIntegrals = std::array<double, 6>;

std::vector<AzimuthIntegrals> azimuthIntegrals(int width) {
  std::vector<AzimuthIntegrals> columns;
  for (int column = 0; column < width; ++column) {
    const double half = pi / width;
    const double centre = (2 * column + 1) * half - pi;
    // ∫ sin φ = 2 sin(φ_c) sin(half), and so on: without cancellation for narrow pixels.
    const double first = 2.0 * std::sin(half);
    const double second = std::sin(2.0 * half);
    const double cosTwice = std::cos(2.0 * centre);
    columns.push_back({2.0 * half, first * std::sin(centre), first * std::cos(centre),
                       0.5 * second * std::sin(2.0 * centre), half - 0.5 * second * cosTwice,
                       half + 0.5 * second * cosTwice});
  }
  return columns;
}

RowSums sumRow(const Image& image, int row, const std::vector<AzimuthIntegrals>& columns) {
  RowSums sums{};
  const float* pixel = image.pixel(0, row);
  for (const AzimuthIntegrals& column : columns) {
    for (std::size_t k = 0; k < sums.size(); ++k) {
      for (std::size_t c = 0; c < 3; ++c) sums[k][c] += column[k] * static_cast<double>(pixel[c]);
    }
    pixel += 4;
  }
  return sums;
}

/// ∫ over a row of sin^i θ cos^j θ · sin θ dθ.
struct PolarIntegrals {
  double one, cosine, cosineSquared, sine, sineCosine, sineSquared;
};

PolarIntegrals polarIntegrals(int row, int height) {
  const double half = 0.5 * pi / height;
  const double centre = (2 * row + 1) * half;
  const double one = 2.0 * std::sin(centre) * std::sin(half);
  const double cosine = 0.5 * std::sin(2.0 * centre) * std::sin(2.0 * half);
  // sin³ θ = (3 sin θ - sin 3θ)/4.
  const double sineTripled = 2.0 / 3.0 * std::sin(3.0 * centre) * std::sin(3.0 * half);
  const double sineSquared = (3.0 * one - sineTripled) / 4.0;
  // sin² θ cos θ = (cos θ - cos 3θ)/4.
  const double sineCosine = (2.0 * std::cos(centre) * std::sin(half) -
                             2.0 / 3.0 * std::cos(3.0 * centre) * std::sin(3.0 * half)) /
                            4.0;
  const double sine = half - 0.5 * std::cos(2.0 * centre) * std::sin(2.0 * half);
  return {one, cosine, one - sineSquared, sine, sineCosine, sineSquared};
}

/// x = sin θ sin φ, y = cos θ, z = -sin θ cos φ.
Moments rowMoments(const PolarIntegrals& polar, const RowSums& sums, std::size_t channel) {
  const auto [one, sine, cosine, sineCosine, sineSquared, cosineSquared] =
      std::array{sums[0][channel], sums[1][channel], sums[2][channel],
                 sums[3][channel], sums[4][channel], sums[5][channel]};
  Moments m{};
  m.one = polar.one * one;
  m.x = polar.sine * sine;
  m.y = polar.cosine * one;
  m.z = -polar.sine * cosine;
  m.xy = polar.sineCosine * sine;
  m.yz = -polar.sineCosine * cosine;
  m.xz = -polar.sineSquared * sineCosine;
  m.xx = polar.sineSquared * sineSquared;
  m.yy = polar.cosineSquared * one;
  m.zz = polar.sineSquared * cosineSquared;
  return m;
}

/// Irradiance towards one direction, apart for each band.
using BandIrradiance = std::array<std::array<double, 3>, 3>;

BandIrradiance bandIrradiance(const ShCoefficients& coefficients,
                              const std::array<double, 3>& kernel, const Vec3& normal) {
  const std::array<double, 9> basis = sphericalHarmonics(normal);
  BandIrradiance bands{};
  for (std::size_t i = 0; i < basis.size(); ++i) {
    const double factor = kernel[bandOf[i]] * basis[i];
    for (std::size_t c = 0; c < 3; ++c) bands[bandOf[i]][c] += factor * coefficients[i][c];
  }
  return bands;
}

/// Abel-Poisson window: the bands of an environment blurred with a positive kernel. Hence whatever
/// is non-negative stays so when `keep` falls, and it leaves a sun far more of its first two bands
/// than the Hanning, Lanczos and Laplacian windows of Sloan 2008 do.
double window(std::size_t band, double keep) {
  return std::pow(keep, static_cast<double>(band));
}

bool isNonNegative(const std::vector<BandIrradiance>& irradiances, double keep) {
  constexpr double rounding = 1e-12;
  const double first = window(1, keep);
  const double second = window(2, keep);
  return std::all_of(irradiances.begin(), irradiances.end(), [&](const BandIrradiance& bands) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double irradiance = bands[0][c] + first * bands[1][c] + second * bands[2][c];
      if (irradiance < -rounding * std::abs(bands[0][c])) return false;
    }
    return true;
  });
}

/// The largest `keep` that makes all irradiances non-negative.
double mostToKeep(const std::vector<BandIrradiance>& irradiances) {
  if (isNonNegative(irradiances, 1.0)) return 1.0;
  double safe = 0.0;
  double tooMuch = 1.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (safe + tooMuch);
    (isNonNegative(irradiances, middle) ? safe : tooMuch) = middle;
  }
  return safe;
}

}  // namespace

std::array<double, 9> sphericalHarmonics(const Vec3& direction) {
  const double x = static_cast<double>(direction[0]);
  const double y = static_cast<double>(direction[1]);
  const double z = static_cast<double>(direction[2]);
  return basisFromMoments({1.0, x, y, z, x * y, y * z, x * z, x * x, y * y, z * z});
}

ShCoefficients projectEnvironment(const Image& latLong) {
  ShCoefficients coefficients{};
  const std::vector<AzimuthIntegrals> columns = azimuthIntegrals(latLong.width);
  for (int row = 0; row < latLong.height && latLong.width > 0; ++row) {
    const RowSums sums = sumRow(latLong, row, columns);
    const PolarIntegrals polar = polarIntegrals(row, latLong.height);
    for (std::size_t c = 0; c < 3; ++c) {
      const std::array<double, 9> basis = basisFromMoments(rowMoments(polar, sums, c));
      for (std::size_t i = 0; i < basis.size(); ++i) coefficients[i][c] += basis[i];
    }
  }
  return coefficients;
}

ShCoefficients projectUniform(const Rgb& radiance) {
  ShCoefficients coefficients{};
  for (std::size_t c = 0; c < 3; ++c) {
    coefficients[0][c] = 2.0 * std::sqrt(pi) * static_cast<double>(radiance[c]);
  }
  return coefficients;
}

Vec3 latticeDirection(int index, int count) {
  const double z = 1.0 - (2.0 * index + 1.0) / count;
  const double azimuth = 2.0 * pi * index / std::numbers::phi;
  const double radius = std::sqrt(1.0 - z * z);
  return {static_cast<float>(radius * std::cos(azimuth)),
          static_cast<float>(radius * std::sin(azimuth)), static_cast<float>(z)};
}

Vec3 latLongDirection(double u, double v) {
  const double polar = pi * v;
  const double azimuth = 2.0 * pi * (u - 0.5);
  return {static_cast<float>(std::sin(polar) * std::sin(azimuth)),
          static_cast<float>(std::cos(polar)),
          static_cast<float>(-std::sin(polar) * std::cos(azimuth))};
}

std::array<double, 2> latLongCoordinates(const Vec3& direction) {
  const double x = static_cast<double>(direction[0]);
  const double y = static_cast<double>(direction[1]);
  const double z = static_cast<double>(direction[2]);
  return {0.5 + std::atan2(x, -z) / (2.0 * pi), std::atan2(std::hypot(x, z), y) / pi};
}

std::array<double, 3> irradianceKernel(double eta) {
  // Simpson's rule. Towards η = 1 reflectance narrows to a peak at grazing angles, so μ = s².
  constexpr int intervals = 2048;
  std::array<double, 3> kernel{};
  for (int i = 0; i <= intervals; ++i) {
    const double s = static_cast<double>(i) / intervals;
    const double mu = s * s;
    const double weight = i == 0 || i == intervals ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
    const double common = weight * (1.0 - bssrdf::fresnelReflectance(eta, mu)) * mu * 2.0 * s;
    kernel[0] += common;
    kernel[1] += common * mu;
    kernel[2] += common * 0.5 * (3.0 * mu * mu - 1.0);
  }
  for (double& coefficient : kernel) coefficient *= 2.0 * pi / (3.0 * intervals);
  return kernel;
}

ShCoefficients windowed(const ShCoefficients& coefficients, const std::array<double, 3>& kernel) {
  constexpr int directions = 2048;
  std::vector<BandIrradiance> irradiances;
  irradiances.reserve(directions);
  for (int i = 0; i < directions; ++i) {
    irradiances.push_back(bandIrradiance(coefficients, kernel, latticeDirection(i, directions)));
  }
  const double keep = mostToKeep(irradiances);
  if (keep == 1.0) return coefficients;
  ShCoefficients result = coefficients;
  for (std::size_t i = 1; i < result.size(); ++i) {
    for (double& value : result[i]) value *= window(bandOf[i], keep);
  }
  return result;
}

std::array<double, 3> ambientIrradiance(const ShCoefficients& coefficients,
                                        const std::array<double, 3>& kernel, const Vec3& normal) {
  const BandIrradiance bands = bandIrradiance(coefficients, kernel, normal);
  std::array<double, 3> irradiance{};
  for (std::size_t c = 0; c < 3; ++c) {
    irradiance[c] = std::max(0.0, bands[0][c] + bands[1][c] + bands[2][c]);
  }
  return irradiance;
}

}  // namespace opaline
