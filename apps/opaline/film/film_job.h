#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "film/film.h"
#include "film/film_output.h"
#include "opaline/renderer.h"

namespace opaline::app {

/// How far a film has come, in frames.
struct FilmProgress {
  std::size_t written = 0;
  std::size_t skipped = 0;  ///< existed before
  std::size_t total = 0;

  double share() const {
    return static_cast<double>(written + skipped) / static_cast<double>(total);
  }
};

/// A film that is made a few frames at a time, by a program that has a renderer and other things to
/// do in between. The job borrows that renderer, which must outlive it. A renderer of its own would
/// gain nothing, as a device works on one thing at a time, and a second copy of the scene might not
/// fit its memory. Pictures are written and encoded on other threads meanwhile.
///
/// A job that is destroyed early leaves no film; pictures written so far are whole.
class FilmJob {
 public:
  /// Throws Error when the output cannot be written or ffmpeg is missing.
  explicit FilmJob(FilmOrder order);

  /// Renders that many of the missing frames, always with the same renderer. The last step waits
  /// until everything is written. Throws Error when a frame cannot be rendered or written; the job
  /// can then only be destroyed.
  void step(Renderer& renderer, std::size_t frames = 1,
            const std::function<void(const FilmProgress&)>& progress = {});

  bool isDone() const { return done_; }
  /// The film's path, once it is done.
  const std::filesystem::path& file() const { return output_.file(); }
  FilmProgress progress() const;
  /// Valid after the first rendered frame.
  RenderReport report() const { return view_->report(); }

 private:
  FilmOrder order_;
  std::optional<View> view_;  // belongs to the renderer of step()

  FilmOutput output_;
  int next_;
  std::size_t skipped_ = 0;
  bool done_ = false;
};

}  // namespace opaline::app
