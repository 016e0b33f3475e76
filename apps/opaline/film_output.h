#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "core/file.h"
#include "core/tone.h"
#include "film_encoder.h"
#include "frame_writer.h"
#include "motion_options.h"
#include "opaline/renderer.h"

namespace opaline::app {

bool isFilm(const std::filesystem::path& output);

/// Where a frame goes: the output itself, or what its mark for the number makes of it.
std::filesystem::path fileOf(const std::filesystem::path& output, int frame);

/// EXR as it is, or PNG after the tone curve.
void writePicture(const std::filesystem::path& file, const Image& image,
                  const core::ToneOptions& tone);

/// Takes rendered frames and makes pictures or a film of them on threads of its own. A film that is
/// not finished leaves no file; pictures are whole or not there.
class FilmOutput {
 public:
  /// Throws Error when a film cannot be written or ffmpeg is not there.
  FilmOutput(const std::filesystem::path& output, const RenderOptions& options,
             double framesPerSecond, const core::ToneOptions& tone);
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

 private:
  void startFilm(const std::filesystem::path& output, const RenderOptions& options,
                 double framesPerSecond, core::ToneOptions tone);

  // What goes first is used by what comes after.
  std::optional<core::WholeFile> file_;
  std::optional<FilmEncoder> encoder_;
  std::optional<FrameWriter> writer_;
};

}  // namespace opaline::app
