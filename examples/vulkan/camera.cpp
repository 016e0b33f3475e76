#include "camera.h"

#include <cmath>

namespace {

using opaline::Matrix;
using opaline::Vec3;

float dot(const Vec3& a, const Vec3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec3 unit(const Vec3& a) {
  const float length = std::sqrt(dot(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}
Matrix product(const Matrix& a, const Matrix& b) {
  Matrix result{};
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      for (int k = 0; k < 4; ++k) result[4 * column + row] += a[4 * k + row] * b[4 * column + k];
  return result;
}

}  // namespace

Camera lookAt(const Vec3& eye, const Vec3& target, float focal, float aspect, float nearMm) {
  const Vec3 forward = unit({target[0] - eye[0], target[1] - eye[1], target[2] - eye[2]});
  const Vec3 right = unit(cross(forward, {0, 1, 0}));
  const Vec3 down = cross(forward, right);
  Camera camera;
  Matrix& view = camera.matrices.worldToView;
  const Vec3 rows[] = {right, down, forward};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) view[4 * column + row] = rows[row][column];
    view[12 + row] = -dot(rows[row], eye);
  }
  view[15] = 1;
  Matrix& clip = camera.matrices.viewToClip;
  clip[0] = focal / aspect;
  clip[5] = focal;
  clip[11] = 1;       // w: the distance along the axis
  clip[14] = nearMm;  // z over w: 1 at the near plane, 0 at infinity
  camera.worldToClip = product(clip, view);
  return camera;
}
