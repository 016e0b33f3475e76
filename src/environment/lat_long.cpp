#include "environment/lat_long.h"

#include <cmath>
#include <numbers>

namespace opaline {

using std::numbers::pi;

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

Vec3 latticeDirection(int index, int count) {
  const double z = 1.0 - (2.0 * index + 1.0) / count;
  const double azimuth = 2.0 * pi * index / std::numbers::phi;
  const double radius = std::sqrt(1.0 - z * z);
  return {static_cast<float>(radius * std::cos(azimuth)),
          static_cast<float>(radius * std::sin(azimuth)), static_cast<float>(z)};
}

}  // namespace opaline
