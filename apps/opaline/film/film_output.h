#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string_view>

#include "film/film.h"
#include "film/film_encoder.h"
#include "film/frame_writer.h"
#include "opaline/file.h"
#include "opaline/renderer.h"
#include "opaline/tone.h"

namespace opaline::app {

bool isFilm(const std::filesystem::path& output);

/// Writes an image, as EXR unchanged or as PNG after the tone curve, with a note in it. Returns its
/// path.
std::filesystem::path writePicture(const Target& target, const Image& image,
                                   const ToneOptions& tone, std::string_view note = {});

/// Turns rendered frames into pictures or a film on threads of its own. An unfinished film leaves
/// no file. A picture is either whole or absent.
class FilmOutput {
 public:
  /// Throws Error when a film cannot be written or ffmpeg is missing.
  explicit FilmOutput(const FilmOrder& order);
  ~FilmOutput();
  FilmOutput(const FilmOutput&) = delete;
  FilmOutput& operator=(const FilmOutput&) = delete;

  /// As FrameWriter.
  Frame take() { return writer_->take(); }
  void push(int number, Frame frame) { writer_->push(number, std::move(frame)); }
  std::size_t written() const { return writer_->written(); }
  /// Waits until all frames are written. Throws the first error of writing them.
  void flush() { writer_->finish(); }
  /// The same, and completes a film. Nothing more can be pushed.
  void finish();
  /// The path of a finished film; until then the name that the order gave.
  const std::filesystem::path& file() const { return path_; }

 private:
  void startFilm(const FilmOrder& order);

  std::filesystem::path path_;
  // Members are used by those that follow, and so destroyed after them.
  std::optional<WholeFile> file_;
  std::optional<FilmEncoder> encoder_;
  std::optional<FrameWriter> writer_;
};

}  // namespace opaline::app
