#pragma once

#include <imgui.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "viewer/picture/projection.h"
#include "viewer/session/area_lights.h"
#include "viewer/session/session.h"

namespace opaline::app::viewer {

/// What of a light one holds by a handle.
enum class LightPart { Place, Aim, Grip };

struct LightHandle {
  int light = -1;  ///< in the window's list
  LightPart part = LightPart::Place;
  glm::vec3 placeMm{};
  AreaGrip::Kind grip = AreaGrip::Kind::U;
};

/// Lights as handles in the picture. A directional light stands on a sphere about the camera's
/// target and is dragged along it, past its rim to the other side; other lights stand where they
/// are, and are dragged parallel to the picture. A spot light that is selected has another handle
/// where it aims, and an area light some that turn and resize it. Suns of the environment are
/// marked on the sphere, and turn with the environment.
class LightHandles {
 public:
  /// The handle that lies there.
  std::optional<LightHandle> at(const Session& session, const Projection& projection,
                                const glm::vec2& pixel) const;

  void grab(const Session& session, const Projection& projection, const LightHandle& handle);
  /// Moves the light that was grabbed; true where it did.
  bool drag(Session& session, const Projection& projection, const glm::vec2& pixel) const;
  void release() { grabbed_.reset(); }

  void draw(const Session& session, const Projection& projection, ImDrawList& list) const;

 private:
  std::optional<LightHandle> grabbed_;
  bool inFront_ = true;  // of the target, when it was grabbed
};

}  // namespace opaline::app::viewer
