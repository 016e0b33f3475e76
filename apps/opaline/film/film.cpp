#include "film/film.h"

#include <utility>

#include "cli/frame_names.h"
#include "cli/progress.h"
#include "film/film_encoder.h"
#include "film/film_job.h"
#include "film/film_output.h"
#include "film/picture_stamp.h"
#include "film/sequence_frames.h"
#include "opaline/file.h"
#include "opaline/image_file.h"

namespace opaline::app {

namespace fs = std::filesystem;

namespace {

bool isWhole(const FilmOrder& order, int frame) {
  return isWholeImage(fileOf(order.output.path, frame), order.options.width, order.options.height);
}

bool carriesItsStamp(const FilmOrder& order, int frame) {
  if (!order.stamp) return true;
  const auto note = readImageNote(fileOf(order.output.path, frame));
  return note && isSamePicture(*note, order.stamp(frame));
}

}  // namespace

bool isThere(const FilmOrder& order, int frame) {
  return order.resume && isWhole(order, frame) && carriesItsStamp(order, frame);
}

void requireEveryFrame(const FrameRange& frames) {
  if (frames.step == 1) return;
  throw UsageError(
      "--frames A:B:STEP makes numbered pictures; a film shows every frame, and --fps sets its "
      "rate");
}

void requireFilmWritable(const Target& output, const FrameRange& frames) {
  if (isFilm(output.path)) requireEveryFrame(frames);
  requireWritable({fileOf(output.path, frames.first), output.existing});
  if (isFilm(output.path)) requireFfmpeg();
}

std::vector<std::string> outputsOf(const FilmOrder& order) {
  const fs::path& output = order.output.path;
  if (isFilm(output)) return {output.string()};
  std::vector<std::string> files;
  for (int frame = order.frames.first; frame <= order.frames.last; frame += order.frames.step) {
    files.push_back(fileOf(output, frame).string());
  }
  return files;
}

FramesThere countThere(const FilmOrder& order) {
  FramesThere there;
  if (!order.resume) return there;
  for (int frame = order.frames.first; frame <= order.frames.last; frame += order.frames.step) {
    if (!isWhole(order, frame)) continue;
    ++(carriesItsStamp(order, frame) ? there.kept : there.otherwiseMade);
  }
  return there;
}

FilmMade renderFilm(Renderer& renderer, const FilmOrder& order) {
  FilmJob job(order);
  Progress bar(order.frames.count(), order.quiet);
  job.step(renderer, order.frames.count(), [&](const FilmProgress& progress) {
    bar.show(progress.written + progress.skipped, progress.skipped);
  });
  return {order.frames.count() - job.progress().skipped, job.report()};
}

std::function<void(Renderer& renderer, int frame)> placeBySequence(
    std::shared_ptr<const MeshSequence> sequence, const FrameRange& frames,
    std::shared_ptr<KeptPositions> kept) {
  const auto positions = std::make_shared<PositionsAhead>(
      positionsOf(sequence, numberOfFrame(*sequence, frames.last), frames.step, std::move(kept)));
  return [positions, of = std::move(sequence)](Renderer& renderer, int frame) {
    renderer.replacePositions(0, positions->of(numberOfFrame(*of, frame)));
  };
}

}  // namespace opaline::app
