#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "opaline/log.h"
#include "opaline/render_options.h"

namespace opaline::app::viewer {

/// What the renderer notes about the scene that the window shows, in the window's words.
/// Thread-safe.
class RenderNotes {
 public:
  /// A callback for the renderer, whose messages also go to `further`. Must not outlive this.
  LogCallback taker(LogCallback further);
  /// To be called before a picture is made. Notes on a `coarse` picture, which only lasts while
  /// something moves, go nowhere.
  void follow(const RenderOptions& options, bool coarse);
  /// Drops all, because another scene will be set.
  void clear();

  std::vector<std::string> all() const;

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> notes_;
  std::optional<int> maxClusters_;  // of which the notes speak
  bool coarse_ = false;
};

}  // namespace opaline::app::viewer
