#include "opaline/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "opaline/error.h"
#include "scene/finish.h"
#include "scene/vector_math.h"

namespace opaline {

namespace scene {
namespace {

Vec3 along(const Double3& from, double factor, const Double3& direction) {
  return toFloat(from + factor * direction);
}

}  // namespace
}  // namespace scene

Bounds boundsOf(const Scene& scene) {
  Bounds bounds;
  bool first = true;
  for (const Object& object : scene.objects) {
    if (object.isGround) continue;
    for (const Vec3& p : object.mesh.positionsMm) {
      if (first) bounds = {p, p};
      first = false;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        bounds.minMm[axis] = std::min(bounds.minMm[axis], p[axis]);
        bounds.maxMm[axis] = std::max(bounds.maxMm[axis], p[axis]);
      }
    }
  }
  return bounds;
}

Vec3 middleOf(const Bounds& bounds) {
  return scene::toFloat(scene::exactMiddleOf(bounds));
}

float diagonalMm(const Scene& scene) {
  const Bounds bounds = boundsOf(scene);
  return std::hypot(bounds.maxMm[0] - bounds.minMm[0], bounds.maxMm[1] - bounds.minMm[1],
                    bounds.maxMm[2] - bounds.minMm[2]);
}

Camera defaultCamera(const Scene& scene, Vec3 directionFromCentre, float verticalFovDegrees) {
  if (!(verticalFovDegrees >= 1 && verticalFovDegrees <= 170)) {
    throw UsageError(fmt::format("the vertical field of view must be in [1, 170] degrees, not {}",
                                 verticalFovDegrees));
  }
  const scene::Double3 direction = scene::toDouble(directionFromCentre);
  const double size = scene::length(direction);
  if (!scene::isFinite(direction) || !(size > 1e-30)) {
    throw UsageError("the camera's direction must be finite and not zero");
  }
  const scene::Double3 centre = scene::exactMiddleOf(boundsOf(scene));
  const double distance = 1.4 * double{diagonalMm(scene)};
  Camera camera;
  camera.targetMm = scene::toFloat(centre);
  camera.positionMm = scene::along(centre, distance / size, direction);
  camera.verticalFovDegrees = verticalFovDegrees;
  // A camera that looks along the usual up needs another one.
  if (std::abs(direction[1]) > 0.999 * size) camera.up = {0, 0, direction[1] > 0 ? -1.0F : 1.0F};
  return camera;
}

Lighting defaultLighting() {
  Lighting lighting;
  // The key light shines through the body towards the camera on +z. It is slightly warm, the fill
  // slightly cool.
  lighting.directional.push_back(
      {scene::toFloat(scene::unit({0.45, 0.35, -0.82})), {6.0F, 5.8F, 5.4F}});
  lighting.directional.push_back(
      {scene::toFloat(scene::unit({-0.6, 0.45, 0.66})), {0.45F, 0.5F, 0.6F}});
  lighting.ambient = {0.12F, 0.12F, 0.13F};
  return lighting;
}

}  // namespace opaline
