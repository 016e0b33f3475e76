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

/// EXR as it is, or PNG after the tone curve, with a note in it. Returns where it is.
std::filesystem::path writePicture(const Target& target, const Image& image,
                                   const ToneOptions& tone, std::string_view note = {});

/// Takes rendered frames and makes pictures or a film of them on threads of its own. A film that is
/// not finished leaves no file; pictures are whole or not there.
class FilmOutput {
 public:
  /// Throws Error when a film cannot be written or ffmpeg is not there.
  explicit FilmOutput(const FilmOrder& order);
  ~FilmOutput();
  FilmOutput(const FilmOutput&) = delete;
  FilmOutput& operator=(const FilmOutput&) = delete;

  /// As FrameWriter.
  Frame take() { return writer_->take(); }
  void push(int number, Frame frame) { writer_->push(number, std::move(frame)); }
  std::size_t written() const { return writer_->written(); }
  /// Waits until all frames are written. Throws what went wrong.
  void flush() { writer_->finish(); }
  /// The same; then a film is there. Nothing more is taken.
  void finish();
  /// Where a film is, once it is there; else the name that the order gave.
  const std::filesystem::path& file() const { return path_; }

 private:
  void startFilm(const FilmOrder& order);

  std::filesystem::path path_;
  // What goes first is used by what comes after.
  std::optional<WholeFile> file_;
  std::optional<FilmEncoder> encoder_;
  std::optional<FrameWriter> writer_;
};

}  // namespace opaline::app
