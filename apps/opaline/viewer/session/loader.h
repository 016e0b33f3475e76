#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "cli/scene_options.h"

namespace opaline::app::viewer {

/// Loads a scene on another thread, so that the window stays alive.
class Loader {
 public:
  /// A loaded scene, or the reason why there is none.
  struct Result {
    SceneOptions source;
    std::optional<LoadedScene> loaded;
    std::vector<std::string> notes;
    std::string error;
  };

  /// `whenDone` is called on another thread.
  explicit Loader(std::function<void()> whenDone) : whenDone_(std::move(whenDone)) {}
  ~Loader();
  Loader(const Loader&) = delete;
  Loader& operator=(const Loader&) = delete;

  /// Starts loading. Waits for a scene that is still being loaded, if any, and drops it.
  void start(const SceneOptions& source);
  bool busy() const { return thread_.joinable(); }
  /// The name of the scene being loaded.
  std::string name() const { return result_.source.name(); }
  /// The result, handed out once.
  std::optional<Result> take();

 private:
  std::function<void()> whenDone_;
  std::thread thread_;
  std::atomic<bool> done_ = false;
  Result result_;
};

}  // namespace opaline::app::viewer
