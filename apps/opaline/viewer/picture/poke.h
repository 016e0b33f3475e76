#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "opaline/renderer.h"
#include "opaline/soft_body.h"
#include "viewer/picture/projection.h"
#include "viewer/session/session.h"

namespace opaline::app::viewer {

/// Lets the mouse pull one body at a time. The body's rest pose is the pose of its rig at the time
/// it was grabbed. The scene's deformers are applied on top.
class Poke {
 public:
  explicit Poke(Renderer& renderer) : renderer_(renderer) {}

  /// Grabs the body that the ray hits; false where it hits none. Clips stop, since the mouse moves
  /// the body now.
  bool grab(Session& session, const Ray& ray);
  /// The grabbed place follows the pixel, in a plane parallel to the picture.
  void pull(const Projection& projection, const glm::vec2& pixel);
  void release();

  /// Notes that time has passed in which the body must move. Cheap.
  void advance(double seconds);
  /// Moves the body on by that time, however long the last picture took. Gives it back to its rig
  /// once it rests. True if the picture changes. Waits for the device.
  bool step();
  /// Gives the body back at once.
  void end();
  /// Whether a body is under the mouse's control.
  bool holdsBody() const { return body_.has_value() || wanted_.has_value(); }
  bool moves() const { return wanted_ || (body_ && (held_ || body_->moves())); }

 private:
  struct Grab {
    std::size_t object = 0;
    std::vector<Vec3> restMm;
    std::vector<Triangle> triangles;
    float radiusMm = 0;
  };

  void take();

  Renderer& renderer_;
  std::optional<SoftBody> body_;
  std::optional<Grab> wanted_;  // to be grabbed at the next step
  double owedSeconds_ = 0;      // time since the last step
  std::size_t object_ = 0;
  bool held_ = false;
  Vec3 goal_{};        // where it is pulled to
  glm::vec3 seen_{};   // the held place, as the picture shows it
  glm::vec3 rest_{};   // the held place before the scene's deformers
  glm::mat3 back_{1};  // maps directions of the picture to the body at rest
};

}  // namespace opaline::app::viewer
