#pragma once

#include <vector>

#include "viewer/files/saver.h"
#include "viewer/panels/timing_history.h"
#include "viewer/picture/light_handles.h"
#include "viewer/picture/overlay.h"
#include "viewer/picture/picture_painter.h"
#include "viewer/session/session.h"
#include "viewer/session/truth_view.h"
#include "viewer/session/undo_list.h"
#include "viewer/window/window.h"

namespace opaline::app::viewer {

/// Everything beside and over the picture, and the window's keys, by Dear ImGui.
class Dashboard {
 public:
  explicit Dashboard(bool panels) : panels_(panels) {}

  /// Whether the panels are visible.
  bool panels() const { return panels_; }
  /// The area that they leave to the picture.
  const Area& area() const { return area_; }

  /// To be called first in a frame: places everything.
  void layOut(const Session& session);
  /// Handles the pressed keys, but none while a number is being typed. Keys of a scene need a
  /// scene, and keys of its picture are ignored while a film is made of it.
  void useKeys(const std::vector<KeyPress>& presses, Session& session, bool hasScene, bool filming);
  /// Without a scene, what opens one.
  void drawPanels(Session& session, bool hasScene, const TruthView& truth,
                  const TimingHistory& history, const Saver& saver, const UndoList& undo) const;
  /// Draws what belongs to the picture: scale bar, handles and divider, or the figures of the
  /// truth; and the captions.
  void drawOverPicture(const Session& session, const TruthView& truth, const LightHandles& handles,
                       const std::vector<Caption>& captions) const;
  /// Draws the list of keys, if the user asked for it.
  void drawKeyList() const;

 private:
  static void drawTop(Session& session, const UndoList& undo);

  Area area_;      // of the picture
  int right_ = 0;  // where the panels begin
  bool panels_;
  bool keyList_ = false;
};

}  // namespace opaline::app::viewer
