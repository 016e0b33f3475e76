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
  std::size_t skipped = 0;  ///< were there before
  std::size_t total = 0;

  double share() const {
    return static_cast<double>(written + skipped) / static_cast<double>(total);
  }
};

/// A film that is made a few frames at a time, by a program that has a renderer and other things to
/// do in between. It borrows that renderer, which has to outlive it, rather than have one on a
/// thread of its own, as a device works on one thing at a time anyway, and a second copy of the
/// scene might not fit its memory; pictures are written and encoded on other threads meanwhile.
///
/// Going away before it is done, it leaves no film; pictures that are there are whole.
class FilmJob {
 public:
  /// Throws Error when the output cannot be written or ffmpeg is not there.
  explicit FilmJob(FilmOrder order);

  /// Renders that many of the frames that are missing, always with the same renderer. With the last
  /// one it waits until everything is written. Throws Error when a frame cannot be rendered or
  /// written; nothing but going away is left to the job then.
  void step(Renderer& renderer, std::size_t frames = 1,
            const std::function<void(const FilmProgress&)>& progress = {});

  bool isDone() const { return done_; }
  /// Where the film is, once it is done.
  const std::filesystem::path& file() const { return output_.file(); }
  FilmProgress progress() const;
  /// After the first frame that was rendered.
  RenderReport report() const { return view_->report(); }

 private:
  FilmOrder order_;
  std::optional<View> view_;  // in the renderer that makes it

  FilmOutput output_;
  int next_;
  std::size_t skipped_ = 0;
  bool done_ = false;
};

}  // namespace opaline::app
