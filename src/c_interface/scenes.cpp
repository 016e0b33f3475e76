#include "opaline/scene.h"

#include <cstdint>
#include <memory>
#include <utility>

#include "c_interface/status.h"
#include "c_interface/values.h"
#include "opaline/framing.h"
#include "opaline/material.h"
#include "opaline/media.h"
#include "opaline/mesh.h"

namespace opaline::c {

Camera cameraOf(const OpalineCamera* given) {
  const OpalineCamera whole = wholeOf(given, {}, "camera");
  Camera camera{.positionMm = vectorOf(whole.positionMm, "positionMm"),
                .targetMm = vectorOf(whole.targetMm, "targetMm"),
                .up = vectorOf(whole.up, "up"),
                .verticalFovDegrees = whole.verticalFovDegrees,
                .shiftX = whole.shiftX,
                .shiftY = whole.shiftY,
                .orthographicHeightMm = {}};
  if (whole.orthographicHeightMm != 0) camera.orthographicHeightMm = whole.orthographicHeightMm;
  return sound(camera);
}

void give(const Camera& camera, OpalineCamera* to) {
  OpalineCamera whole{};
  std::copy_n(camera.positionMm.begin(), 3, whole.positionMm);
  std::copy_n(camera.targetMm.begin(), 3, whole.targetMm);
  std::copy_n(camera.up.begin(), 3, whole.up);
  whole.verticalFovDegrees = camera.verticalFovDegrees;
  whole.shiftX = camera.shiftX;
  whole.shiftY = camera.shiftY;
  whole.orthographicHeightMm = camera.orthographicHeightMm.value_or(0);
  give(whole, to, "camera");
}

LoadOptions loadOptionsOf(const OpalineLoadOptions* given) {
  LoadOptions options;
  if (!given) return options;
  const OpalineLoadOptions whole = wholeOf(given, {}, "options");
  if (whole.diagonalMm != 0) options.diagonalMm = whole.diagonalMm;
  if (whole.medium) options.medium = mediumOf(whole.medium);
  if (whole.colorModel) options.colorModel = colorModelOf(*whole.colorModel);
  if (whole.morphTo) options.morphTo = whole.morphTo;
  options.log = logOf(whole.log, whole.logContext);
  return options;
}

void giveScene(Scene scene, OpalineScene** to) {
  required(to, "scene");
  *to = new OpalineScene{{}, std::move(scene)};
}

namespace {

Object makeObject(const OpalineObject* given) {
  const OpalineObject whole = wholeOf(given, {}, "object");
  requireCount(whole.triangleCount, mostVectors, "triangles");
  if (whole.triangleCount > 0) required(whole.triangles, "triangles");
  std::vector<Triangle> triangles(whole.triangleCount);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    std::copy_n(whole.triangles + 3 * i, 3, triangles[i].begin());
  }
  Object object;
  if (whole.name) object.name = whole.name;
  object.mesh = makeMesh(vectorsOf<Vec3>(whole.positionsMm, whole.vertexCount,
                                         whole.positionStrideBytes, "positionsMm"),
                         std::move(triangles));
  object.medium = whole.medium ? mediumOf(whole.medium) : findMedium("marble").value();
  if (whole.opaqueColor)
    object.opaque = sound(mattMaterial(vectorOf(whole.opaqueColor, "opaqueColor")));
  return object;
}

}  // namespace
}  // namespace opaline::c

using namespace opaline;
using opaline::c::guarded;
using opaline::c::required;

extern "C" {

OpalineStatus opalineCreateScene(OpalineScene** scene) {
  return guarded([&] { c::giveScene({}, scene); });
}

OpalineStatus opalineLoadScene(const char* file, const OpalineLoadOptions* options,
                               OpalineScene** scene) {
  return guarded(
      [&] { c::giveScene(loadScene(&required(file, "file"), c::loadOptionsOf(options)), scene); });
}

OpalineStatus opalineCreateBear(const OpalineLoadOptions* options, OpalineScene** scene) {
  return guarded([&] { c::giveScene(builtInBear(c::loadOptionsOf(options)), scene); });
}

OpalineStatus opalineCreateTeapot(const OpalineLoadOptions* options, OpalineScene** scene) {
  return guarded([&] { c::giveScene(builtInTeapot(c::loadOptionsOf(options)), scene); });
}

void opalineDestroyScene(OpalineScene* scene) {
  c::destroy(scene);
}

OpalineStatus opalineAddObject(OpalineScene* scene, const OpalineObject* object, size_t* index) {
  return guarded([&] {
    std::vector<Object>& objects = required(scene, "scene").scene.objects;
    objects.push_back(c::makeObject(object));
    if (index) *index = objects.size() - 1;
  });
}

OpalineStatus opalineAddGround(OpalineScene* scene, const float color[3]) {
  return guarded([&] {
    const Ground ground = c::sound(Ground{c::vectorOf(color, "color"), {}});
    Scene& to = required(scene, "scene").scene;
    removeGround(to);
    to.objects.push_back(groundUnder(to, ground));
  });
}

OpalineStatus opalineObjectCount(const OpalineScene* scene, size_t* count) {
  return guarded([&] { required(count, "count") = required(scene, "scene").scene.objects.size(); });
}

OpalineStatus opalineObjectFacts(const OpalineScene* scene, size_t object,
                                 OpalineObjectFacts* facts) {
  return guarded([&] {
    const Object& of = c::objectOf(scene, object);
    c::give({0, of.name.c_str(), of.mesh.positionsMm.size(), of.mesh.triangles.size()}, facts,
            "facts");
  });
}

OpalineStatus opalineObjectPositions(const OpalineScene* scene, size_t object, float* positionsMm,
                                     size_t vertexCount) {
  return guarded([&] {
    c::give(c::objectOf(scene, object).mesh.positionsMm, positionsMm, vertexCount, "positionsMm");
  });
}

OpalineStatus opalineObjectTriangles(const OpalineScene* scene, size_t object, uint32_t* triangles,
                                     size_t triangleCount) {
  return guarded([&] {
    c::give(c::objectOf(scene, object).mesh.triangles, triangles, triangleCount, "triangles");
  });
}

OpalineStatus opalineObjectMedium(const OpalineScene* scene, size_t object, OpalineMedium* medium) {
  return guarded([&] { c::give(c::objectOf(scene, object).medium, medium); });
}

OpalineStatus opalineSetObjectMedium(OpalineScene* scene, size_t object,
                                     const OpalineMedium* medium) {
  return guarded([&] {
    Object& of = c::objectOf(scene, object);
    of.medium = c::mediumOf(medium);
    of.opaque.reset();
  });
}

OpalineStatus opalineDefaultCamera(const OpalineScene* scene, const float directionFromCentre[3],
                                   float verticalFovDegrees, OpalineCamera* camera) {
  return guarded([&] {
    c::give(
        defaultCamera(required(scene, "scene").scene,
                      c::vectorOf(directionFromCentre, "directionFromCentre"), verticalFovDegrees),
        camera);
  });
}

OpalineStatus opalineCameraThatSees(const OpalineCamera* camera, double aspect, double margin,
                                    const float* pointsMm, size_t pointCount, size_t strideBytes,
                                    OpalineCamera* moved) {
  return guarded([&] {
    Framing framing(c::cameraOf(camera), aspect, margin);
    for (const Vec3& point : c::vectorsOf<Vec3>(pointsMm, pointCount, strideBytes, "pointsMm"))
      framing.add(point);
    c::give(framing.camera(), moved);
  });
}

OpalineStatus opalineSceneCamera(const OpalineScene* scene, OpalineCamera* camera) {
  return guarded([&] { c::give(required(scene, "scene").scene.camera, camera); });
}

OpalineStatus opalineSetSceneCamera(OpalineScene* scene, const OpalineCamera* camera) {
  return guarded([&] {
    required(scene, "scene").scene.camera = c::cameraOf(camera);
    scene->scene.cameraChosen = true;
  });
}

}  // extern "C"
