#include "viewer/session/undo_list.h"

#include <utility>

namespace opaline::app::viewer {

void UndoList::begin(EditState state) {
  states_.clear();
  present_ = 0;
  sound_.reset();
  states_.push_back(std::move(state));
}

void UndoList::add(EditState state) {
  while (canRedo()) states_.pop_back();
  if (sound_ >= states_.size()) sound_.reset();  // it was undone
  states_.push_back(std::move(state));
  present_ = states_.size() - 1;
  if (states_.size() <= most) return;
  states_.pop_front();
  --present_;
  if (sound_) sound_ = *sound_ > 0 ? std::optional(*sound_ - 1) : std::nullopt;
}

void UndoList::undo() {
  if (canUndo()) --present_;
}

void UndoList::redo() {
  if (canRedo()) ++present_;
}

bool UndoList::takeBack() {
  if (!sound_) return false;
  present_ = *sound_;
  while (canRedo()) states_.pop_back();
  return true;
}

}  // namespace opaline::app::viewer
