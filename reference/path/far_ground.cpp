#include "reference/path/far_ground.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "environment/sky_irradiance.h"
#include "lights/area.h"
#include "lights/spot.h"
#include "reference/opaque_surface.h"

namespace opaline::reference {

namespace {

using std::numbers::pi;

constexpr Vector up{0, 1, 0};

// A light counts as far from this many radii on.
constexpr double farLight = 2;

}  // namespace

FarGround::FarGround(const Geometry& geometry, std::uint32_t ground, std::size_t channel,
                     double nearMm)
    : geometry_(geometry),
      ground_(ground),
      channel_(channel),
      centre_(geometry.box().centre()),
      nearMm_(nearMm) {
  const Body& body = geometry.scene().bodies[ground];
  heightMm_ = body.positionsMm.front()[1];
  const SurfacePoint point = geometry.pointOn(ground, 0, {1, 0, 0});
  givenBack_ = mattShare(opaqueSurfaceAt(body, point), channel) / pi;
  const Lighting& lighting = geometry.scene().lighting;
  sky_ = SkyIrradiance::arriving(partsOfSky(lighting)).at(toFloat(up))[channel];
  mostIrradiance_ = sky_;
  for (const DirectionalLight& light : lighting.directional)
    mostIrradiance_ += double{light.irradiance[channel]} *
                       std::max(dot(unitOr(toVector(light.directionToLight), up), up), 0.0);
  const auto addPoint = [&](const Vector& position, double intensity) {
    const double above = position[1] - heightMm_;
    if (counts(position)) mostIrradiance_ += intensity / (above * above);
  };
  for (const PointLight& light : lighting.points)
    addPoint(toVector(light.positionMm), double{light.intensity[channel]});
  for (const SpotLight& light : lighting.spots)
    addPoint(toVector(light.positionMm), double{light.intensity[channel]});
  for (const AreaLight& light : lighting.areas) {
    const double above = middleOf(light)[1] - reachMm(light) - heightMm_;
    if (counts(middleOf(light), reachMm(light)))
      mostIrradiance_ += double{radianceOf(light)[channel]} * areaMm2(light) / (above * above);
  }
}

// Nor may it be near the plane, where it would light some places far more than others.
bool FarGround::counts(const Vector& positionMm, double reachMm) const {
  return length(positionMm - centre_) - reachMm > farLight * nearMm_ &&
         positionMm[1] - reachMm - heightMm_ > nearMm_;
}

bool FarGround::isFar(const Vector& place) const {
  const Vector offset = place - centre_;
  return dot(offset, offset) > nearMm_ * nearMm_;
}

// An endless plane hides everything on its other side.
bool FarGround::hides(const Vector& place, const Vector& direction) const {
  return (place[1] - heightMm_) * direction[1] > 0;
}

double FarGround::distanceAlong(const Vector& origin, const Vector& direction) const {
  constexpr double never = std::numeric_limits<double>::infinity();
  const double above = origin[1] - heightMm_;
  if (!(direction[1] < 0) || above < 0) return never;
  const double distance = above / -direction[1];
  return isFar(origin + distance * direction) ? distance : never;
}

double FarGround::irradianceAt(const SurfacePoint& point, Random& random) const {
  const Lighting& lighting = geometry_.scene().lighting;
  double sum = sky_;
  const auto add = [&](const Vector& direction, double distanceMm, double irradiance) {
    if (direction[1] > 0 && irradiance > 0 && !geometry_.occluded(point, direction, distanceMm))
      sum += direction[1] * irradiance;
  };
  for (const DirectionalLight& light : lighting.directional)
    add(unitOr(toVector(light.directionToLight), up), std::numeric_limits<double>::infinity(),
        double{light.irradiance[channel_]});
  const auto addPoint = [&](const Vector& position, double intensity, const auto& falloff) {
    if (!counts(position)) return;
    const Vector offset = position - point.position;
    const double distance = length(offset);
    const Vector direction = (1 / distance) * offset;
    add(direction, distance, intensity * falloff(-direction) / (distance * distance));
  };
  for (const PointLight& light : lighting.points)
    addPoint(toVector(light.positionMm), double{light.intensity[channel_]},
             [](const Vector&) { return 1.0; });
  for (const SpotLight& light : lighting.spots)
    addPoint(toVector(light.positionMm), double{light.intensity[channel_]},
             [&](const Vector& away) {
               return falloffOf(light)(dot(away, unitOr(toVector(light.direction), -up)));
             });
  for (const AreaLight& light : lighting.areas) {
    if (!counts(middleOf(light), reachMm(light))) continue;
    const double x = random();
    const AreaPoint place = pointOn(light, x, random());
    const Vector offset = place.positionMm - point.position;
    const double distance = length(offset);
    const Vector direction = (1 / distance) * offset;
    const double facing = -dot(place.normal, direction);
    const double cosine = isTwoSided(light) ? std::abs(facing) : std::max(facing, 0.0);
    add(direction, distance,
        double{radianceOf(light)[channel_]} * areaMm2(light) * cosine / (distance * distance));
  }
  return sum;
}

double FarGround::radianceThrough(const Vector& place, const Vector& direction,
                                  Random& random) const {
  const double distance = distanceAlong(place, -direction);
  if (std::isinf(distance)) return 0;
  SurfacePoint point;
  point.position = place - distance * direction;
  point.facetNormal = point.shadingNormal = up;
  point.body = ground_;
  point.triangle = static_cast<std::uint32_t>(geometry_.scene().bodies[ground_].triangles.size());
  return givenBack_ * irradianceAt(point, random);
}

}  // namespace opaline::reference
