#include "viewer/session/render_notes.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "viewer/session/control_names.h"

namespace opaline::app::viewer {

LogCallback RenderNotes::taker(LogCallback further) {
  return [this, further = std::move(further)](LogLevel level, std::string_view message) {
    if (level == LogLevel::Note) {
      const std::scoped_lock lock(mutex_);
      if (coarse_) return;
      std::string note = withControlNames(message);
      if (std::find(notes_.begin(), notes_.end(), note) == notes_.end())
        notes_.push_back(std::move(note));
    }
    if (further) further(level, message);
  };
}

void RenderNotes::follow(const RenderOptions& options, bool coarse) {
  const std::scoped_lock lock(mutex_);
  coarse_ = coarse;
  // Another budget makes the scene's resources anew, and with them all notes.
  if (!coarse && std::exchange(maxClusters_, options.maxClusters) != options.maxClusters)
    notes_.clear();
}

void RenderNotes::clear() {
  const std::scoped_lock lock(mutex_);
  notes_.clear();
}

std::vector<std::string> RenderNotes::all() const {
  const std::scoped_lock lock(mutex_);
  return notes_;
}

}  // namespace opaline::app::viewer
