#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cli/child_process.h"
#include "opaline/image_file.h"

namespace opaline::app {

/// Throws Error with a remedy when the program ffmpeg is missing.
void requireFfmpeg();

/// A sentence about what becomes of a film of an odd size; none for an even one.
std::optional<std::string> noteOnFilmSize(int width, int height);

/// Makes a film of H.264 in yuv420p, which everything plays, by the program ffmpeg. That format
/// halves the resolution of colour, so an odd size gets its last row or column twice.
class FilmEncoder {
 public:
  FilmEncoder(const std::filesystem::path& file, int width, int height, double framesPerSecond);

  /// Adds a picture, whose colours are used unchanged: pixels without background are on black.
  /// Throws Error.
  void add(const Image8& picture);
  /// Completes the film. Throws Error if that fails.
  void finish();
  /// Gives the film up, and ends an add() on another thread too.
  void abandon() { ffmpeg_.kill(); }

 private:
  [[noreturn]] void fail();

  int width_;   ///< even
  int height_;  ///< even
  ChildProcess ffmpeg_;
  std::string rgb_;
};

}  // namespace opaline::app
