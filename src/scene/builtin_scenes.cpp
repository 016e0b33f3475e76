#include <cmath>
#include <utility>

#include "builtin/builtin.h"
#include "opaline/error.h"
#include "opaline/media.h"
#include "scene/finish.h"

namespace opaline {
namespace builtin {

namespace {

constexpr float defaultDiagonalMm = 50;
/// The bear is so tall for its diagonal that the usual 1.4 diagonals would cut off its ears and
/// feet.
constexpr float bearDistanceDiagonals = 1.8F;

Scene sceneOf(const char* name, Mesh mesh, const LoadOptions& options) {
  const float diagonal = options.diagonalMm.value_or(defaultDiagonalMm);
  if (!(diagonal > 0) || !std::isfinite(diagonal)) {
    throw UsageError("The diagonal of a scene must be a positive number of millimetres.");
  }
  if (options.morphTo) {
    throw UsageError("A built-in scene has no other mesh to morph to; give the model as a file.");
  }
  scaleToDiagonal(mesh, diagonal);
  Scene scene;
  scene.name = name;
  scene.objects.push_back({name, std::move(mesh), findMedium("marble").value()});
  opaline::scene::setMedia(options, scene);
  scene.camera = defaultCamera(scene);
  scene.lighting = defaultLighting();
  return scene;
}

}  // namespace
}  // namespace builtin

Scene builtInBear(const LoadOptions& options) {
  Scene scene = builtin::sceneOf("bear", builtin::bearMesh(), options);
  Camera& camera = scene.camera;
  camera.positionMm = camera.targetMm;
  camera.positionMm[2] += builtin::bearDistanceDiagonals * diagonalMm(scene);
  return scene;
}

Scene builtInTeapot(const LoadOptions& options) {
  return builtin::sceneOf("teapot", builtin::teapotMesh(), options);
}

}  // namespace opaline
