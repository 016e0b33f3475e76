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

/// As many as there are cores and memory for the frames that wait.
std::size_t workersFor(const RenderOptions& options) {
  constexpr std::size_t mostWorkers = 8;
  constexpr std::size_t mostBytes = 1000000000;
  const std::size_t frameBytes = 2 * sizeof(float) * 4 * static_cast<std::size_t>(options.width) *
                                 static_cast<std::size_t>(options.height);
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  return std::clamp<std::size_t>(mostBytes / frameBytes, 1, std::min(mostWorkers, cores));
}

/// Submits ahead as far as the renderer allows. Returns how many frames were there already.
std::size_t renderFrames(Renderer& renderer, const FilmOrder& order, FrameWriter& writer) {
  Progress progress(order.frames.count(), order.quiet);
  RenderOptions options = order.options;
  const std::vector<Aov> aovs{order.aov};
  std::deque<int> underWay;
  std::size_t skipped = 0;
  const auto showProgress = [&] { progress.show(writer.written() + skipped, skipped); };
  const auto collectOldest = [&] {
    Frame frame = writer.take();
    renderer.collect(frame);
    writer.push(underWay.front(), std::move(frame));
    underWay.pop_front();
    showProgress();
  };
  for (int frame = order.frames.first; frame <= order.frames.last; ++frame) {
    if (isThere(order, frame)) {
      ++skipped;
      showProgress();
      continue;
    }
    if (underWay.size() == Renderer::framesInFlight) collectOldest();
    options.seconds = order.frames.seconds(frame);
    renderer.submit(options, aovs);
    underWay.push_back(frame);
  }
  while (!underWay.empty()) collectOldest();
  writer.finish();
  showProgress();
  return skipped;
}

std::size_t renderFiles(Renderer& renderer, const FilmOrder& order) {
  FrameWriter writer(workersFor(order.options), [&](int number, const Frame& frame) {
    writePicture(fileOf(order.output, number), frame.images.at(0), order.tone);
  });
  return renderFrames(renderer, order, writer);
}

void encodeFilm(Renderer& renderer, const FilmOrder& order, const fs::path& file) {
  core::ToneOptions tone = order.tone;
  if (!tone.background) tone.background = Rgb{0, 0, 0};  // a film has no alpha
  FilmEncoder encoder(file, order.options.width, order.options.height, order.frames.perSecond);
  FrameWriter writer(
      1, [&](int, const Frame& frame) { encoder.add(core::toneMap(frame.images.at(0), tone)); });
  renderFrames(renderer, order, writer);
  encoder.finish();
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

bool isThere(const FilmOrder& order, int frame) {
  return order.resume &&
         core::isWholeImage(fileOf(order.output, frame), order.options.width, order.options.height);
}

std::size_t renderFilm(Renderer& renderer, const FilmOrder& order) {
  if (!isFilm(order.output)) return renderFiles(renderer, order);
  core::writeWhole(order.output,
                   [&](const fs::path& temporary) { encodeFilm(renderer, order, temporary); });
  return 0;
}

}  // namespace opaline::app
