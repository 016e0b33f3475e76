#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "film_job.h"
#include "opaline/renderer.h"
#include "viewer/session.h"

namespace opaline::app::viewer {

/// Writes what the window shows: picture, scene, film. Each throws Error where that fails, and
/// returns a sentence that says what was done.
class Saver {
 public:
  explicit Saver(Renderer& renderer) : renderer_(renderer) {}

  /// .png or .exr, of that many pixels. No frame may be under way.
  std::string savePicture(const Session& session, const std::filesystem::path& file, int width,
                          int height);
  /// .toml, which `opaline render` draws as the picture.
  static std::string saveScene(const Session& session, const std::filesystem::path& file, int width,
                               int height);

  /// From now on step() makes a film of the clip, at 30 frames a second.
  void startFilm(const Session& session, const std::filesystem::path& file, int width, int height);
  bool filming() const { return film_.has_value(); }
  /// In [0, 1].
  double progress() const { return film_ ? film_->progress().share() : 0; }
  /// One frame more, no frame being under way; the sentence with the last one.
  std::optional<std::string> step();
  void cancelFilm() { film_.reset(); }

 private:
  Renderer& renderer_;
  std::optional<FilmJob> film_;
  std::filesystem::path filmFile_;
};

}  // namespace opaline::app::viewer
