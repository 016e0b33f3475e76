#include "film/frames_asked_for.h"

#include <fmt/format.h>

#include "cli/frame_names.h"
#include "cli/motion_options.h"
#include "film/film_output.h"
#include "film/framing.h"
#include "film/picture_stamp.h"

namespace opaline::app {

void requireOutputs(const Target& output, const std::optional<FrameRange>& frames,
                    const std::optional<std::filesystem::path>& report) {
  if (frames) {
    requireFilmWritable(output, *frames);
  } else {
    requireWritable(output);
  }
  if (report) requireWritable(*report);
}

void PictureJob::aimCamera(const std::optional<FrameRange>& frames) {
  showAll(scene,
          {time.clip, aspectOf(options), sequence.get(),
           frames ? momentsOf(*frames, sequence.get()) : momentOf(time.seconds, sequence.get()),
           kept.get()});
}

FilmOrder PictureJob::filmOrder(const FrameRange& frames, Aov aov, const Json& method) const {
  FilmOrder order{.frames = frames,
                  .output = output,
                  .aov = aov,
                  .options = options,
                  .clip = time.clip,
                  .tone = tone};
  if (isFilm(output.path)) return order;
  PictureMakers makers{scene, options, time.clip, aov, tone, sequence, method};
  if (extensionOf(output.path) == ".exr") makers.tone.reset();
  order.stamp = frameStamps(makers, frames);
  return order;
}

void addOutputs(const std::string& option, const std::filesystem::path& file,
                const std::optional<FrameRange>& frames, std::vector<Output>& to) {
  if (!frames || fileOf(file, frames->first) == file) {
    to.push_back({option, file});
    return;
  }
  for (int frame = frames->first; frame <= frames->last; frame += frames->step)
    to.push_back({option, fileOf(file, frame)});
}

std::size_t framesToMake(const FilmOrder& order, const LogCallback& log) {
  const FramesThere there = countThere(order);
  const std::size_t count = order.frames.count();
  if (there.kept > 0)
    log(LogLevel::Note, fmt::format("{} of {} frames existed already", there.kept, count));
  if (there.otherwiseMade > 0) {
    log(LogLevel::Note,
        fmt::format("{} of {} frames came from another scene or other options and are made again",
                    there.otherwiseMade, count));
  }
  return count - there.kept;
}

void noteStandstill(const Scene& scene, int clip, const LogCallback& log) {
  if (moves(scene, clip)) return;
  log(LogLevel::Note,
      "nothing in the scene moves, so all frames are the same picture; --deform wobble:0.1 makes "
      "it move");
}

void noteFilmSize(const Target& output, const RenderOptions& options, const LogCallback& log) {
  if (!isFilm(output.path)) return;
  const auto note = noteOnFilmSize(options.width, options.height);
  if (note) log(LogLevel::Note, *note);
}

std::string countOfFrames(std::size_t count) {
  return fmt::format("{} frame{}", count, count == 1 ? "" : "s");
}

void noteEmptyChunk(const Chunk& chunk, const LogCallback& log) {
  log(LogLevel::Note, fmt::format("chunk {} of {} has no frames", chunk.number, chunk.count));
}

void addFrames(const std::optional<FrameRange>& frames, Json& report) {
  report["frames"] = frames ? Json{frames->first, frames->last} : Json();
  report["frame_step"] = frames ? Json(frames->step) : Json();
  report["fps"] = frames ? Json(frames->perSecond) : Json();
}

}  // namespace opaline::app
