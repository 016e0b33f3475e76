#include "environment/lat_long.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
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

Rgb radianceFrom(const Image& environment, const Vec3& direction) {
  const auto [u, v] = latLongCoordinates(direction);
  const double across = u * environment.width - 0.5;
  const double down = std::clamp(v * environment.height - 0.5, 0.0, environment.height - 1.0);
  const int left = static_cast<int>(std::floor(across));
  const int top = static_cast<int>(down);
  const auto pixel = [&](int x, int y) {
    return environment.pixel((x + environment.width) % environment.width,
                             std::min(y, environment.height - 1));
  };
  const double right = across - left;
  const double below = down - top;
  Rgb radiance{};
  for (std::size_t c = 0; c < 3; ++c)
    radiance[c] =
        static_cast<float>((1 - below) * std::lerp(double{pixel(left, top)[c]},
                                                   double{pixel(left + 1, top)[c]}, right) +
                           below * std::lerp(double{pixel(left, top + 1)[c]},
                                             double{pixel(left + 1, top + 1)[c]}, right));
  return radiance;
}

Vec3 latticeDirection(int index, int count) {
  const double z = 1.0 - (2.0 * index + 1.0) / count;
  const double azimuth = 2.0 * pi * index / std::numbers::phi;
  const double radius = std::sqrt(1.0 - z * z);
  return {static_cast<float>(radius * std::cos(azimuth)),
          static_cast<float>(radius * std::sin(azimuth)), static_cast<float>(z)};
}

}  // namespace opaline
