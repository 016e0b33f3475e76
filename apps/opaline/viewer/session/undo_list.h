#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "viewer/session/edit_state.h"

namespace opaline::app::viewer {

/// The states that a session went through, and which of them is the present one.
class UndoList {
 public:
  static constexpr std::size_t most = 200;  ///< states; the oldest are dropped

  /// Drops all states and begins with this one.
  void begin(EditState state);
  /// Adds the state after an edit. States that were undone are dropped.
  void add(EditState state);

  bool isEmpty() const { return states_.empty(); }
  bool canUndo() const { return present_ > 0; }
  bool canRedo() const { return present_ + 1 < states_.size(); }
  /// Goes one state back or forward, where there is one.
  void undo();
  void redo();

  /// Notes that the present state is being rendered.
  void markTried() { tried_ = present_; }
  /// Notes that this has succeeded.
  void markSound() { sound_ = tried_; }
  bool isSound() const { return sound_ == present_; }
  /// To be called when the present state cannot be rendered: goes back to the last one that could,
  /// and drops all later ones. False where there is none.
  bool takeBack();
  /// Requires that there is a state.
  const EditState& present() const { return states_[present_]; }

 private:
  std::deque<EditState> states_;
  std::size_t present_ = 0;
  std::optional<std::size_t> tried_;  // the last state that was to be rendered, while listed
  std::optional<std::size_t> sound_;  // the last state that could be rendered, while listed
};

}  // namespace opaline::app::viewer
