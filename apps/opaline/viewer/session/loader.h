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

/// Loads a scene while the window stays alive.
class Loader {
 public:
  /// What came of it: a scene, or the reason why there is none.
  struct Result {
    SceneOptions source;
    std::optional<LoadedScene> loaded;
    std::vector<std::string> notes;
    std::string error;
  };

  /// `whenDone` is called from another thread.
  explicit Loader(std::function<void()> whenDone) : whenDone_(std::move(whenDone)) {}
  ~Loader();
  Loader(const Loader&) = delete;
  Loader& operator=(const Loader&) = delete;

  /// Waits for the scene that is being loaded, if any, and forgets it.
  void start(const SceneOptions& source);
  bool busy() const { return thread_.joinable(); }
  /// Of what is being loaded.
  std::string name() const { return result_.source.name(); }
  /// The result, once.
  std::optional<Result> take();

 private:
  std::function<void()> whenDone_;
  std::thread thread_;
  std::atomic<bool> done_ = false;
  Result result_;
};

}  // namespace opaline::app::viewer
