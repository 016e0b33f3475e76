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

/// Lets one body at a time be pulled by the mouse. The body rests where its rig had it when it was
/// taken hold of; the scene's deformers go on on top of it.
class Poke {
 public:
  explicit Poke(Renderer& renderer) : renderer_(renderer) {}

  /// Takes hold of the body that the ray meets; false where it meets none. Clips stop: the body is
  /// the hand's now.
  bool grab(Session& session, const Ray& ray);
  /// The place that is held follows the pixel, in a plane parallel to the picture.
  void pull(const Projection& projection, const glm::vec2& pixel);
  void release();

  /// Time goes by, in which the body is to move. Takes no time itself.
  void advance(double seconds);
  /// Moves the body on by that time, however long the last picture took, and gives it back to its
  /// rig when it has come to rest. True where the picture changes. Waits for the device.
  bool step();
  /// Gives it back at once.
  void end();
  /// Whether a body is the hand's, and nobody else's.
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
  std::optional<Grab> wanted_;  // at the next step
  double owedSeconds_ = 0;      // that went by since the last step
  std::size_t object_ = 0;
  bool held_ = false;
  Vec3 goal_{};        // to which it is pulled
  glm::vec3 seen_{};   // place that is held, where the picture shows it
  glm::vec3 rest_{};   // the same before the scene's deformers
  glm::mat3 back_{1};  // directions there, from those of the picture
};

}  // namespace opaline::app::viewer
