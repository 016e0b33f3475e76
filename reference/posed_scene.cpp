#include "reference/posed_scene.h"

#include <fmt/format.h>

#include <utility>

#include "deform/deformed_vertices.h"
#include "opaline/error.h"
#include "scene/mesh/normals.h"

namespace opaline::reference {

deform::DeformedVertices meshAt(const opaline::Scene& scene, std::size_t object,
                                const deform::Pose& pose, double seconds,
                                const PositionsByObject& positionsMm) {
  const Bounds box = boundsOf(scene);
  const auto given = positionsMm.find(object);
  if (given == positionsMm.end()) {
    return deform::deformedVertices(scene, object, pose, box, seconds);
  }
  opaline::Scene moved;
  moved.objects.push_back(scene.objects[object]);
  moved.objects[0].rig.reset();
  moved.objects[0].mesh.positionsMm = given->second;
  moved.deformers = scene.deformers;
  deform::DeformedVertices mesh = deform::deformedVertices(moved, 0, pose, box, seconds);
  const Mesh& rest = scene.objects[object].mesh;
  if (!rest.facetted) mesh.normals = scene::smoothNormals(mesh.positionsMm, rest.triangles);
  return mesh;
}

Scene posedScene(const opaline::Scene& scene, const SceneTime& time,
                 const PositionsByObject& positionsMm) {
  for (const auto& [object, positions] : positionsMm) {
    if (object >= scene.objects.size() ||
        positions.size() != scene.objects[object].mesh.positionsMm.size()) {
      throw UsageError(
          fmt::format("the {} positions given do not fit object {}", positions.size(), object));
    }
  }
  deform::Pose pose = deform::makePose(scene);
  deform::poseAt(scene, time.clip, time.seconds, pose);
  Scene result;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    if (object.opaque)
      throw UsageError(
          fmt::format("'{}' is opaque, and a reference knows translucent bodies only: "
                      "leave it out, or give it a medium",
                      object.name));
    deform::DeformedVertices mesh = meshAt(scene, i, pose, time.seconds, positionsMm);
    result.bodies.push_back({std::move(mesh.positionsMm), std::move(mesh.normals),
                             object.mesh.triangles, object.medium});
    if (object.paint)
      result.bodies.back().painted = {*object.paint, object.mesh.textureCoordinates,
                                      object.mesh.colors};
  }
  result.lighting = scene.lighting;
  result.camera = scene.camera;
  return result;
}

}  // namespace opaline::reference
