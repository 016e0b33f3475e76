#include "film/film_output.h"

#include <algorithm>
#include <exception>
#include <thread>

#include "cli/frame_names.h"
#include "cli/paths.h"
#include "opaline/error.h"
#include "opaline/image_file.h"

namespace opaline::app {

namespace fs = std::filesystem;

namespace {

/// As many threads as there are cores, and memory for the frames that wait.
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

fs::path writePicture(const Target& target, const Image& image, const ToneOptions& tone,
                      std::string_view note) {
  return extensionOf(target.path) == ".exr" ? writeExr(target, image, note)
                                            : writePng(target, toneMap(image, tone), note);
}

FilmOutput::FilmOutput(const FilmOrder& order) : path_(order.output.path) {
  if (isFilm(path_)) {
    startFilm(order);
    return;
  }
  writer_.emplace(workersFor(order.options), [output = order.output, tone = order.tone,
                                              stamp = order.stamp](int number, const Frame& frame) {
    writePicture({fileOf(output.path, number), output.existing}, frame.images.at(0), tone,
                 stamp ? stamp(number) : "");
  });
}

void FilmOutput::startFilm(const FilmOrder& order) {
  ToneOptions tone = order.tone;
  if (!tone.background) tone.background = Rgb{0, 0, 0};  // a film has no alpha
  file_.emplace(order.output);
  encoder_.emplace(file_->temporary(), order.options.width, order.options.height,
                   order.frames.perSecond);
  writer_.emplace(1, [this, tone](int, const Frame& frame) {
    try {
      encoder_->add(toneMap(frame.images.at(0), tone));
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
  path_ = file_->keep();
}

}  // namespace opaline::app
