#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "opaline/scene.h"
#include "viewer/picture/picture_painter.h"

namespace opaline::app::viewer {

/// A camera's axes: three orthogonal unit vectors.
struct ViewFrame {
  explicit ViewFrame(const Camera& camera);

  glm::vec3 position{};
  glm::vec3 right{};
  glm::vec3 up{};
  glm::vec3 ahead{};
  float distanceMm = 0;  ///< to the target
};

/// A ray in the scene.
struct Ray {
  glm::vec3 origin{};
  glm::vec3 direction{};  ///< unit
};

/// The projection of the scene to an area of the window.
class Projection {
 public:
  Projection(const Camera& camera, const Area& area);

  const ViewFrame& view() const { return view_; }
  const Area& area() const { return area_; }
  /// None for a place behind the camera.
  std::optional<glm::vec2> toWindow(const glm::vec3& placeMm) const;
  Ray through(const glm::vec2& pixel) const;
  /// The size of a pixel at a distance along the viewing axis, in mm.
  float pixelMm(float depthMm) const;

 private:
  ViewFrame view_;
  Area area_;
  float tangent_;  // of half the vertical field of view
  std::optional<float> orthographicHeightMm_;
  glm::vec2 middle_;  // where the window shows the viewing axis
};

}  // namespace opaline::app::viewer
