#include "reference/irradiance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "bssrdf/fresnel.h"
#include "environment/lat_long.h"
#include "environment/sky.h"
#include "environment/suns.h"
#include "lights/area.h"

namespace opaline::reference {

namespace {

// Rays over the whole sphere. Each casts a shadow, and the borders of neighbouring shadows are a
// degree or two apart.
constexpr int skyRays = 1024;

/// Light that arrives at a point: the direction it comes from, how far, and the irradiance on a
/// surface that faces it.
struct Arriving {
  Vector direction;
  double distanceMm;
  double falloff;
};

template <typename Light>
Arriving arrivingFrom(const Light& light, const Vector& position) {
  if (!light.isPoint) return {light.place, std::numeric_limits<double>::infinity(), 1};
  const Vector offset = light.place - position;
  const double squared = std::max(dot(offset, offset), 1e-12);
  const double distance = std::sqrt(squared);
  const Vector direction = (1 / distance) * offset;
  return {direction, distance, light.falloff(-dot(direction, light.axis)) / squared};
}

/// The part of a light's irradiance that enters a surface, per irradiance of a surface facing the
/// light. An index of refraction of 0 stands for an opaque surface.
double entering(double eta, double cosine) {
  return eta > 0 ? cosine * (1 - bssrdf::fresnelReflectance(eta, cosine)) : cosine;
}

/// A lattice of low discrepancy over the light (Roberts 2018).
constexpr int placesOnLight = 256;

AreaPoint placeOnLight(const AreaLight& light, int i) {
  const auto part = [&](double step) { return std::fmod((i + 0.5) * step, 1.0); };
  return pointOn(light, (i + 0.5) / placesOnLight, part(0.6180339887498949));
}

}  // namespace

Irradiance::Irradiance(const Geometry& geometry, Sky sky) : geometry_(geometry), sky_(sky) {
  Lighting lighting = geometry.scene().lighting;
  separate(findSuns(lighting.environment), lighting);
  for (const DirectionalLight& light : lighting.directional) {
    lights_.push_back(
        {false, unitOr(toVector(light.directionToLight), {0, 0, 1}), toColour(light.irradiance)});
  }
  for (const PointLight& light : lighting.points) {
    lights_.push_back({true, toVector(light.positionMm), toColour(light.intensity)});
  }
  for (const SpotLight& light : lighting.spots) {
    lights_.push_back({true, toVector(light.positionMm), toColour(light.intensity),
                       unitOr(toVector(light.direction), {0, 0, -1}), falloffOf(light)});
  }
  areas_ = lighting.areas;
  const SkyParts parts = partsOfSky(lighting);
  const std::vector<Body>& bodies = geometry.scene().bodies;
  const bool shadowed =
      sky == Sky::Shadowed || std::any_of(bodies.begin(), bodies.end(),
                                          [](const Body& body) { return body.opaque.has_value(); });
  for (int i = 0; shadowed && !skyIsDark(lighting) && i < skyRays; ++i) {
    const Vec3 direction = latticeDirection(i, skyRays);
    skyRays_.push_back(
        {unitOr(toVector(direction), {0, 0, 1}), toColour(parts.radianceAt(direction))});
  }
  for (const Body& body : bodies) {
    const double eta = body.opaque ? 0 : body.medium.eta;
    auto found = std::find_if(ambients_.begin(), ambients_.end(),
                              [&](const Ambient& ambient) { return ambient.eta == eta; });
    if (found == ambients_.end())
      found = ambients_.insert(found, {eta, SkyTable(eta > 0 ? SkyIrradiance::entering(parts, eta)
                                                             : SkyIrradiance::arriving(parts))});
    ambientOf_.push_back(static_cast<std::size_t>(found - ambients_.begin()));
  }
}

// The light of the whole sky, times what unobstructed rays carry of the light of all rays.
Colour Irradiance::skyAt(const SurfacePoint& point, const Vector& outside) const {
  const Ambient& ambient = ambients_[ambientOf_[point.body]];
  Colour sky = ambient.sky.at(point.shadingNormal);
  if (skyRays_.empty() || (sky_ == Sky::Unshadowed && ambient.eta > 0)) return sky;
  Colour free{};
  Colour all{};
  for (const SkyRay& ray : skyRays_) {
    const double cosine = std::min(dot(point.shadingNormal, ray.direction), 1.0);
    if (cosine <= 0) continue;
    const double part = entering(ambient.eta, cosine);
    const bool hidden =
        dot(outside, ray.direction) <= 0 ||
        geometry_.occluded(point, ray.direction, std::numeric_limits<double>::infinity());
    for (std::size_t c = 0; c < 3; ++c) {
      all[c] += part * ray.radiance[c];
      if (!hidden) free[c] += part * ray.radiance[c];
    }
  }
  for (std::size_t c = 0; c < 3; ++c) sky[c] *= all[c] > 0 ? free[c] / all[c] : 0;
  return sky;
}

Colour Irradiance::operator()(const SurfacePoint& point) const {
  const Ambient& ambient = ambients_[ambientOf_[point.body]];
  // The outside is the side of the facet on which the interpolated normal lies.
  const Vector outside =
      dot(point.facetNormal, point.shadingNormal) < 0 ? -point.facetNormal : point.facetNormal;
  Colour sum = skyAt(point, outside);
  for (const Light& light : lights_) {
    const Arriving arriving = arrivingFrom(light, point.position);
    const double cosine = std::min(dot(point.shadingNormal, arriving.direction), 1.0);
    // Light from behind the facet is blocked by the body itself.
    if (cosine <= 0 || dot(outside, arriving.direction) <= 0 || arriving.falloff <= 0) continue;
    if (geometry_.occluded(point, arriving.direction, arriving.distanceMm)) continue;
    const double part = entering(ambient.eta, cosine) * arriving.falloff;
    for (std::size_t c = 0; c < 3; ++c) sum[c] += light.power[c] * part;
  }
  for (const AreaLight& light : areas_) {
    sum += fromArea(light, point, outside, ambient.eta);
  }
  return sum;
}

Colour Irradiance::fromArea(const AreaLight& light, const SurfacePoint& point,
                            const Vector& outside, double eta) const {
  double sum = 0;
  for (int i = 0; i < placesOnLight; ++i) {
    const AreaPoint place = placeOnLight(light, i);
    const Vector offset = place.positionMm - point.position;
    const double squared = std::max(dot(offset, offset), 1e-12);
    const double distance = std::sqrt(squared);
    const Vector direction = (1 / distance) * offset;
    const double facing =
        isTwoSided(light) ? std::abs(dot(place.normal, direction)) : -dot(place.normal, direction);
    const double cosine = std::min(dot(point.shadingNormal, direction), 1.0);
    if (facing <= 0 || cosine <= 0 || dot(outside, direction) <= 0) continue;
    if (geometry_.occluded(point, direction, distance)) continue;
    sum += facing * entering(eta, cosine) / squared;
  }
  const Colour radiance = toColour(radianceOf(light));
  const double part = sum * areaMm2(light) / placesOnLight;
  return {radiance[0] * part, radiance[1] * part, radiance[2] * part};
}

Colour Irradiance::facing(const SurfacePoint& point) const {
  const Ambient& ambient = ambients_[ambientOf_[point.body]];
  Colour sum = ambient.sky.at(point.shadingNormal);
  for (const Light& light : lights_) {
    const Arriving arriving = arrivingFrom(light, point.position);
    for (std::size_t c = 0; c < 3; ++c) sum[c] += light.power[c] * arriving.falloff;
  }
  for (const AreaLight& light : areas_) {
    const double away = std::max(length(middleOf(light) - point.position) - reachMm(light), 1e-6);
    const double solidAngle = std::min(areaMm2(light) / (away * away), std::numbers::pi);
    const Colour radiance = toColour(radianceOf(light));
    for (std::size_t c = 0; c < 3; ++c) sum[c] += radiance[c] * solidAngle;
  }
  return sum;
}

}  // namespace opaline::reference
