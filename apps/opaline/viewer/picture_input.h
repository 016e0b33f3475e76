#pragma once

#include "viewer/light_handles.h"
#include "viewer/picture_painter.h"
#include "viewer/projection.h"
#include "viewer/session.h"
#include "viewer/window.h"

namespace opaline::app::viewer {

/// What mouse and keys do to the picture, by Dear ImGui's input of this frame.
class PictureInput {
 public:
  /// Mouse over the picture's area.
  void useMouse(Session& session, const Area& area);
  /// Keys of camera, playback and view.
  static void useKey(const KeyPress& press, Session& session, const Area& area);

  /// Whether something is being dragged, so that pictures should come fast.
  bool dragging() const { return drag_ != Drag::None; }
  const LightHandles& handles() const { return handles_; }

 private:
  enum class Drag { None, Orbit, Pan, Dolly, Light, Divider };

  Drag begin(Session& session, const Projection& projection, const Area& area);
  void go(Session& session, const Projection& projection, const Area& area);

  Drag drag_ = Drag::None;
  LightHandles handles_;
};

}  // namespace opaline::app::viewer
