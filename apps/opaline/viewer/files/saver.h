#pragma once

#include <filesystem>
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
  explicit Saver(Renderer& renderer) : renderer_(renderer) {}

  /// Saves at that size, where the session says. No frame may be under way. An existing file stays
  /// unless replacing it was confirmed; the next free name is used instead. A film is only begun:
  /// step() then makes it, the motion once at 30 frames a second.
  std::optional<std::string> save(Save wanted, const Session& session, int width, int height);

  bool filming() const { return film_.has_value(); }
  /// In [0, 1].
  double progress() const { return film_ ? film_->progress().share() : 0; }
  /// Makes one more frame; no other may be under way. Returns a sentence with the last one.
  std::optional<std::string> step();
  void cancelFilm() { film_.reset(); }

 private:
  std::string savePicture(const Session& session, const Target& target, int width, int height);
  void startFilm(const Session& session, const Target& target, int width, int height);

  Renderer& renderer_;
  std::optional<FilmJob> film_;
  Target filmTarget_{""};
};

}  // namespace opaline::app::viewer
