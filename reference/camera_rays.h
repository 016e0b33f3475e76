#pragma once

#include <array>
#include <span>

#include "opaline/scene.h"
#include "reference/vector.h"

namespace opaline::reference {

struct Ray {
  Vector origin{};
  Vector direction{};  ///< unit
};

/// The rays of a camera through the pixels of a picture; row 0 is the uppermost.
class CameraRays {
 public:
  CameraRays(const Camera& camera, int width, int height);

  /// Through the pixel's centre, moved by `offset` pixels to the right and down.
  Ray through(int x, int y, const std::array<double, 2>& offset = {}) const;

  /// Distance of a point along the viewing axis, mm.
  double depthMm(const Vector& point) const;

 private:
  Vector origin_;
  Vector axis_;
  Vector right_;  ///< half the picture's width, at distance 1 of a pinhole camera
  Vector down_;   ///< half its height
  double shiftX_;
  double shiftY_;
  bool isParallel_;
  int width_;
  int height_;
};

/// Offsets of the antialiasing samples from the pixel's centre, in pixels, to the right and down:
/// the standard patterns of Direct3D 11 for 1, 2, 4 and 8 samples, which are multiples of 1/16.
/// Any other number of samples is one.
std::span<const std::array<double, 2>> antialiasingOffsets(int samples);

}  // namespace opaline::reference
