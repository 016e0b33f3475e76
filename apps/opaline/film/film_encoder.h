#pragma once

#include <filesystem>
#include <string>

#include "cli/child_process.h"
#include "opaline/image_file.h"

namespace opaline::app {

/// Throws Error with a cure when the program ffmpeg is not there.
void requireFfmpeg();

/// A film of H.264 in yuv420p, which everything plays, made by the program ffmpeg. An odd size gets
/// its last row or column twice, as that format halves the resolution of colour.
class FilmEncoder {
 public:
  FilmEncoder(const std::filesystem::path& file, int width, int height, double framesPerSecond);

  /// Its colours are used as they are: what has no background is on black. Throws Error.
  void add(const Image8& picture);
  /// Throws Error unless the film is whole.
  void finish();
  /// Nobody wants the film any more: ends an add() on another thread, too.
  void abandon() { ffmpeg_.kill(); }

 private:
  [[noreturn]] void fail();

  int width_;   ///< even
  int height_;  ///< even
  ChildProcess ffmpeg_;
  std::string rgb_;
};

}  // namespace opaline::app
