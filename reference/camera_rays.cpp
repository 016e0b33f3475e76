#include "reference/camera_rays.h"

#include <cmath>
#include <numbers>

namespace opaline::reference {

namespace {

// As on the GPU: a camera that looks along its up takes another direction.
Vector usableUp(const Vector& wanted, const Vector& axis) {
  const Vector across = cross(axis, wanted);
  if (dot(across, across) > 1e-8 * std::max(dot(wanted, wanted), 1e-20)) return wanted;
  return std::abs(axis[2]) < 0.9 ? Vector{0, 0, -1} : Vector{0, 1, 0};
}

}  // namespace

CameraRays::CameraRays(const Camera& camera, int width, int height)
    : origin_(toVector(camera.positionMm)),
      shiftX_(camera.shiftX),
      shiftY_(camera.shiftY),
      isParallel_(camera.orthographicHeightMm.has_value()),
      width_(width),
      height_(height) {
  axis_ = unitOr(toVector(camera.targetMm) - origin_, {0, 0, -1});
  const Vector right = unitOr(cross(axis_, usableUp(toVector(camera.up), axis_)), {1, 0, 0});
  const double halfHeight =
      isParallel_ ? 0.5 * double{*camera.orthographicHeightMm}
                  : std::tan(0.5 * double{camera.verticalFovDegrees} * std::numbers::pi / 180);
  right_ = (halfHeight * width / height) * right;
  down_ = -halfHeight * cross(right, axis_);
}

Ray CameraRays::through(int x, int y, const std::array<double, 2>& offset) const {
  const double across = 2 * ((x + 0.5 + offset[0]) / width_ + shiftX_) - 1;
  const double below = 2 * ((y + 0.5 + offset[1]) / height_ - shiftY_) - 1;
  const Vector aside = across * right_ + below * down_;
  if (isParallel_) return {origin_ + aside, axis_};
  return {origin_, unitOr(axis_ + aside, axis_)};
}

double CameraRays::depthMm(const Vector& point) const {
  return dot(point - origin_, axis_);
}

std::span<const std::array<double, 2>> antialiasingOffsets(int samples) {
  using Offset = std::array<double, 2>;
  static constexpr std::array<Offset, 1> one{{{0, 0}}};
  static constexpr std::array<Offset, 2> two{{{4. / 16, 4. / 16}, {-4. / 16, -4. / 16}}};
  static constexpr std::array<Offset, 4> four{
      {{-2. / 16, -6. / 16}, {6. / 16, -2. / 16}, {-6. / 16, 2. / 16}, {2. / 16, 6. / 16}}};
  static constexpr std::array<Offset, 8> eight{{{1. / 16, -3. / 16},
                                                {-1. / 16, 3. / 16},
                                                {5. / 16, 1. / 16},
                                                {-3. / 16, -5. / 16},
                                                {-5. / 16, 5. / 16},
                                                {-7. / 16, -1. / 16},
                                                {3. / 16, 7. / 16},
                                                {7. / 16, -7. / 16}}};
  switch (samples) {
    case 2:
      return two;
    case 4:
      return four;
    case 8:
      return eight;
    default:
      return one;
  }
}

}  // namespace opaline::reference
