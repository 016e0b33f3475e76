#include <cmath>
#include <utility>

#include "bssrdf/media.h"
#include "builtin/builtin.h"
#include "opaline/error.h"

namespace opaline {
namespace builtin {

namespace {

constexpr float defaultDiagonalMm = 50;

/// The bear fills its box from top to bottom, more than the default camera sees.
constexpr float bearCameraDiagonals = 1.8F;

Scene sceneOf(const char* name, Mesh mesh, const LoadOptions& options, float cameraDiagonals) {
  const float diagonal = options.diagonalMm.value_or(defaultDiagonalMm);
  if (!(diagonal > 0) || !std::isfinite(diagonal)) {
    throw UsageError("The diagonal of a scene must be a positive number of millimetres.");
  }
  scaleToDiagonal(mesh, diagonal);
  Scene scene;
  scene.name = name;
  const Medium medium = options.medium ? *options.medium : bssrdf::findMedium("marble").value();
  scene.objects.push_back({name, std::move(mesh), medium});
  scene.camera = defaultCamera(scene, {0, 0, 1}, 30, cameraDiagonals);
  scene.lighting = defaultLighting();
  return scene;
}

}  // namespace
}  // namespace builtin

Scene builtInBear(const LoadOptions& options) {
  return builtin::sceneOf("bear", builtin::bearMesh(), options, builtin::bearCameraDiagonals);
}

Scene builtInTeapot(const LoadOptions& options) {
  return builtin::sceneOf("teapot", builtin::teapotMesh(), options, defaultCameraDiagonals);
}

}  // namespace opaline
