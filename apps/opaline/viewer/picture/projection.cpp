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
      tangent_(std::tan(camera.verticalFovDegrees * std::numbers::pi_v<float> / 360)) {}

std::optional<glm::vec2> Projection::toWindow(const glm::vec3& placeMm) const {
  const glm::vec3 offset = placeMm - view_.position;
  const float depth = glm::dot(offset, view_.ahead);
  if (!(depth > 1e-6F * view_.distanceMm)) return std::nullopt;
  const float half = 0.5F * static_cast<float>(area_.height);
  const float scale = half / (depth * tangent_);
  return glm::vec2(static_cast<float>(area_.x) + 0.5F * static_cast<float>(area_.width) +
                       scale * glm::dot(offset, view_.right),
                   static_cast<float>(area_.y) + half - scale * glm::dot(offset, view_.up));
}

Ray Projection::through(const glm::vec2& pixel) const {
  const float half = 0.5F * static_cast<float>(area_.height);
  const float x =
      (pixel.x - static_cast<float>(area_.x) - 0.5F * static_cast<float>(area_.width)) / half;
  const float y = (static_cast<float>(area_.y) + half - pixel.y) / half;
  return {view_.position,
          glm::normalize(view_.ahead + tangent_ * (x * view_.right + y * view_.up))};
}

float Projection::pixelMm(float depthMm) const {
  return 2 * depthMm * tangent_ / static_cast<float>(area_.height);
}

}  // namespace opaline::app::viewer
