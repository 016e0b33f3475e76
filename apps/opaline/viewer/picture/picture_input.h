#pragma once

#include "viewer/picture/light_handles.h"
#include "viewer/picture/picture_painter.h"
#include "viewer/picture/poke.h"
#include "viewer/picture/projection.h"
#include "viewer/session/session.h"
#include "viewer/window/window.h"

namespace opaline::app::viewer {

/// What mouse and keys do to the picture, using Dear ImGui's input of this frame.
class PictureInput {
 public:
  /// Handles the mouse over the picture's area.
  void useMouse(Session& session, const Area& area, Poke& poke);
  /// Handles the keys of camera, playback and view.
  static void useKey(const KeyPress& press, Session& session, const Area& area);

  /// Whether something is being dragged, so that pictures must come fast.
  bool dragging() const { return drag_ != Drag::None; }
  const LightHandles& handles() const { return handles_; }

 private:
  enum class Drag { None, Orbit, Pan, Dolly, Light, Divider, Poke };

  Drag begin(Session& session, const Projection& projection, const Area& area, Poke& poke);
  void go(Session& session, const Projection& projection, const Area& area, Poke& poke);

  Drag drag_ = Drag::None;
  LightHandles handles_;
};

}  // namespace opaline::app::viewer
