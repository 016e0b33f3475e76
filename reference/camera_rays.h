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

  /// The ray through the pixel's centre, moved right and down by `offset` pixels.
  Ray through(int x, int y, const std::array<double, 2>& offset = {}) const;

  /// Distance of a point along the viewing axis, mm.
  double depthMm(const Vector& point) const;

 private:
  Vector origin_;
  Vector axis_;
  Vector right_;  ///< half the picture's width at distance 1 of a pinhole camera
  Vector down_;   ///< half its height
  double shiftX_;
  double shiftY_;
  bool isParallel_;
  int width_;
  int height_;
};

/// Offsets of the antialiasing samples from the pixel's centre, in pixels to the right and down.
/// They are Direct3D 11's standard patterns for 1, 2, 4 and 8 samples, multiples of 1/16. Any other
/// number of samples counts as one.
std::span<const std::array<double, 2>> antialiasingOffsets(int samples);

}  // namespace opaline::reference
