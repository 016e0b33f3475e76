#include "reference/path/light_samples.h"

#include <algorithm>
#include <cmath>

#include "lights/area.h"

namespace opaline::reference {

namespace {

constexpr double everywhere = std::numeric_limits<double>::infinity();

/// The direction to a place, and its squared distance.
LightSample towards(const Vector& place, const Vector& positionMm, double& squared) {
  const Vector offset = place - positionMm;
  squared = std::max(dot(offset, offset), 1e-12);
  LightSample sample;
  sample.distanceMm = std::sqrt(squared);
  sample.direction = (1 / sample.distanceMm) * offset;
  return sample;
}

// The cosine at which an area light faces the point from which it is seen.
double facing(const AreaLight& light, const Vector& normal, const Vector& toLight) {
  const double cosine = -dot(normal, toLight);
  return isTwoSided(light) ? std::abs(cosine) : std::max(cosine, 0.0);
}

}  // namespace

LightSamples::LightSamples(const Scene& scene) : lighting_(scene.lighting) {
  if (lighting_.environment) environment_.emplace(*lighting_.environment, Colour{1, 1, 1});
}

std::optional<LightSample> LightSamples::ofArea(const AreaLight& light, const Vector& positionMm,
                                                Random& random) const {
  const double x = random();
  const AreaPoint place = pointOn(light, x, random());
  double squared = 0;
  LightSample sample = towards(place.positionMm, positionMm, squared);
  const double cosine = facing(light, place.normal, sample.direction);
  if (cosine <= 0) return std::nullopt;
  sample.density = squared / (cosine * areaMm2(light));
  sample.irradiance = (1 / sample.density) * toColour(radianceOf(light));
  return sample;
}

void LightSamples::forEach(const Vector& positionMm, Random& random,
                           const std::function<void(const LightSample&)>& take) const {
  double squared = 1;
  for (const DirectionalLight& light : lighting_.directional)
    take({unitOr(toVector(light.directionToLight), {0, 0, 1}), everywhere,
          toColour(light.irradiance), 0});
  for (const PointLight& light : lighting_.points) {
    LightSample sample = towards(toVector(light.positionMm), positionMm, squared);
    sample.irradiance = (1 / squared) * toColour(light.intensity);
    take(sample);
  }
  for (const SpotLight& light : lighting_.spots) {
    LightSample sample = towards(toVector(light.positionMm), positionMm, squared);
    const Vector axis = unitOr(toVector(light.direction), {0, 0, -1});
    const double part = falloffOf(light)(-dot(sample.direction, axis));
    sample.irradiance = (part / squared) * toColour(light.intensity);
    if (part > 0) take(sample);
  }
  for (const AreaLight& light : lighting_.areas)
    if (const auto sample = ofArea(light, positionMm, random)) take(*sample);
  if (!environment_ || !(environment_->sum() > 0)) return;
  LightSample sample{environment_->direction(random), everywhere, {}, 0, true};
  sample.density = environment_->density(sample.direction);
  if (!(sample.density > 0)) return;
  sample.irradiance = (1 / sample.density) * environment_->radiance(sample.direction);
  take(sample);
}

void LightSamples::forEachAlong(const Vector& originMm, const Vector& direction, double distanceMm,
                                const std::function<void(const LightAlong&)>& take) const {
  for (const AreaLight& light : lighting_.areas) {
    const auto distance = distanceAlong(originMm, direction, light);
    if (!distance || *distance >= distanceMm) continue;
    const Vector normal = normalAt(light, originMm + *distance * direction);
    const double cosine = std::max(facing(light, normal, direction), 1e-9);
    take({toColour(radianceOf(light)), *distance * *distance / (cosine * areaMm2(light))});
  }
  if (distanceMm < everywhere) return;
  take({toColour(lighting_.ambient), 0, true});
  if (environment_)
    take({environment_->radiance(direction), environment_->density(direction), true});
}

}  // namespace opaline::reference
