#include "scene/toml/camera.h"

#include "opaline/framing.h"
#include "opaline/options/scene.h"
#include "scene/formats.h"
#include "scene/toml/keys.h"
#include "scene/vector_math.h"

namespace opaline::scene {

namespace {

/// Where the view shows no up, so that pictures take another direction for it.
bool isAlong(const Double3& view, const Vec3& up) {
  const Double3 across = cross(unit(view), unit(toDouble(up)));
  return !(dot(across, across) > 1e-8);
}

Camera usualCamera(const RawScene& scene) {
  Scene box;
  for (const RawObject& object : scene.objects)
    box.objects.push_back({"", {object.mesh.positions, {}, {}}, {}});
  return defaultCamera(box);
}

}  // namespace

void readCamera(const TomlTable& root, const Vec3& centreMm, const LogCallback& log,
                RawScene& scene) {
  const auto table = root.table("camera");
  if (!table) return;
  table->requireKeys(keys::camera);
  const CameraPlace place{placeFrom(*table, "position_mm", centreMm),
                          placeFrom(*table, "target_mm", centreMm), table->direction("direction")};
  if (place.direction && place.positionMm)
    table->fail("direction", "cannot stand beside 'position_mm'");
  Camera camera = scene.camera ? *scene.camera : usualCamera(scene);
  placeCamera(place, camera);
  const Double3 view = toDouble(camera.targetMm) - toDouble(camera.positionMm);
  if (!(length(view) > 0)) table->fail("", "has the same position and target");
  if (const auto up = table->vector("up")) {
    if (*up == Vec3{}) table->fail("up", "must not be zero");
    if (isAlong(view, *up))
      note(log, "'up' in [camera] is parallel to the view, so another direction is up");
    camera.up = *up;
  }
  const options::Chosen<Camera> chosen = chosenIn<Camera>(*table);
  chosen.applyTo(camera);
  if (chosen.has("fov_degrees") && camera.orthographicHeightMm)
    note(log,
         "'fov_degrees' in [camera] is not used, because the camera's lines of sight are parallel; "
         "'orthographic_height_mm' says how much it sees");
  scene.camera = camera;
  for (ClipChanges& changes : scene.changes) changes.cameras.clear();
  scene.cameraChosen = scene.cameraChosen || place.positionMm || place.targetMm || !chosen.empty();
}

}  // namespace opaline::scene
