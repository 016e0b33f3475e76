#include "film.h"

#include "core/file.h"
#include "core/image_file.h"
#include "film_encoder.h"
#include "film_job.h"
#include "film_output.h"
#include "progress.h"

namespace opaline::app {

namespace fs = std::filesystem;

bool isThere(const FilmOrder& order, int frame) {
  return order.resume &&
         core::isWholeImage(fileOf(order.output, frame), order.options.width, order.options.height);
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
  FilmJob job(order);
  Progress bar(order.frames.count(), order.quiet);
  job.step(renderer, order.frames.count(), [&](const FilmProgress& progress) {
    bar.show(progress.written + progress.skipped, progress.skipped);
  });
  return order.frames.count() - job.progress().skipped;
}

}  // namespace opaline::app
