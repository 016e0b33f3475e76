#include "deform/deformer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/matrix.h"

namespace opaline::deform {

namespace {

using scene::Double3;
using scene::Matrix4;
using scene::operator*;
using scene::operator+;
using scene::operator-;
using scene::cross;

/// The least height that a squash leaves, relative to the rest pose, whatever its amount swings to.
constexpr double leastHeight = 0.1;

/// Quantities of the formulas in opaline/motion.h.
struct RestBox {
  Double3 centre;
  double bottom;    ///< y₀
  double height;    ///< H
  double diagonal;  ///< D

  explicit RestBox(const Bounds& bounds)
      : centre(0.5 * (scene::toDouble(bounds.minMm) + scene::toDouble(bounds.maxMm))),
        bottom(bounds.minMm[1]),
        height(double{bounds.maxMm[1]} - bottom),
        diagonal(scene::length(scene::toDouble(bounds.maxMm) - scene::toDouble(bounds.minMm))) {}
};

/// A point's new place in column 3, and in the others the images of steps along the axes.
using Moved = Matrix4;

/// The fraction of t/period, in [0, 1).
double fractionOf(double seconds, double period) {
  return std::fmod(seconds, period) / period;
}

Moved twisted(double amount, const RestBox& box, const Double3& p) {
  const double rate = amount / box.height;
  const double angle = rate * (p[1] - box.bottom) - amount / 2;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const double x = p[0] - box.centre[0];
  const double z = p[2] - box.centre[2];
  const double turnedX = c * x + s * z;
  const double turnedZ = c * z - s * x;
  return {{Double3{c, 0, -s}, Double3{rate * turnedZ, 1, -rate * turnedX}, Double3{s, 0, c},
           Double3{box.centre[0] + turnedX, p[1], box.centre[2] + turnedZ}}};
}

Moved bent(double amount, const RestBox& box, const Double3& p) {
  const double curvature = amount / box.height;
  const double along = p[1] - box.bottom;
  const double x = p[0] - box.centre[0];
  const double angle = curvature * along;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const double half = std::sin(angle / 2);
  // (1 − cos κs)/κ and sin κs/κ; without curvature the arc is the axis itself.
  const double aside = angle == 0 ? 0 : along * 2 * half * half / angle;
  const double up = angle == 0 ? along : along * s / angle;
  const double stretch = 1 - curvature * x;
  return {{Double3{c, -s, 0}, Double3{stretch * s, stretch * c, 0}, Double3{0, 0, 1},
           Double3{box.centre[0] + aside + x * c, box.bottom + up - x * s, p[2]}}};
}

Moved squashed(double amount, const RestBox& box, const Double3& p) {
  const double high = std::max(1 - amount, leastHeight);
  const double wide = 1 / std::sqrt(high);
  return {{Double3{wide, 0, 0}, Double3{0, high, 0}, Double3{0, 0, wide},
           Double3{box.centre[0] + wide * (p[0] - box.centre[0]),
                   box.bottom + high * (p[1] - box.bottom),
                   box.centre[2] + wide * (p[2] - box.centre[2])}}};
}

Moved wobbled(double amount, double phaseNow, const RestBox& box, const Double3& p) {
  const double h = (p[1] - box.bottom) / box.height;
  const double inside = std::clamp(h, 0.0, 1.0);
  const double swing = inside * inside * (3 - 2 * inside);
  const double swingPerH = 6 * inside * (1 - inside);
  const double wave = 2 * std::numbers::pi * h - phaseNow;
  const double c = std::cos(wave);
  const double s = std::sin(wave);
  const double wide = amount * box.diagonal;
  const double wavePerH = 2 * std::numbers::pi;
  return {{Double3{1, 0, 0},
           Double3{wide * (swingPerH * s + swing * wavePerH * c) / box.height, 1,
                   wide / 2 * (swingPerH * c - swing * wavePerH * s) / box.height},
           Double3{0, 0, 1}, Double3{p[0] + wide * swing * s, p[1], p[2] + wide / 2 * swing * c}}};
}

Moved moved(const Deformer& deformer, const RestBox& box, double seconds, const Double3& p) {
  const double amount = amountAt(deformer, seconds);
  switch (deformer.kind) {
    case DeformerKind::Twist:
      return twisted(amount, box, p);
    case DeformerKind::Bend:
      return bent(amount, box, p);
    case DeformerKind::Squash:
      return squashed(amount, box, p);
    case DeformerKind::Wobble:
      return wobbled(amount, 2 * std::numbers::pi * wavePhaseAt(deformer, seconds), box, p);
  }
  return {{Double3{1, 0, 0}, Double3{0, 1, 0}, Double3{0, 0, 1}, p}};
}

}  // namespace

double amountAt(const Deformer& deformer, double seconds) {
  const double amount{deformer.amount};
  if (deformer.kind == DeformerKind::Wobble || deformer.periodSeconds == 0) return amount;
  return amount *
         std::sin(2 * std::numbers::pi * fractionOf(seconds, double{deformer.periodSeconds}));
}

double wavePhaseAt(const Deformer& deformer, double seconds) {
  return fractionOf(seconds, deformer.periodSeconds == 0 ? 1 : double{deformer.periodSeconds});
}

SurfacePoint deformed(const Deformer& deformer, const Bounds& restBox, double seconds,
                      const SurfacePoint& point) {
  const RestBox box(restBox);
  if (!(box.height > 0)) return point;
  const Moved map = moved(deformer, box, seconds, point.position);
  const auto& [x, y, z, position] = map.column;
  const Double3& n = point.normal;
  const Double3 turned = n[0] * cross(y, z) + n[1] * cross(z, x) + n[2] * cross(x, y);
  const double size = scene::length(turned);
  return {position, size > 0 ? (1 / size) * turned : n};
}

}  // namespace opaline::deform
