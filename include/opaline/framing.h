#pragma once

#include <array>

#include "opaline/export.h"
#include "opaline/scene.h"
#include "opaline/types.h"

namespace opaline {

/// Finds from where a camera sees all of a set of points, looking the way it looks. A pinhole
/// camera moves nearer to its target or farther from it; an orthographic one stays and gets the
/// height of its picture.
class OPALINE_API Framing {
 public:
  /// `aspect` is the picture's width over its height. Of its half width and half height the part
  /// `margin`, in [0, 1), stays free. Throws UsageError for a camera that cannot be rendered, or
  /// whose shift puts its target beyond that free part, and for other numbers.
  Framing(const Camera& camera, double aspect, double margin = 0);

  /// Points to be seen, mm; one that is not finite asks for nothing.
  void add(const Vec3& pointMm);
  /// The points that were added to another framing of the same camera.
  void add(const Framing& other);

  /// Whether the camera sees all of them as it is.
  bool isMet() const;
  /// The camera that just sees all of them; as it is where there are none.
  Camera camera() const;

 private:
  Camera camera_;
  std::array<double, 3> target_{};
  std::array<double, 3> ahead_{};  // unit, but zero of an orthographic camera
  // Sides of the picture: by which an offset from the target becomes what its place asks for.
  std::array<std::array<double, 3>, 4> sides_{};
  double needed_ = 0;  // least distance from the target, or height of the picture, mm
};

/// How far a camera stands from its target, mm.
OPALINE_API double distanceToTargetMm(const Camera& camera);

/// The up of a camera of which nobody said which it is: +y, or what is up where it looks along
/// that.
OPALINE_API Vec3 usualUp(const Camera& camera);

}  // namespace opaline
