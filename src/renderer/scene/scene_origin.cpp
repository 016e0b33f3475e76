#include "renderer/scene/scene_origin.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>

namespace opaline {

namespace {

void seeFrom(const Vec3& originMm, RectangleLight& light) {
  opaline::seeFrom(originMm, light.centreMm);
}
void seeFrom(const Vec3& originMm, DiscLight& light) {
  opaline::seeFrom(originMm, light.centreMm);
}
void seeFrom(const Vec3& originMm, SphereLight& light) {
  opaline::seeFrom(originMm, light.centreMm);
}
void seeFrom(const Vec3& originMm, TubeLight& light) {
  opaline::seeFrom(originMm, light.fromMm);
  opaline::seeFrom(originMm, light.toMm);
}

}  // namespace

Vec3 originFor(const Scene& scene) {
  // Within this distance, rounding is no larger than that of later arithmetic.
  constexpr double farDiagonals = 8;
  const Bounds bounds = boundsOf(scene);
  const Vec3 middle = middleOf(bounds);
  double squares = 0;
  for (std::size_t axis = 0; axis < middle.size(); ++axis) {
    const double edge =
        static_cast<double>(bounds.maxMm[axis]) - static_cast<double>(bounds.minMm[axis]);
    squares += edge * edge;
  }
  const double diagonal = std::sqrt(squares);
  const bool isFar = std::any_of(middle.begin(), middle.end(), [&](float x) {
    return std::abs(static_cast<double>(x)) > farDiagonals * diagonal;
  });
  return isFar && diagonal > 0 ? middle : Vec3{};
}

void seeFrom(const Vec3& originMm, Vec3& positionMm) {
  for (std::size_t axis = 0; axis < positionMm.size(); ++axis) positionMm[axis] -= originMm[axis];
}

void seeFrom(const Vec3& originMm, Camera& camera) {
  seeFrom(originMm, camera.positionMm);
  seeFrom(originMm, camera.targetMm);
}

void seeFrom(const Vec3& originMm, Lighting& lighting) {
  for (PointLight& light : lighting.points) seeFrom(originMm, light.positionMm);
  for (SpotLight& light : lighting.spots) seeFrom(originMm, light.positionMm);
  for (AreaLight& light : lighting.areas)
    std::visit([&](auto& kind) { seeFrom(originMm, kind); }, light);
}

void seeFrom(const Vec3& originMm, Mesh& mesh) {
  for (Vec3& position : mesh.positionsMm) seeFrom(originMm, position);
}

}  // namespace opaline
