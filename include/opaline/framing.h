#pragma once

#include <array>
#include <optional>

#include "opaline/export.h"
#include "opaline/scene.h"
#include "opaline/types.h"

namespace opaline {

/// Finds where a camera sees all of a set of points without being turned. A pinhole camera moves
/// nearer to its target or farther from it; an orthographic one stays and its picture's height
/// changes.
class OPALINE_API Framing {
 public:
  /// `aspect` is the picture's width divided by its height. `margin`, in [0, 1), is the part of its
  /// half width and half height that stays free. Throws UsageError for numbers out of range, and
  /// for a camera that cannot be rendered or whose shift puts its target into the margin or beyond.
  Framing(const Camera& camera, double aspect, double margin = 0);

  /// Adds a point that has to be seen, mm; one that is not finite is ignored.
  void add(const Vec3& pointMm);
  /// Adds the points of another framing of the same camera.
  void add(const Framing& other);

  /// Whether the given camera already sees all points.
  bool isMet() const;
  /// The camera that just sees all points; the given one if there are none.
  Camera camera() const;

 private:
  Camera camera_;
  std::array<double, 3> target_{};
  std::array<double, 3> ahead_{};  // unit; zero for an orthographic camera
  // One per side of the picture: the dot product with a point's offset from the target contributes
  // to what the point needs.
  std::array<std::array<double, 3>, 4> sides_{};
  double needed_ = 0;  // least distance from the target, or height of the picture, mm
};

/// How far a camera stands from its target, mm.
OPALINE_API double distanceToTargetMm(const Camera& camera);

/// The up direction of a camera that was given none: +y, or ±z if it looks along y.
OPALINE_API Vec3 usualUp(const Camera& camera);

/// Where a camera is to stand and what it is to look at. What has no value stays as it is.
struct CameraPlace {
  std::optional<Vec3> positionMm;
  std::optional<Vec3> targetMm;
  /// From the target to the camera, unit, in place of a position: the camera keeps its distance.
  std::optional<Vec3> direction;
};

/// Moves a camera there, with the usual up. Without any value nothing changes.
OPALINE_API void placeCamera(const CameraPlace& place, Camera& camera);

}  // namespace opaline
