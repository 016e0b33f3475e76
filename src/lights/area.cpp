#include "lights/area.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "lights/vectors.h"

namespace opaline {

namespace {

using std::numbers::pi;
using namespace lights;

Double3 toDouble(const Vec3& v) {
  return {double{v[0]}, double{v[1]}, double{v[2]}};
}

/// Two unit directions perpendicular to a unit direction and to each other (Duff et al. 2017).
std::array<Double3, 2> across(const Double3& n) {
  const double sign = std::copysign(1.0, n[2]);
  const double a = -1 / (sign + n[2]);
  const double b = n[0] * n[1] * a;
  return {Double3{1 + sign * n[0] * n[0] * a, sign * b, -sign * n[0]},
          Double3{b, sign + n[1] * n[1] * a, -n[1]}};
}

Double3 onCircle(const std::array<Double3, 2>& axes, double part) {
  return std::cos(2 * pi * part) * axes[0] + std::sin(2 * pi * part) * axes[1];
}

double areaOf(const RectangleLight& light) {
  return 4 * length(cross(toDouble(light.uMm), toDouble(light.vMm)));
}

double areaOf(const DiscLight& light) {
  return pi * double{light.radiusMm} * double{light.radiusMm};
}

double areaOf(const SphereLight& light) {
  return 4 * pi * double{light.radiusMm} * double{light.radiusMm};
}

double areaOf(const TubeLight& light) {
  return 2 * pi * double{light.radiusMm} * length(toDouble(light.toMm) - toDouble(light.fromMm));
}

AreaPoint pointOf(const RectangleLight& light, double x, double y) {
  const Double3 u = toDouble(light.uMm);
  const Double3 v = toDouble(light.vMm);
  return {toDouble(light.centreMm) + (2 * x - 1) * u + (2 * y - 1) * v, unit(cross(u, v))};
}

AreaPoint pointOf(const DiscLight& light, double x, double y) {
  const Double3 normal = unit(toDouble(light.normal));
  const double radius = double{light.radiusMm} * std::sqrt(x);
  return {toDouble(light.centreMm) + radius * onCircle(across(normal), y), normal};
}

AreaPoint pointOf(const SphereLight& light, double x, double y) {
  const double z = 2 * x - 1;
  const Double3 around = onCircle(across({0, 0, 1}), y);
  const Double3 normal = std::sqrt(std::max(1 - z * z, 0.0)) * around + Double3{0, 0, z};
  return {toDouble(light.centreMm) + double{light.radiusMm} * normal, normal};
}

AreaPoint pointOf(const TubeLight& light, double x, double y) {
  const Double3 from = toDouble(light.fromMm);
  const Double3 along = toDouble(light.toMm) - from;
  const Double3 normal = onCircle(across(unit(along)), y);
  return {from + x * along + double{light.radiusMm} * normal, normal};
}

Double3 normalOf(const RectangleLight& light, const Double3& /*place*/) {
  return unit(cross(toDouble(light.uMm), toDouble(light.vMm)));
}

Double3 normalOf(const DiscLight& light, const Double3& /*place*/) {
  return unit(toDouble(light.normal));
}

Double3 normalOf(const SphereLight& light, const Double3& place) {
  return unit(place - toDouble(light.centreMm));
}

Double3 normalOf(const TubeLight& light, const Double3& place) {
  const Double3 from = toDouble(light.fromMm);
  const Double3 along = unit(toDouble(light.toMm) - from);
  const Double3 offset = place - from;
  return unit(offset - dot(offset, along) * along);
}

Double3 centreOf(const TubeLight& light) {
  return 0.5 * (toDouble(light.fromMm) + toDouble(light.toMm));
}

template <typename Light>
Double3 centreOf(const Light& light) {
  return toDouble(light.centreMm);
}

double reachOf(const RectangleLight& light) {
  const Double3 u = toDouble(light.uMm);
  const Double3 v = toDouble(light.vMm);
  return std::max(length(u + v), length(u - v));
}

double reachOf(const TubeLight& light) {
  const double half = 0.5 * length(toDouble(light.toMm) - toDouble(light.fromMm));
  return std::hypot(half, double{light.radiusMm});
}

template <typename Light>
double reachOf(const Light& light) {
  return double{light.radiusMm};
}

/// The distance to the side of a plane that shines, and the offset of the hit point from its
/// middle.
struct OnPlane {
  double distance;
  Double3 offset;
};

std::optional<OnPlane> onPlane(const Double3& centre, const Double3& normal, bool twoSided,
                               const Double3& from, const Double3& direction) {
  const double facing = -dot(normal, direction);
  const double distance = dot(normal, centre - from) / -facing;
  if (facing == 0 || (facing < 0 && !twoSided) || !(distance > 0)) return std::nullopt;
  return OnPlane{distance, from + distance * direction - centre};
}

std::optional<double> distanceTo(const RectangleLight& light, const Double3& from,
                                 const Double3& direction) {
  const Double3 u = toDouble(light.uMm);
  const Double3 v = toDouble(light.vMm);
  const Double3 normal = cross(u, v);
  const auto met = onPlane(toDouble(light.centreMm), normal, light.twoSided, from, direction);
  if (!met) return std::nullopt;
  const double square = dot(normal, normal);
  const bool inside = std::abs(dot(cross(met->offset, v), normal)) <= square &&
                      std::abs(dot(cross(u, met->offset), normal)) <= square;
  return inside ? std::optional(met->distance) : std::nullopt;
}

std::optional<double> distanceTo(const DiscLight& light, const Double3& from,
                                 const Double3& direction) {
  const auto met =
      onPlane(toDouble(light.centreMm), toDouble(light.normal), light.twoSided, from, direction);
  const bool inside = met && length(met->offset) <= double{light.radiusMm};
  return inside ? std::optional(met->distance) : std::nullopt;
}

/// The distance at which a line meets the near side of a sphere or tube. The line is nearest to its
/// middle after `along`, at a distance `aside`; `slant` is the share of the way that is
/// perpendicular to the axis.
std::optional<double> nearSide(double along, double aside, double slant, double radius) {
  if (!(aside < radius)) return std::nullopt;
  const double distance = along - std::sqrt(radius * radius - aside * aside) / slant;
  return distance > 0 ? std::optional(distance) : std::nullopt;
}

std::optional<double> distanceTo(const SphereLight& light, const Double3& from,
                                 const Double3& direction) {
  const Double3 towards = toDouble(light.centreMm) - from;
  const double along = dot(towards, direction);
  return nearSide(along, length(towards - along * direction), 1, double{light.radiusMm});
}

std::optional<double> distanceTo(const TubeLight& light, const Double3& from,
                                 const Double3& direction) {
  const Double3 end = toDouble(light.fromMm);
  const Double3 axis = toDouble(light.toMm) - end;
  const Double3 along = unit(axis);
  // In the plane across the axis, where the tube is a circle.
  const Double3 across = direction - dot(direction, along) * along;
  const double slant = length(across);
  if (!(slant > 0)) return std::nullopt;
  const Double3 offset = end - from;
  const Double3 towards = offset - dot(offset, along) * along;
  const double nearest = dot(towards, across) / (slant * slant);
  const auto distance =
      nearSide(nearest, length(towards - nearest * across), slant, double{light.radiusMm});
  if (!distance) return std::nullopt;
  const double place = dot(from + *distance * direction - end, along);
  return place >= 0 && place <= length(axis) ? distance : std::nullopt;
}

}  // namespace

Rgb radianceOf(const AreaLight& light) {
  return std::visit([](const auto& shape) { return shape.radiance; }, light);
}

bool isTwoSided(const AreaLight& light) {
  if (const auto* rectangle = std::get_if<RectangleLight>(&light)) return rectangle->twoSided;
  const auto* disc = std::get_if<DiscLight>(&light);
  return disc != nullptr && disc->twoSided;
}

bool isVisible(const AreaLight& light) {
  return std::visit([](const auto& shape) { return shape.visible; }, light);
}

std::optional<double> distanceAlong(const std::array<double, 3>& fromMm,
                                    const std::array<double, 3>& direction,
                                    const AreaLight& light) {
  return std::visit([&](const auto& shape) { return distanceTo(shape, fromMm, direction); }, light);
}

double areaMm2(const AreaLight& light) {
  return std::visit([](const auto& shape) { return areaOf(shape); }, light);
}

AreaPoint pointOn(const AreaLight& light, double x, double y) {
  return std::visit([&](const auto& shape) { return pointOf(shape, x, y); }, light);
}

std::array<double, 3> normalAt(const AreaLight& light, const std::array<double, 3>& placeMm) {
  return std::visit([&](const auto& shape) { return normalOf(shape, placeMm); }, light);
}

std::array<double, 3> middleOf(const AreaLight& light) {
  return std::visit([](const auto& shape) { return centreOf(shape); }, light);
}

double reachMm(const AreaLight& light) {
  return std::visit([](const auto& shape) { return reachOf(shape); }, light);
}

}  // namespace opaline
