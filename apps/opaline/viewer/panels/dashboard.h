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

/// What stands beside the picture and over it, and the keys of the window, by Dear ImGui.
class Dashboard {
 public:
  explicit Dashboard(bool panels) : panels_(panels) {}

  /// Whether the panels are to be seen.
  bool panels() const { return panels_; }
  /// What they leave to the picture.
  const Area& area() const { return area_; }

  /// First in a frame: where everything stands.
  void layOut(const Session& session);
  /// The keys that were pressed; those of a scene only where there is one, and those of its picture
  /// only while no film is made of it. None while a number is being typed.
  void useKeys(const std::vector<KeyPress>& presses, Session& session, bool hasScene, bool filming);
  void drawPanels(Session& session, const TruthView& truth, const TimingHistory& history,
                  const Saver& saver, const UndoList& undo) const;
  /// What belongs to the picture that is shown: scale bar, handles and divider, or the figures of
  /// the truth; and the captions.
  void drawOverPicture(const Session& session, const TruthView& truth, const LightHandles& handles,
                       const std::vector<Caption>& captions) const;
  /// The list of keys, while it was asked for.
  void drawKeyList() const;

 private:
  static void drawTop(Session& session, const UndoList& undo);

  Area area_;      // of the picture
  int right_ = 0;  // where the panels begin
  bool panels_;
  bool keyList_ = false;
};

}  // namespace opaline::app::viewer
