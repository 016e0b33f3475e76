#include "reference/posed_scene.h"

#include <cmath>
#include <utility>

#include "deform/deformed_vertices.h"
#include "reference/own_surface.h"
#include "scene/changes.h"
#include "scene/mesh/bodies.h"
#include "scene/mesh/normals.h"

namespace opaline::reference {

deform::DeformedVertices meshAt(const opaline::Scene& scene, std::size_t object,
                                const scene::Pose& pose, double seconds,
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

namespace {

// The ground does not move. It lies slightly lower than stated: bodies standing on it have their
// own surface there, which rays must hit first.
void placeGround(const opaline::Scene& scene, const Object& ground, Body& body) {
  const double hair = std::ldexp(double{diagonalMm(scene)}, -19);
  for (const Vec3& p : ground.mesh.positionsMm)
    body.positionsMm.push_back(toVector(p) - Vector{0, hair, 0});
  for (const Vec3& n : ground.mesh.normals) body.normals.push_back(toVector(n));
}

}  // namespace

Scene posedScene(const opaline::Scene& scene, const SceneTime& time,
                 const PositionsByObject& positionsMm) {
  deform::requireTime(scene, time);
  deform::requireFit(scene, positionsMm);
  scene::Pose pose = scene::makePose(scene);
  scene::poseAt(scene, time.clip, time.seconds, pose);
  Scene result;
  result.wholeOfBody = scene::bodyOfObjects(scene);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    Body& body = result.bodies.emplace_back();
    if (object.isGround) {
      placeGround(scene, object, body);
    } else {
      deform::DeformedVertices mesh = meshAt(scene, i, pose, time.seconds, positionsMm);
      body.positionsMm = std::move(mesh.positionsMm);
      body.normals = std::move(mesh.normals);
    }
    body.triangles = object.mesh.triangles;
    body.medium = scene::mediumAt(scene, i, time);
    body.opaque = scene::opaqueAt(scene, i, time);
    if (!body.opaque) {
      body.paint = object.paint;
      body.surface = object.surface;
    }
    body.isGround = object.isGround;
    if (!body.opaque && !body.paint && !body.surface) continue;
    body.textureCoordinates = object.mesh.textureCoordinates;
    body.colors = object.mesh.colors;
    if (const std::optional<Texture>& normals = normalTextureOf(body))
      body.tangents =
          scene::tangentsOf(object.mesh, static_cast<std::size_t>(normals->coordinates));
  }
  result.lighting = scene.lighting;
  scene::takeLightsAt(scene, time, result.lighting);
  result.camera = scene.camera;
  scene::takeCameraAt(scene, time, result.camera);
  return result;
}

}  // namespace opaline::reference
