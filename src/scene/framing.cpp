#include "opaline/framing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "opaline/error.h"
#include "scene/vector_math.h"

namespace opaline {

namespace scene {
namespace {

/// The camera's up, or another direction where the camera looks along its up.
Double3 usableUp(const Camera& camera, const Double3& ahead) {
  const Double3 up = toDouble(camera.up);
  const Double3 across = cross(ahead, up);
  if (dot(across, across) > 1e-8 * std::max(dot(up, up), 1e-20)) return up;
  return std::abs(ahead[2]) < 0.9 ? Double3{0, 0, -1} : Double3{0, 1, 0};
}

/// How much room a side of the picture has beyond the target, as a part of the half width or half
/// height. A shift moves the target by parts of the whole.
double roomOf(double shift, double margin) {
  const double room = 1 - margin + 2 * shift;
  if (room > 0) return room;
  throw UsageError("The camera's shift moves its target out of the picture or into its margin.");
}

Vec3 movedBack(const Camera& camera, double distanceMm) {
  const Double3 target = toDouble(camera.targetMm);
  const Double3 from = unit(toDouble(camera.positionMm) - target);
  return toFloat(target + distanceMm * from);
}

}  // namespace
}  // namespace scene

// At a distance D, a point that lies `a` beyond the target, `x` to the side and `y` above is seen
// where |y| ≤ (D + a) tan(fov/2) and |x| ≤ (D + a) tan(fov/2) · aspect. Each point thus asks for a
// least D. An orthographic camera sees |y| ≤ height/2.
Framing::Framing(const Camera& camera, double aspect, double margin)
    : camera_(camera), target_(scene::toDouble(camera.targetMm)) {
  using namespace scene;
  if (const std::string complaint = complaintAbout(camera); !complaint.empty()) {
    throw UsageError(complaint);
  }
  if (!(aspect > 0) || !std::isfinite(aspect) || !(margin >= 0 && margin < 1)) {
    throw UsageError("A framing needs an aspect above 0 and a margin in [0, 1).");
  }
  const Double3 ahead = unit(target_ - toDouble(camera.positionMm));
  const Double3 right = unit(cross(ahead, usableUp(camera, ahead)));
  const Double3 up = cross(right, ahead);
  const bool isParallel = camera.orthographicHeightMm.has_value();
  const double half = double{camera.verticalFovDegrees} * std::numbers::pi / 360;
  const double slope = isParallel ? 0.5 : std::tan(half);
  const double shiftX{camera.shiftX};
  const double shiftY{camera.shiftY};
  sides_ = {(1 / (slope * aspect * roomOf(shiftX, margin))) * right,
            (-1 / (slope * aspect * roomOf(-shiftX, margin))) * right,
            (1 / (slope * roomOf(shiftY, margin))) * up,
            (-1 / (slope * roomOf(-shiftY, margin))) * up};
  if (!isParallel) ahead_ = ahead;
}

void Framing::add(const Vec3& pointMm) {
  using namespace scene;
  const Double3 offset = toDouble(pointMm) - target_;
  double needed = dot(offset, sides_[0]);
  for (const Double3& side : sides_) needed = std::max(needed, dot(offset, side));
  needed -= dot(offset, ahead_);
  if (std::isfinite(needed)) needed_ = std::max(needed_, needed);
}

void Framing::add(const Framing& other) {
  needed_ = std::max(needed_, other.needed_);
}

bool Framing::isMet() const {
  const auto& heightMm = camera_.orthographicHeightMm;
  return needed_ <= (heightMm ? double{*heightMm} : distanceToTargetMm(camera_));
}

Camera Framing::camera() const {
  Camera camera = camera_;
  if (!(needed_ > 0)) return camera;
  if (camera.orthographicHeightMm) {
    camera.orthographicHeightMm = static_cast<float>(needed_);
  } else {
    camera.positionMm = scene::movedBack(camera, needed_);
  }
  return camera;
}

Vec3 usualUp(const Camera& camera) {
  using namespace scene;
  const Double3 view = toDouble(camera.targetMm) - toDouble(camera.positionMm);
  if (!(std::abs(view[1]) > 0.999 * length(view))) return {0, 1, 0};
  return {0, 0, view[1] < 0 ? -1.0F : 1.0F};
}

void placeCamera(const CameraPlace& place, Camera& camera) {
  using namespace scene;
  if (!place.positionMm && !place.targetMm && !place.direction) return;
  const double distanceMm = distanceToTargetMm(camera);
  if (place.targetMm) camera.targetMm = *place.targetMm;
  if (place.positionMm) camera.positionMm = *place.positionMm;
  if (place.direction)
    camera.positionMm =
        toFloat(toDouble(camera.targetMm) + distanceMm * toDouble(*place.direction));
  camera.up = usualUp(camera);
}

double distanceToTargetMm(const Camera& camera) {
  using namespace scene;
  const Double3 from = toDouble(camera.positionMm) - toDouble(camera.targetMm);
  return std::hypot(from[0], from[1], from[2]);
}

}  // namespace opaline
