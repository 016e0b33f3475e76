#include "viewer/session/undo_list.h"

#include <utility>

namespace opaline::app::viewer {

void UndoList::begin(EditState state) {
  states_.clear();
  present_ = 0;
  states_.push_back(std::move(state));
}

void UndoList::add(EditState state) {
  while (canRedo()) states_.pop_back();
  states_.push_back(std::move(state));
  if (states_.size() > most) states_.pop_front();
  present_ = states_.size() - 1;
}

void UndoList::undo() {
  if (canUndo()) --present_;
}

void UndoList::redo() {
  if (canRedo()) ++present_;
}

}  // namespace opaline::app::viewer
