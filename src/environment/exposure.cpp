#include "opaline/exposure.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <vector>

#include "environment/lat_long.h"
#include "environment/sky_irradiance.h"
#include "lights/area.h"
#include "lights/spot.h"
#include "opaline/error.h"

namespace opaline {

namespace {

using std::numbers::pi;

// The range of the radiance of white for which the exposure stays 0. Most pictures of translucent
// things are lit from behind and show little of the brightest side, so that side may be brighter
// than white.
constexpr double darkest = 0.25;
constexpr double brightest = 2.5;
constexpr double mostStops = 32;

struct Beam {
  Vec3 toLight;  // unit
  std::array<double, 3> irradiance;
};

double dot(const Vec3& a, const Vec3& b) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += double{a[i]} * double{b[i]};
  return sum;
}

Beam beamOf(const PointLight& light, const Vec3& middle, double leastDistanceMm) {
  std::array<double, 3> offset{};
  for (std::size_t i = 0; i < 3; ++i) offset[i] = double{light.positionMm[i]} - double{middle[i]};
  const double distanceMm = std::hypot(offset[0], offset[1], offset[2]);
  const double square = std::pow(std::max(distanceMm, leastDistanceMm), 2);
  Beam beam{{0, 1, 0}, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    if (distanceMm > 0) beam.toLight[i] = static_cast<float>(offset[i] / distanceMm);
    if (square > 0) beam.irradiance[i] = double{light.intensity[i]} / square;
  }
  return beam;
}

Beam beamOf(const SpotLight& light, const Vec3& middle, double leastDistanceMm) {
  Beam beam = beamOf(PointLight{light.positionMm, light.intensity}, middle, leastDistanceMm);
  const double cosine =
      -dot(beam.toLight, light.direction) / std::sqrt(dot(light.direction, light.direction));
  for (double& channel : beam.irradiance) channel *= falloffOf(light)(cosine);
  return beam;
}

// By places spread evenly over the light.
Beam beamOf(const AreaLight& light, const Vec3& middle, double leastDistanceMm) {
  constexpr int steps = 24;
  std::array<double, 3> sum{};
  for (int i = 0; i < steps * steps; ++i) {
    const int row = i / steps;
    const AreaPoint place = pointOn(light, (i % steps + 0.5) / steps, (row + 0.5) / steps);
    std::array<double, 3> offset{};
    for (std::size_t k = 0; k < 3; ++k) offset[k] = place.positionMm[k] - double{middle[k]};
    const double distance = std::hypot(offset[0], offset[1], offset[2]);
    if (!(distance > 0)) continue;
    double facing = 0;
    for (std::size_t k = 0; k < 3; ++k) facing -= place.normal[k] * offset[k] / distance;
    if (isTwoSided(light)) facing = std::abs(facing);
    const double square = std::pow(std::max(distance, leastDistanceMm), 2);
    for (std::size_t k = 0; k < 3; ++k)
      sum[k] += std::max(facing, 0.0) / square * offset[k] / distance;
  }
  const double part = std::hypot(sum[0], sum[1], sum[2]);
  Beam beam{{0, 1, 0}, {}};
  if (!(part > 0)) return beam;
  for (std::size_t k = 0; k < 3; ++k) {
    beam.toLight[k] = static_cast<float>(sum[k] / part);
    beam.irradiance[k] = double{radianceOf(light)[k]} * areaMm2(light) * part / (steps * steps);
  }
  return beam;
}

std::vector<Beam> beamsOf(const Scene& scene) {
  const Vec3 middle = middleOf(boundsOf(scene));
  const double leastDistanceMm = 0.5 * double{diagonalMm(scene)};
  std::vector<Beam> beams;
  for (const DirectionalLight& light : scene.lighting.directional) {
    const Rgb& irradiance = light.irradiance;
    beams.push_back({light.directionToLight,
                     {double{irradiance[0]}, double{irradiance[1]}, double{irradiance[2]}}});
  }
  for (const PointLight& light : scene.lighting.points)
    beams.push_back(beamOf(light, middle, leastDistanceMm));
  for (const SpotLight& light : scene.lighting.spots)
    beams.push_back(beamOf(light, middle, leastDistanceMm));
  for (const AreaLight& light : scene.lighting.areas)
    beams.push_back(beamOf(light, middle, leastDistanceMm));
  return beams;
}

double radianceOfWhite(const std::vector<Beam>& beams, const SkyIrradiance& sky,
                       const Vec3& normal) {
  std::array<double, 3> irradiance = sky.at(normal);
  for (const Beam& beam : beams) {
    const double cosine = std::max(0.0, dot(beam.toLight, normal));
    for (std::size_t c = 0; c < 3; ++c) irradiance[c] += cosine * beam.irradiance[c];
  }
  return *std::max_element(irradiance.begin(), irradiance.end()) / pi;
}

double brightestWhite(const Scene& scene) {
  constexpr int directions = 1024;
  const std::vector<Beam> beams = beamsOf(scene);
  const SkyIrradiance sky = SkyIrradiance::arriving(partsOfSky(scene.lighting));
  double most = 0;
  for (int i = 0; i < directions; ++i)
    most = std::max(most, radianceOfWhite(beams, sky, latticeDirection(i, directions)));
  for (const Beam& beam : beams) most = std::max(most, radianceOfWhite(beams, sky, beam.toLight));
  return most;
}

}  // namespace

float automaticExposureStops(const Scene& scene) {
  const std::shared_ptr<const Image>& environment = scene.lighting.environment;
  if (environment && !isSound(*environment)) throw Error(complaintAboutEnvironment(*environment));
  const double white = brightestWhite(scene);
  if (!(white > 0)) return 0;
  const double stops = std::log2(std::clamp(white, darkest, brightest) / white);
  return static_cast<float>(std::round(100 * std::clamp(stops, -mostStops, mostStops)) / 100);
}

}  // namespace opaline
