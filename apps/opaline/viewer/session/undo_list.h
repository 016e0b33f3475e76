#pragma once

#include <cstddef>
#include <deque>

#include "viewer/session/edit_state.h"

namespace opaline::app::viewer {

/// The states that a session went through, and which of them it is in.
class UndoList {
 public:
  static constexpr std::size_t most = 200;  ///< states; the oldest are forgotten

  /// Forgets all and begins with this one.
  void begin(EditState state);
  /// An edit led to this one. What was undone is forgotten.
  void add(EditState state);

  bool isEmpty() const { return states_.empty(); }
  bool canUndo() const { return present_ > 0; }
  bool canRedo() const { return present_ + 1 < states_.size(); }
  /// A state back or on, where there is one.
  void undo();
  void redo();
  /// Where there is any.
  const EditState& present() const { return states_[present_]; }

 private:
  std::deque<EditState> states_;
  std::size_t present_ = 0;
};

}  // namespace opaline::app::viewer
