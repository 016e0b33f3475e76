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

/// Rows of the matrix from millimetres to clip space.
struct Rows {
  glm::dvec4 x;
  glm::dvec4 y;
  glm::dvec4 z;
  glm::dvec4 w;
};

glm::mat4 worldToClip(const Rows& rows, const glm::dvec4& z) {
  return glm::transpose(
      glm::mat4(glm::vec4(rows.x), glm::vec4(rows.y), glm::vec4(z), glm::vec4(rows.w)));
}

// All lines of sight meet where x, y and w are 0.
GivenCamera perspectiveCamera(const Rows& rows) {
  const glm::dvec3 x(rows.x);
  const glm::dvec3 y(rows.y);
  const glm::dvec3 w(rows.w);
  const glm::dmat3 directions = glm::transpose(glm::dmat3(x, y, w));
  const double volume = glm::determinant(directions);
  const double edges = glm::length(x) * glm::length(y) * glm::length(w);
  if (!(std::abs(volume) > 1e-9 * edges))
    throw UsageError("CameraMatrices: viewToClip is not a projection of what worldToView shows");
  const glm::dvec3 position = glm::inverse(directions) * -glm::dvec3(rows.x.w, rows.y.w, rows.w.w);

  GivenCamera camera;
  camera.view.position = position;
  camera.view.axis = glm::normalize(w);
  camera.view.worldToClip = worldToClip(rows, {0, 0, 0, 1});
  camera.depth = {.clipDepth = glm::vec4(rows.z),
                  .clipW = glm::vec4(rows.w),
                  // Depth is a + b / (distance along the axis), where b is the row's value at the
                  // eye.
                  .isReversed = glm::dot(rows.z, glm::dvec4(position, 1)) > 0};
  return camera;
}

// All lines of sight have the direction in which x and y do not change. `eye` is the view's origin.
GivenCamera orthographicCamera(const Rows& rows, const glm::dvec3& eye) {
  const glm::dvec3 x(rows.x);
  const glm::dvec3 y(rows.y);
  const glm::dvec3 z(rows.z);
  const glm::dvec3 along = glm::cross(x, y);
  const double area = glm::length(along);
  const glm::dvec3 axis = along / area;
  const double slope = glm::dot(z, axis);
  if (!(area > 1e-9 * glm::length(x) * glm::length(y)) ||
      !(std::abs(slope) > 1e-9 * glm::length(z)))
    throw UsageError("CameraMatrices: viewToClip is not a projection of what worldToView shows");
  const bool isReversed = slope < 0;
  // How far along the axis the near plane lies, in the middle of the picture.
  const glm::dmat3 directions = glm::transpose(glm::dmat3(x, y, axis));
  const glm::dvec3 middle = glm::inverse(directions) * -glm::dvec3(rows.x.w, rows.y.w, 0);
  const double nearDepth = isReversed ? 1 : 0;
  const double near = (nearDepth - rows.z.w - glm::dot(z, middle)) / slope;

  GivenCamera camera;
  camera.view.position = eye;
  camera.view.axis = axis;
  camera.view.isParallel = true;
  camera.view.worldToClip = worldToClip(rows, {0, 0, 0, near});
  camera.depth = {
      .clipDepth = glm::vec4(rows.z), .clipW = glm::vec4(rows.w), .isReversed = isReversed};
  return camera;
}

}  // namespace

GivenCamera makeGivenCamera(const CameraMatrices& matrices, const Vec3& originMm, int width,
                            int height) {
  const glm::dmat4 fromOrigin =
      glm::translate(glm::dmat4(1), glm::dvec3(originMm[0], originMm[1], originMm[2]));
  const glm::dmat4 view = matrixOf(matrices.worldToView) * fromOrigin;
  const glm::dmat4 clip = matrixOf(matrices.viewToClip) * view;
  const glm::dvec2 jitter(matrices.jitterPixels[0], matrices.jitterPixels[1]);
  if (!isFinite(clip) || !std::isfinite(jitter.x) || !std::isfinite(jitter.y))
    throw UsageError("CameraMatrices: a number is not finite");
  glm::dmat4 rowsOf = glm::transpose(clip);
  const bool isOrthographic = glm::dvec3(rowsOf[3]) == glm::dvec3(0);
  if (isOrthographic) rowsOf /= rowsOf[3].w;
  if (isOrthographic && !isFinite(rowsOf))
    throw UsageError("CameraMatrices: viewToClip is not a projection of what worldToView shows");
  const Rows rows{.x = rowsOf[0] + 2 * jitter.x / width * rowsOf[3],
                  .y = rowsOf[1] + 2 * jitter.y / height * rowsOf[3],
                  .z = rowsOf[2],
                  .w = rowsOf[3]};
  if (!isOrthographic) return perspectiveCamera(rows);
  const glm::dvec4 eye = glm::inverse(view)[3];
  return orthographicCamera(rows, glm::dvec3(eye) / eye.w);
}

}  // namespace opaline
