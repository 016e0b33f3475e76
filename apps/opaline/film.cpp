#include "film.h"

#include <algorithm>
#include <deque>
#include <optional>
#include <thread>
#include <utility>

#include "core/file.h"
#include "core/image_file.h"
#include "film_encoder.h"
#include "frame_names.h"
#include "frame_writer.h"
#include "opaline/error.h"
#include "paths.h"
#include "progress.h"

namespace opaline::app {

namespace fs = std::filesystem;

namespace {

bool isFilm(const fs::path& output) {
  return extensionOf(output) == ".mp4";
}

fs::path fileOf(const fs::path& output, int frame) {
  const std::optional<FrameNames> names = FrameNames::parse(output.string());
  return names ? names->file(frame) : output;
}

/// Whether the file of that frame need not be made.
bool isThere(const FilmOrder& order, int frame) {
  return order.resume &&
         core::isWholeImage(fileOf(order.output, frame), order.options.width, order.options.height);
}

/// As many as there are cores and memory for the frames that wait.
std::size_t workersFor(const RenderOptions& options) {
  constexpr std::size_t mostWorkers = 8;
  constexpr std::size_t mostBytes = 1000000000;
  const std::size_t frameBytes = 2 * sizeof(float) * 4 * static_cast<std::size_t>(options.width) *
                                 static_cast<std::size_t>(options.height);
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  return std::clamp<std::size_t>(mostBytes / frameBytes, 1, std::min(mostWorkers, cores));
}

/// The frames that were submitted and not collected.
class FramesUnderWay {
 public:
  explicit FramesUnderWay(Renderer& renderer) : renderer_(renderer) {}

  std::size_t count() const { return numbers_.size(); }

  void submit(int number, const RenderOptions& options, const std::vector<Aov>& aovs) {
    renderer_.submit(options, aovs);
    numbers_.push_back(number);
  }

  /// The oldest; returns its number.
  int collect(Frame& frame) {
    const int number = numbers_.front();
    numbers_.pop_front();
    renderer_.collect(frame);
    return number;
  }

 private:
  Renderer& renderer_;
  std::deque<int> numbers_;
};

/// Submits ahead as far as the renderer allows. Returns how many frames were rendered.
std::size_t renderFrames(Renderer& renderer, const FilmOrder& order, FrameWriter& writer) {
  Progress progress(order.frames.count(), order.quiet);
  RenderOptions options = order.options;
  const std::vector<Aov> aovs{order.aov};
  std::size_t skipped = 0;
  const auto showProgress = [&] { progress.show(writer.written() + skipped, skipped); };
  FramesUnderWay underWay(renderer);
  const auto collectOldest = [&] {
    Frame frame = writer.take();
    const int number = underWay.collect(frame);
    writer.push(number, std::move(frame));
    showProgress();
  };
  const auto renderNext = [&](int frame) {
    if (isThere(order, frame)) {
      ++skipped;
      showProgress();
      return;
    }
    if (underWay.count() == Renderer::framesInFlight) collectOldest();
    options.seconds = order.frames.seconds(frame);
    if (order.place) order.place(renderer, frame);
    underWay.submit(frame, options, aovs);
  };
  const auto finish = [&] {
    while (underWay.count() > 0) collectOldest();
    writer.finish();
  };
  try {
    for (int frame = order.frames.first; frame <= order.frames.last; ++frame) renderNext(frame);
  } catch (const Error&) {
    finish();  // what was rendered before is not lost
    throw;
  }
  finish();
  showProgress();
  return order.frames.count() - skipped;
}

std::size_t renderFiles(Renderer& renderer, const FilmOrder& order) {
  FrameWriter writer(workersFor(order.options), [&](int number, const Frame& frame) {
    writePicture(fileOf(order.output, number), frame.images.at(0), order.tone);
  });
  return renderFrames(renderer, order, writer);
}

std::size_t encodeFilm(Renderer& renderer, const FilmOrder& order, const fs::path& file) {
  core::ToneOptions tone = order.tone;
  if (!tone.background) tone.background = Rgb{0, 0, 0};  // a film has no alpha
  FilmEncoder encoder(file, order.options.width, order.options.height, order.frames.perSecond);
  FrameWriter writer(
      1, [&](int, const Frame& frame) { encoder.add(core::toneMap(frame.images.at(0), tone)); });
  try {
    const std::size_t made = renderFrames(renderer, order, writer);
    encoder.finish();
    return made;
  } catch (...) {
    encoder.abandon();
    throw;
  }
}

}  // namespace

void writePicture(const fs::path& file, const Image& image, const core::ToneOptions& tone) {
  if (extensionOf(file) == ".exr") {
    core::writeExr(file, image);
  } else {
    core::writePng(file, core::toneMap(image, tone));
  }
}

void requireFilmWritable(const fs::path& output, const FrameRange& frames) {
  core::requireWritable(fileOf(output, frames.first));
  if (isFilm(output)) requireFfmpeg();
}

std::vector<std::string> outputsOf(const FilmOrder& order) {
  if (isFilm(order.output)) return {order.output.string()};
  std::vector<std::string> files;
  for (int frame = order.frames.first; frame <= order.frames.last; ++frame) {
    files.push_back(fileOf(order.output, frame).string());
  }
  return files;
}

std::size_t countThere(const FilmOrder& order) {
  std::size_t there = 0;
  if (!order.resume) return there;
  for (int frame = order.frames.first; frame <= order.frames.last; ++frame) {
    if (isThere(order, frame)) ++there;
  }
  return there;
}

std::size_t renderFilm(Renderer& renderer, const FilmOrder& order) {
  if (!isFilm(order.output)) return renderFiles(renderer, order);
  std::size_t made = 0;
  core::writeWhole(order.output, [&](const fs::path& temporary) {
    made = encodeFilm(renderer, order, temporary);
  });
  return made;
}

}  // namespace opaline::app
