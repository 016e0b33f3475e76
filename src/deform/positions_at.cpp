#include "opaline/positions.h"

#include "deform/deformed_vertices.h"

namespace opaline {

std::vector<std::vector<Vec3>> positionsAt(const Scene& scene, const SceneTime& time,
                                           const PositionsByObject& given) {
  deform::requireTime(scene, time);
  deform::requireFit(scene, given);
  // Only deformers need it.
  const Bounds box = scene.deformers.empty() ? Bounds{} : boundsOf(scene);
  scene::Pose pose = scene::makePose(scene);
  scene::poseAt(scene, time.clip, time.seconds, pose);
  std::vector<std::vector<Vec3>> all(scene.objects.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Object& object = scene.objects[i];
    if (object.isGround) {
      all[i] = object.mesh.positionsMm;
      continue;
    }
    const auto found = given.find(i);
    const std::vector<scene::Double3> places =
        found == given.end()
            ? deform::deformedPositions(scene, i, pose, box, time.seconds)
            : deform::deformedPositions(scene.deformers, found->second, box, time.seconds);
    all[i].reserve(places.size());
    for (const scene::Double3& place : places) all[i].push_back(scene::toFloat(place));
  }
  return all;
}

}  // namespace opaline
