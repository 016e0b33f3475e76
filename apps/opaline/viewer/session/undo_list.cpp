#include "viewer/session/undo_list.h"

#include <utility>

namespace opaline::app::viewer {

void UndoList::begin(EditState state) {
  states_.clear();
  present_ = 0;
  tried_ = sound_ = std::nullopt;
  states_.push_back(std::move(state));
}

void UndoList::add(EditState state) {
  while (canRedo()) states_.pop_back();
  for (std::optional<std::size_t>* noted : {&tried_, &sound_})
    if (*noted >= states_.size()) noted->reset();  // it was undone
  states_.push_back(std::move(state));
  present_ = states_.size() - 1;
  if (states_.size() <= most) return;
  states_.pop_front();
  --present_;
  for (std::optional<std::size_t>* noted : {&tried_, &sound_})
    if (*noted) *noted = **noted > 0 ? std::optional(**noted - 1) : std::nullopt;
}

void UndoList::undo() {
  if (canUndo()) --present_;
}

void UndoList::redo() {
  if (canRedo()) ++present_;
}

bool UndoList::takeBack() {
  if (!sound_) return false;
  tried_ = sound_;
  present_ = *sound_;
  while (canRedo()) states_.pop_back();
  return true;
}

}  // namespace opaline::app::viewer
