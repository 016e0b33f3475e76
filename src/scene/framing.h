#pragma once

#include "opaline/scene.h"
#include "scene/vector_math.h"

namespace opaline::scene {

/// Finds how far from its target a camera has to stand to see all of a set of points, looking the
/// way it looks. At a distance D a point that lies `a` beyond the target, `x` aside and `y` above
/// is seen where |y| ≤ (D + a) tan(fov/2) and |x| ≤ (D + a) tan(fov/2) · aspect, so that each point
/// asks for a least D of its own.
class Framing {
 public:
  /// `aspect` is the picture's width over its height. Of its half width and half height the part
  /// `margin`, in [0, 1), stays free.
  Framing(const Camera& camera, double aspect, double margin);

  /// A point that is not finite asks for nothing.
  void add(const Double3& point);
  void add(const Framing& other);

  /// The least from which all points are seen; 0 where there are none.
  double distanceMm() const { return distanceMm_; }

 private:
  Double3 target_;
  Double3 ahead_;   ///< unit
  Double3 across_;  ///< by which an offset becomes the depth that its place aside needs
  Double3 above_;
  double distanceMm_ = 0;
};

/// The up of a camera of which nobody said which it is: +y, or what is up where it looks along
/// that.
Vec3 usualUp(const Camera& camera);

/// How far a camera stands from its target.
double distanceToTargetMm(const Camera& camera);

/// Moves a camera along the way it looks, its target stays.
void standBack(Camera& camera, double distanceMm);

}  // namespace opaline::scene
