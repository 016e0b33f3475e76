#include "scene/framing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace opaline::scene {

namespace {

/// The camera's up, or another direction where it looks along that.
Double3 usableUp(const Camera& camera, const Double3& ahead) {
  const Double3 up = toDouble(camera.up);
  const Double3 across = cross(ahead, up);
  if (dot(across, across) > 1e-8 * std::max(dot(up, up), 1e-20)) return up;
  return std::abs(ahead[2]) < 0.9 ? Double3{0, 0, -1} : Double3{0, 1, 0};
}

}  // namespace

Framing::Framing(const Camera& camera, double aspect, double margin)
    : target_(toDouble(camera.targetMm)),
      ahead_(unit(toDouble(camera.targetMm) - toDouble(camera.positionMm))) {
  const Double3 right = unit(cross(ahead_, usableUp(camera, ahead_)));
  const double half = double{camera.verticalFovDegrees} * std::numbers::pi / 360;
  const double slope = std::tan(half) * (1 - margin);
  across_ = (1 / (slope * aspect)) * right;
  above_ = (1 / slope) * cross(right, ahead_);
}

void Framing::add(const Double3& point) {
  const Double3 offset = point - target_;
  const double needed =
      std::max(std::abs(dot(offset, across_)), std::abs(dot(offset, above_))) - dot(offset, ahead_);
  if (std::isfinite(needed)) distanceMm_ = std::max(distanceMm_, needed);
}

void Framing::add(const Framing& other) {
  distanceMm_ = std::max(distanceMm_, other.distanceMm_);
}

Vec3 usualUp(const Camera& camera) {
  const Double3 view = toDouble(camera.targetMm) - toDouble(camera.positionMm);
  if (!(std::abs(view[1]) > 0.999 * length(view))) return {0, 1, 0};
  return {0, 0, view[1] < 0 ? -1.0F : 1.0F};
}

double distanceToTargetMm(const Camera& camera) {
  const Double3 from = toDouble(camera.positionMm) - toDouble(camera.targetMm);
  return std::hypot(from[0], from[1], from[2]);
}

void standBack(Camera& camera, double distanceMm) {
  const Double3 target = toDouble(camera.targetMm);
  const Double3 from = unit(toDouble(camera.positionMm) - target);
  camera.positionMm = toFloat(target + distanceMm * from);
}

}  // namespace opaline::scene
