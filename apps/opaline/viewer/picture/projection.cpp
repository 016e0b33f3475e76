#include "viewer/picture/projection.h"

#include <cmath>
#include <numbers>

#include "viewer/picture/vectors.h"

namespace opaline::app::viewer {

ViewFrame::ViewFrame(const Camera& camera) : position(toGlm(camera.positionMm)) {
  const glm::vec3 towards = toGlm(camera.targetMm) - position;
  distanceMm = glm::length(towards);
  ahead = towards / distanceMm;
  glm::vec3 across = glm::cross(ahead, toGlm(camera.up));
  if (glm::dot(across, across) < 1e-12F) {
    across = glm::cross(ahead, std::abs(ahead.x) < 0.9F ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1));
  }
  right = glm::normalize(across);
  up = glm::cross(right, ahead);
}

Projection::Projection(const Camera& camera, const Area& area)
    : view_(camera),
      area_(area),
      tangent_(std::tan(camera.verticalFovDegrees * std::numbers::pi_v<float> / 360)),
      orthographicHeightMm_(camera.orthographicHeightMm),
      middle_(
          static_cast<float>(area.x) + static_cast<float>(area.width) * (0.5F - camera.shiftX),
          static_cast<float>(area.y) + static_cast<float>(area.height) * (0.5F + camera.shiftY)) {}

std::optional<glm::vec2> Projection::toWindow(const glm::vec3& placeMm) const {
  const glm::vec3 offset = placeMm - view_.position;
  const float depth = glm::dot(offset, view_.ahead);
  if (!(depth > 1e-6F * view_.distanceMm)) return std::nullopt;
  const float scale = 1 / pixelMm(depth);
  return middle_ + scale * glm::vec2(glm::dot(offset, view_.right), -glm::dot(offset, view_.up));
}

Ray Projection::through(const glm::vec2& pixel) const {
  const glm::vec2 asideMm = pixelMm(1) * (pixel - middle_);
  const glm::vec3 aside = asideMm.x * view_.right - asideMm.y * view_.up;
  if (orthographicHeightMm_) return {view_.position + aside, view_.ahead};
  return {view_.position, glm::normalize(view_.ahead + aside)};
}

float Projection::pixelMm(float depthMm) const {
  return orthographicHeightMm_.value_or(2 * depthMm * tangent_) / static_cast<float>(area_.height);
}

}  // namespace opaline::app::viewer
