#pragma once

#include <cstddef>
#include <deque>
#include <optional>

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

  /// The present state makes a picture.
  void markSound() { sound_ = present_; }
  bool isSound() const { return sound_ == present_; }
  /// The present one makes none: goes to the last that did, and forgets what came after it. False
  /// where none did.
  bool takeBack();
  /// Where there is any.
  const EditState& present() const { return states_[present_]; }

 private:
  std::deque<EditState> states_;
  std::size_t present_ = 0;
  std::optional<std::size_t> sound_;  // the last state that made a picture, while it is here
};

}  // namespace opaline::app::viewer
