#include "viewer/picture/orbit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "viewer/picture/projection.h"
#include "viewer/picture/vectors.h"

namespace opaline::app::viewer {

namespace {

float radians(float degrees) {
  return degrees * std::numbers::pi_v<float> / 180;
}

}  // namespace

void orbit(Camera& camera, float yaw, float pitch) {
  const glm::vec3 up = glm::normalize(toGlm(camera.up));
  const glm::vec3 from = toGlm(camera.positionMm) - toGlm(camera.targetMm);
  const float distance = glm::length(from);
  // Works in spherical coordinates about the camera's up.
  const glm::vec3 across = ViewFrame(camera).right;
  const glm::vec3 ahead = glm::cross(across, up);  // horizontal, away from the camera
  constexpr float highest = 1.55F;
  const float present = std::asin(std::clamp(glm::dot(from, up) / distance, -1.0F, 1.0F));
  const float elevation = std::clamp(present + pitch, -highest, highest);
  const glm::vec3 level = -std::cos(yaw) * ahead - std::sin(yaw) * across;
  const glm::vec3 direction = std::cos(elevation) * level + std::sin(elevation) * up;
  camera.positionMm = fromGlm(toGlm(camera.targetMm) + distance * direction);
}

void pan(Camera& camera, float right, float up) {
  const ViewFrame view(camera);
  const float heightMm = camera.orthographicHeightMm.value_or(
      2 * view.distanceMm * std::tan(radians(camera.verticalFovDegrees) / 2));
  const glm::vec3 by = heightMm * (right * view.right + up * view.up);
  camera.positionMm = fromGlm(toGlm(camera.positionMm) + by);
  camera.targetMm = fromGlm(toGlm(camera.targetMm) + by);
}

void dolly(Camera& camera, float factor, float diagonalMm) {
  const glm::vec3 target = toGlm(camera.targetMm);
  const glm::vec3 from = toGlm(camera.positionMm) - target;
  const float distance = glm::length(from);
  const float wanted = std::clamp(distance * factor, 0.02F * diagonalMm, 50 * diagonalMm);
  camera.positionMm = fromGlm(target + wanted / distance * from);
}

}  // namespace opaline::app::viewer
