#include "environment/bright_directions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "environment/lat_long.h"

namespace opaline {

namespace {

constexpr double leastAbove = 0.05;  // least share of all light for which it is worthwhile

double sumOf(const Rgb& rgb) {
  return double{rgb[0]} + double{rgb[1]} + double{rgb[2]};
}

// A place within a part, by the low-discrepancy lattice of Roberts 2018.
Vec3 within(int column, int row, std::size_t i) {
  const auto at = [&](double step) { return std::fmod(0.5 + static_cast<double>(i) * step, 1.0); };
  return latLongDirection((column + at(0.7548776662466927)) / SkyParts::width,
                          (row + at(0.5698402909980532)) / SkyParts::height);
}

}  // namespace

BrightDirections brightDirectionsOf(const SkyParts& sky) {
  BrightDirections bright;
  double all = 0;
  for (const SkyParts::Part& part : sky.parts)
    all += double{part.solidAngle} * sumOf(part.radiance);
  const double mean = all / (4 * std::numbers::pi);
  const double ambient = sumOf(sky.ambient);
  const auto above = [&](const SkyParts::Part& part) {
    return double{part.solidAngle} * std::max(sumOf(part.radiance) - mean, 0.0);
  };
  double sum = 0;
  for (const SkyParts::Part& part : sky.parts) sum += above(part);
  bright.mean = static_cast<float>(mean + ambient);
  if (!(sum > leastAbove * (all + 4 * std::numbers::pi * ambient))) return bright;
  bright.above = static_cast<float>(sum);
  double soFar = 0;
  std::size_t next = 0;
  for (int row = 0; row < SkyParts::height; ++row)
    for (int k = 0; k < SkyParts::width; ++k) {
      // There and back, so that neighbours on the list are neighbours in the sky.
      const int column = row % 2 == 0 ? k : SkyParts::width - 1 - k;
      soFar += above(sky.parts[static_cast<std::size_t>(row * SkyParts::width + column)]);
      for (; next < bright.count && (static_cast<double>(next) + 0.5) / bright.count * sum < soFar;
           ++next)
        bright.towards[next] = within(column, row, next);
    }
  // Directions that rounding may have left out.
  for (; next > 0 && next < bright.count; ++next) bright.towards[next] = bright.towards[next - 1];
  return bright;
}

}  // namespace opaline
