#pragma once

#include <imgui.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "viewer/picture/projection.h"
#include "viewer/session/area_lights.h"
#include "viewer/session/session.h"

namespace opaline::app::viewer {

/// The part of a light that a handle moves.
enum class LightPart { Place, Aim, Grip };

struct LightHandle {
  int light = -1;  ///< in the window's list
  LightPart part = LightPart::Place;
  glm::vec3 placeMm{};
  AreaGrip::Kind grip = AreaGrip::Kind::U;
};

/// How near to a handle's middle it can be grabbed, in pixels.
float reachOfHandles();

/// The radius of the sphere on which directional lights have their handles.
float radiusOfSphereMm(const Session& session, const Projection& projection);

/// Where all handles are while none is dragged.
std::vector<glm::vec3> placesOfHandles(const Session& session, const Projection& projection);

/// Handles for lights in the picture. A directional light is on a sphere about the camera's target.
/// It is dragged along the sphere, and past its rim to the far side. Other lights are at their own
/// places and are dragged parallel to the picture. A selected spot light has another handle at the
/// place that it aims at, and a selected area light has some that turn and resize it. Suns of the
/// environment are marked on the sphere and turn with the environment.
class LightHandles {
 public:
  /// The handle at that pixel; none where there is none. Of handles that lie upon each other, it is
  /// the selected light's.
  std::optional<LightHandle> at(const Session& session, const Projection& projection,
                                const glm::vec2& pixel) const;

  /// Takes hold of a handle at that pixel, which may be beside the handle's middle.
  void grab(const Session& session, const Projection& projection, const LightHandle& handle,
            const glm::vec2& pixel);
  /// Moves the grabbed light as far as the mouse has moved since. True if it moved.
  bool drag(Session& session, const Projection& projection, const glm::vec2& pixel);
  void release() { grabbed_.reset(); }

  void draw(const Session& session, const Projection& projection, ImDrawList& list) const;

 private:
  /// All handles. One that turns a light stays under the mouse while it is dragged.
  std::vector<LightHandle> shown(const Session& session, const Projection& projection) const;

  std::optional<LightHandle> grabbed_;
  glm::vec2 offset_{};   // from the mouse to where it drags, pixels
  bool inFront_ = true;  // whether it was in front of the target when grabbed
};

}  // namespace opaline::app::viewer
