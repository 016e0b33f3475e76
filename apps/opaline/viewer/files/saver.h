#pragma once

#include <filesystem>
#include <future>
#include <optional>
#include <string>

#include "film/film_job.h"
#include "opaline/file.h"
#include "opaline/renderer.h"
#include "viewer/session/session.h"

namespace opaline::app::viewer {

/// Writes what the window shows: picture, scene, film. Its functions throw Error on failure, and
/// return a sentence where something was done.
class Saver {
 public:
  /// `inBackground`: films are rendered by another thread, which nobody else's use of the
  /// renderer's queue may disturb.
  Saver(Renderer& renderer, bool inBackground) : renderer_(renderer), inBackground_(inBackground) {}

  /// Saves at that size, where the session says. No frame may be under way. An existing file stays
  /// unless replacing it was confirmed; the next free name is used instead. A film is only begun:
  /// step() then makes it.
  std::optional<std::string> save(Save wanted, const Session& session, int width, int height);

  /// Whether a film is being made and nobody has stopped it.
  bool filming() const { return film_ && !stopped_; }
  /// Whether the renderer is kept for a film, which may be one that was stopped.
  bool keepsRenderer() const { return film_.has_value(); }
  /// Whether a frame is being made by another thread.
  bool isBusy() const;
  /// In [0, 1].
  double progress() const { return film_ ? film_->progress().share() : 0; }
  /// Makes one more frame, or begins it; no other may be under way. Does nothing while busy.
  /// Returns a sentence after the last one.
  std::optional<std::string> step();
  /// A frame that is under way ends first, and is not waited for.
  void cancelFilm();

 private:
  std::string savePicture(const Session& session, const Target& target, int width, int height);
  void startFilm(const Session& session, const Target& target, int width, int height);
  void stepOn();

  Renderer& renderer_;
  std::optional<FilmJob> film_;
  Target filmTarget_{""};
  std::string filmRemark_;  // on its size
  const bool inBackground_;
  bool stopped_ = false;
  std::future<void> step_;  // last, so that it ends before the film that it makes
};

}  // namespace opaline::app::viewer
