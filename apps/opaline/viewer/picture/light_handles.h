#pragma once

#include <imgui.h>

#include <glm/vec2.hpp>

#include "viewer/picture/projection.h"
#include "viewer/session/session.h"

namespace opaline::app::viewer {

/// Lights as handles in the picture. A directional light stands on a sphere about the camera's
/// target and is dragged along it, past its rim to the other side; a point light where it is, and
/// is dragged parallel to the picture.
class LightHandles {
 public:
  /// The light whose handle lies there, or -1.
  int at(const Session& session, const Projection& projection, const glm::vec2& pixel) const;

  void grab(const Session& session, const Projection& projection, int light);
  /// Moves the light that was grabbed; true where it did.
  bool drag(Session& session, const Projection& projection, const glm::vec2& pixel) const;
  void release() { grabbed_ = -1; }
  bool isGrabbed() const { return grabbed_ >= 0; }

  void draw(const Session& session, const Projection& projection, ImDrawList& list) const;

 private:
  int grabbed_ = -1;
  bool inFront_ = true;  // of the target, when it was grabbed
};

}  // namespace opaline::app::viewer
