#include "opaline/scene.h"

#include <cstdint>
#include <memory>
#include <utility>

#include "c_interface/status.h"
#include "c_interface/values.h"
#include "opaline/material.h"
#include "opaline/media.h"
#include "opaline/mesh.h"

namespace opaline::c {

Camera cameraOf(const OpalineCamera* given) {
  const OpalineCamera whole = wholeOf(given, {}, "camera");
  const Camera camera{vectorOf(whole.positionMm, "positionMm"),
                      vectorOf(whole.targetMm, "targetMm"), vectorOf(whole.up, "up"),
                      whole.verticalFovDegrees};
  const std::string complaint = complaintAbout(camera);
  if (!complaint.empty()) throw UsageError(complaint);
  return camera;
}

void give(const Camera& camera, OpalineCamera* to) {
  OpalineCamera whole{};
  std::copy_n(camera.positionMm.begin(), 3, whole.positionMm);
  std::copy_n(camera.targetMm.begin(), 3, whole.targetMm);
  std::copy_n(camera.up.begin(), 3, whole.up);
  whole.verticalFovDegrees = camera.verticalFovDegrees;
  give(whole, to, "camera");
}

std::vector<Vec3> positionsOf(const float* positionsMm, std::size_t count,
                              std::size_t strideBytes) {
  if (count > 0) required(positionsMm, "positionsMm");
  if (strideBytes == 0) strideBytes = sizeof(Vec3);
  if (strideBytes < sizeof(Vec3)) {
    throw UsageError(fmt::format("A stride of {} bytes is less than a position has.", strideBytes));
  }
  std::vector<Vec3> positions(count);
  const auto* from = reinterpret_cast<const char*>(positionsMm);
  for (std::size_t i = 0; i < count; ++i) {
    std::memcpy(positions[i].data(), from + i * strideBytes, sizeof(Vec3));
  }
  return positions;
}

namespace {

LoadOptions loadOptionsOf(const OpalineLoadOptions* given) {
  LoadOptions options;
  if (!given) return options;
  const OpalineLoadOptions whole = wholeOf(given, {}, "options");
  if (whole.diagonalMm != 0) options.diagonalMm = whole.diagonalMm;
  if (whole.medium) options.medium = mediumOf(whole.medium);
  return options;
}

void giveScene(Scene scene, OpalineScene** to) {
  required(to, "scene");
  *to = std::make_unique<OpalineScene>(OpalineScene{std::move(scene)}).release();
}

template <typename AScene>
auto& objectOf(AScene* scene, std::size_t index) {
  auto& objects = required(scene, "scene").scene.objects;
  if (index >= objects.size()) {
    throw UsageError(
        fmt::format("There is no object {}: the scene has {}.", index, objects.size()));
  }
  return objects[index];
}

Object objectOf(const OpalineObject* given) {
  const OpalineObject whole = wholeOf(given, {}, "object");
  if (whole.triangleCount > 0) required(whole.triangles, "triangles");
  std::vector<Triangle> triangles(whole.triangleCount);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    std::copy_n(whole.triangles + 3 * i, 3, triangles[i].begin());
  }
  Object object;
  if (whole.name) object.name = whole.name;
  object.mesh =
      makeMesh(positionsOf(whole.positionsMm, whole.vertexCount, whole.positionStrideBytes),
               std::move(triangles));
  object.medium = whole.medium ? mediumOf(whole.medium) : findMedium("marble").value();
  if (whole.opaqueColor) {
    object.opaque = mattMaterial(vectorOf(whole.opaqueColor, "opaqueColor"));
    const std::string complaint = complaintAbout(*object.opaque);
    if (!complaint.empty()) throw UsageError(complaint);
  }
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
  delete scene;
}

OpalineStatus opalineAddObject(OpalineScene* scene, const OpalineObject* object, size_t* index) {
  return guarded([&] {
    std::vector<Object>& objects = required(scene, "scene").scene.objects;
    objects.push_back(c::objectOf(object));
    if (index) *index = objects.size() - 1;
  });
}

OpalineStatus opalineAddGround(OpalineScene* scene, const float color[3]) {
  return guarded([&] {
    const Ground ground{c::vectorOf(color, "color"), {}};
    const std::string complaint = complaintAbout(ground);
    if (!complaint.empty()) throw UsageError(complaint);
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
    const std::vector<Vec3>& positions = c::objectOf(scene, object).mesh.positionsMm;
    if (vertexCount != positions.size()) {
      throw UsageError(fmt::format("There is room for {} positions, but object {} has {}.",
                                   vertexCount, object, positions.size()));
    }
    float* to = &required(positionsMm, "positionsMm");
    for (const Vec3& position : positions) to = std::copy(position.begin(), position.end(), to);
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
