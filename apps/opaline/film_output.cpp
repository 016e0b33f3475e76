#include "film_output.h"

#include <algorithm>
#include <exception>
#include <thread>

#include "core/image_file.h"
#include "frame_names.h"
#include "opaline/error.h"
#include "paths.h"

namespace opaline::app {

namespace fs = std::filesystem;

namespace {

/// As many as there are cores and memory for the frames that wait.
std::size_t workersFor(const RenderOptions& options) {
  constexpr std::size_t mostWorkers = 8;
  constexpr std::size_t mostBytes = 1000000000;
  const std::size_t frameBytes = 2 * sizeof(float) * 4 * static_cast<std::size_t>(options.width) *
                                 static_cast<std::size_t>(options.height);
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  return std::clamp<std::size_t>(mostBytes / frameBytes, 1, std::min(mostWorkers, cores));
}

}  // namespace

bool isFilm(const fs::path& output) {
  return extensionOf(output) == ".mp4";
}

fs::path fileOf(const fs::path& output, int frame) {
  const std::optional<FrameNames> names = FrameNames::parse(output.string());
  return names ? names->file(frame) : output;
}

void writePicture(const fs::path& file, const Image& image, const core::ToneOptions& tone) {
  if (extensionOf(file) == ".exr") {
    core::writeExr(file, image);
  } else {
    core::writePng(file, core::toneMap(image, tone));
  }
}

FilmOutput::FilmOutput(const fs::path& output, const RenderOptions& options, double framesPerSecond,
                       const core::ToneOptions& tone) {
  if (isFilm(output)) {
    startFilm(output, options, framesPerSecond, tone);
    return;
  }
  writer_.emplace(workersFor(options), [output, tone](int number, const Frame& frame) {
    writePicture(fileOf(output, number), frame.images.at(0), tone);
  });
}

void FilmOutput::startFilm(const fs::path& output, const RenderOptions& options,
                           double framesPerSecond, core::ToneOptions tone) {
  if (!tone.background) tone.background = Rgb{0, 0, 0};  // a film has no alpha
  file_.emplace(output);
  encoder_.emplace(file_->temporary(), options.width, options.height, framesPerSecond);
  writer_.emplace(1, [this, tone](int, const Frame& frame) {
    try {
      encoder_->add(core::toneMap(frame.images.at(0), tone));
    } catch (const Error&) {
      throw;
    } catch (const std::exception& failure) {
      file_->fail(failure.what());
    }
  });
}

FilmOutput::~FilmOutput() {
  if (encoder_) encoder_->abandon();
}

void FilmOutput::finish() {
  flush();
  if (!file_) return;
  try {
    encoder_->finish();
  } catch (const Error&) {
    throw;
  } catch (const std::exception& failure) {
    file_->fail(failure.what());
  }
  encoder_.reset();
  file_->keep();
}

}  // namespace opaline::app
