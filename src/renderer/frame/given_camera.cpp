#include "renderer/frame/given_camera.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "opaline/error.h"

namespace opaline {

namespace {

glm::dmat4 matrixOf(const Matrix& columns) {
  return glm::dmat4(glm::make_mat4(columns.data()));
}

bool isFinite(const glm::dmat4& matrix) {
  const double* values = glm::value_ptr(matrix);
  return std::all_of(values, values + 16, [](double v) { return std::isfinite(v); });
}

}  // namespace

GivenCamera makeGivenCamera(const CameraMatrices& matrices, const Vec3& originMm, int width,
                            int height) {
  const glm::dmat4 fromOrigin =
      glm::translate(glm::dmat4(1), glm::dvec3(originMm[0], originMm[1], originMm[2]));
  const glm::dmat4 clip =
      matrixOf(matrices.viewToClip) * matrixOf(matrices.worldToView) * fromOrigin;
  const glm::dvec2 jitter(matrices.jitterPixels[0], matrices.jitterPixels[1]);
  if (!isFinite(clip) || !std::isfinite(jitter.x) || !std::isfinite(jitter.y))
    throw UsageError("CameraMatrices: a number is not finite");
  const glm::dmat4 rows = glm::transpose(clip);
  const glm::dvec4 w = rows[3];
  const glm::dvec4 x = rows[0] + 2 * jitter.x / width * w;
  const glm::dvec4 y = rows[1] + 2 * jitter.y / height * w;
  // All lines of sight meet where x, y and w are 0.
  const glm::dmat3 directions =
      glm::transpose(glm::dmat3(glm::dvec3(x), glm::dvec3(y), glm::dvec3(w)));
  const double volume = glm::determinant(directions);
  const double edges =
      glm::length(glm::dvec3(x)) * glm::length(glm::dvec3(y)) * glm::length(glm::dvec3(w));
  if (!(std::abs(volume) > 1e-9 * edges))
    throw UsageError("CameraMatrices: viewToClip is no perspective of what worldToView shows");
  const glm::dvec3 position = glm::inverse(directions) * -glm::dvec3(x.w, y.w, w.w);

  GivenCamera camera;
  camera.view.position = position;
  camera.view.axis = glm::normalize(glm::dvec3(w));
  camera.view.worldToClip =
      glm::transpose(glm::mat4(glm::vec4(x), glm::vec4(y), glm::vec4(0, 0, 0, 1), glm::vec4(w)));
  camera.depth = {.clipDepth = glm::vec4(rows[2]),
                  .clipW = glm::vec4(w),
                  // Depth is a + b over the distance along the axis, b the row's value there.
                  .isReversed = glm::dot(rows[2], glm::dvec4(position, 1)) > 0};
  return camera;
}

}  // namespace opaline
