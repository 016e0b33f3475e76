#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/json.h"
#include "cli/object_sizes.h"
#include "cli/output.h"
#include "cli/paths.h"
#include "cli/progress.h"
#include "film/film.h"
#include "film/film_output.h"
#include "film/frames_asked_for.h"
#include "film/framing.h"
#include "film/kept_positions.h"
#include "film/sequence_frames.h"
#include "lab/path_method.h"
#include "lab/reference_command.h"
#include "opaline/error.h"
#include "opaline/file.h"
#include "opaline/scene_file.h"
#include "reference/integral.h"
#include "reference/picture.h"
#include "reference/posed_scene.h"
#include "reference/truth.h"

namespace opaline::app {

namespace {

namespace rf = opaline::reference;

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Everything that is settled before the computation starts.
struct ReferenceJob : PictureJob {
  Clock::time_point begin{};  ///< of the command
};

ReferenceJob prepareReference(const ReferenceCommand& command, Target output,
                              const LogCallback& log) {
  LoadedScene loaded = command.scene.load(log);
  command.lights.applyTo(loaded);
  auto& [scene, settings, source, sequence] = loaded;
  RenderOptions options = command.options(settings);
  rf::requireSound(command.pictureOptions(options));
  command.camera.applyTo(scene);
  command.motion.applyTo(scene);
  const SceneTime time = command.motion.time(scene, settings);
  for (const std::string& note : notesOnSize(scene)) log(LogLevel::Note, note);
  if (command.integral && options.specular && command.picture.aov() == Aov::Radiance) {
    log(LogLevel::Note,
        "the integral leaves out the reflection on surfaces; compare it with render "
        "--no-specular");
  }
  requireNoInput(command.outputs(output), filesOf(source));
  const ToneOptions tone = command.picture.tone(settings, scene);
  const auto exposure = command.picture.noteOnExposure(settings, tone);
  if (exposure) log(LogLevel::Note, *exposure);
  noteFilmSize(output, options, log);
  ReferenceJob job{{std::move(scene), options, time, tone, std::move(output), std::move(sequence)}};
  job.aimCamera(command.motion.frames());  // the same in every chunk
  return job;
}

/// The scene at that moment; a body of numbered files is where its file has it.
rf::Scene posed(const ReferenceJob& job, const Moment& moment) {
  PositionsByObject positionsMm;
  if (moment.number && !job.kept->take(*moment.number, positionsMm[0]))
    job.sequence->read(*moment.number, positionsMm[0]);
  return reference::posedScene(job.scene, {moment.seconds, job.time.clip}, positionsMm);
}

/// The result of the computation.
struct Made {
  rf::Picture picture;
  Json facts = Json::object();  ///< specific to the method
  double blockError = 0;        ///< with --path only
  std::size_t triangles = 0;
  std::size_t vertices = 0;
  double seconds = 0;
};

void makeIntegral(const ReferenceCommand& command, const ReferenceJob& job,
                  const rf::Geometry& geometry, const PictureRun& run, Made& made) {
  using Sky = rf::Irradiance::Sky;
  const rf::Irradiance irradiance(geometry,
                                  command.ambientOcclusion ? Sky::Shadowed : Sky::Unshadowed);
  std::optional<Progress> progress;
  reference::IntegralTruth truth = reference::integralTruth(
      geometry, irradiance, {job.options.transport, command.toleranceOf()},
      command.pictureOptions(job.options), [&](std::size_t done, std::size_t total) {
        if (!progress) progress.emplace(total, run.quiet, "pixel", run.progress);
        progress->show(done, 0);
      });
  made.picture = std::move(truth.picture);
  made.facts = {{"transport", options::nameOf(job.options.transport)},
                {"tolerance", command.toleranceOf()},
                {"patches", truth.patches}};
}

void makePath(const ReferenceCommand& command, const ReferenceJob& job,
              const rf::Geometry& geometry, const PictureRun& run, Made& made) {
  const rf::Irradiance irradiance(geometry);
  made.picture =
      command.path.make(geometry, irradiance, command.pictureOptions(job.options), run, made.facts);
  made.blockError = made.facts.at("block_error");
}

Made makeAt(const Moment& moment, const ReferenceCommand& command, const ReferenceJob& job,
            const PictureRun& run) {
  const Clock::time_point begin = Clock::now();
  const rf::Scene scene = posed(job, moment);
  Made made;
  for (const rf::Body& body : scene.bodies) {
    made.triangles += body.triangles.size();
    made.vertices += body.positionsMm.size();
  }
  const rf::Geometry geometry(scene);
  if (command.integral) {
    makeIntegral(command, job, geometry, run, made);
  } else {
    makePath(command, job, geometry, run, made);
  }
  made.seconds = secondsSince(begin);
  return made;
}

/// What is reported of a single picture.
Json pictureJson(const Made& made) {
  const rf::ErrorSummary& error = made.picture.error;
  Json json{{"pixels", made.picture.pixels},
            {"relative_error",
             {{"mean", error.mean}, {"p95", error.percentile95}, {"max", error.largest}}},
            {"seconds", made.seconds}};
  json.update(made.facts);
  return json;
}

/// What is reported of all pictures.
Json reportJson(const ReferenceCommand& command, const ReferenceJob& job) {
  return {{"method", command.integral ? "integral" : "path"},
          {"size", {job.options.width, job.options.height}},
          {"triangles", nullptr},
          {"vertices", nullptr},
          {"exposure_stops", command.picture.isExr() ? Json() : shortJson(job.tone.exposureStops)},
          {"outputs", Json::array()}};
}

/// What is known of one picture or of the worst of several.
struct Exactness {
  bool seesAny = false;  ///< some pixel shows the scene
  rf::ErrorSummary error;
  double blockError = 0;
};

/// Notes what was written, and how exact it is. Single pixels of a path-traced picture are noise,
/// and pixels without particles show nothing, so blocks are judged.
void noteWritten(const ReferenceCommand& command, const std::string& what, double seconds,
                 const Exactness& exactness, const LogCallback& log) {
  const auto& [seesAny, error, blockError] = exactness;
  std::string note = fmt::format("wrote {}, in {:.1f} s", what, seconds);
  if (!seesAny) {
    log(LogLevel::Note, fmt::format("the camera sees nothing of the scene{}",
                                    command.region ? " in this --region" : ""));
  } else if (rf::showsExitance(command.picture.aov())) {
    note += command.integral ? fmt::format("; estimated error {:.2g} in the mean, {:.2g} at most",
                                           error.mean, error.largest)
                             : fmt::format("; standard error of 8x8 blocks {:.2g}", blockError);
  }
  log(LogLevel::Note, note);
}

Json makeStill(const ReferenceCommand& command, const ReferenceJob& job, const LogCallback& log) {
  const Moment moment = momentOf(job.time.seconds, job.sequence.get()).front();
  const Made made = makeAt(moment, command, job, {{}, {}, command.quiet, log});
  const std::filesystem::path file = writePicture(job.output, made.picture.image, job.tone);
  const double seconds = secondsSince(job.begin);
  noteWritten(command, nameText(file, job.output.path), seconds,
              {made.picture.pixels > 0, made.picture.error, made.blockError}, log);
  Json report = reportJson(command, job);
  report["triangles"] = made.triangles;
  report["vertices"] = made.vertices;
  report["outputs"] = {file.string()};
  report.update(pictureJson(made));
  report["seconds"] = seconds;
  return report;
}

/// Makes the missing frames of an order one after the other.
class ReferenceFilm {
 public:
  ReferenceFilm(const ReferenceCommand& command, const ReferenceJob& job, const FilmOrder& order,
                LogCallback log)
      : command_(command), job_(job), order_(order), log_(std::move(log)), output_(order) {}

  void make(std::size_t missing, Json& report) {
    const FrameRange& frames = order_.frames;
    try {
      for (int frame = frames.first; frame <= frames.last; frame += frames.step)
        if (!isThere(order_, frame)) makeFrame(frame, missing, report);
    } catch (const Error&) {
      output_.flush();  // keeps what was made before
      throw;
    }
    output_.finish();
    noteWritten(command_, fmt::format("{} to {}", countOfFrames(made_), output_.file().string()),
                secondsSince(job_.begin), worst_, log_);
  }

 private:
  void makeFrame(int frame, std::size_t missing, Json& report) {
    const MeshSequence* const sequence = job_.sequence.get();
    Moment moment{order_.frames.seconds(frame), {}};
    if (sequence != nullptr) moment.number = numberOfFrame(*sequence, frame);
    Made made =
        makeAt(moment, command_, job_,
               {frame, fmt::format("frame {}/{}, ", ++made_, missing), command_.quiet, log_});
    const rf::ErrorSummary& error = made.picture.error;
    worst_ = {
        worst_.seesAny || made.picture.pixels > 0,
        {std::max(worst_.error.mean, error.mean), 0, std::max(worst_.error.largest, error.largest)},
        std::max(worst_.blockError, made.blockError)};
    report["triangles"] = made.triangles;
    report["vertices"] = made.vertices;
    Json picture{{"frame", frame}};
    picture.update(pictureJson(made));
    report["pictures"].push_back(std::move(picture));
    Frame written = output_.take();
    written.images.clear();
    written.images.push_back(std::move(made.picture.image));
    output_.push(frame, std::move(written));
  }

  const ReferenceCommand& command_;
  const ReferenceJob& job_;
  const FilmOrder& order_;
  LogCallback log_;
  FilmOutput output_;
  std::size_t made_ = 0;
  Exactness worst_;
};

Json makeFrames(const ReferenceCommand& command, const ReferenceJob& job,
                const std::optional<FrameRange>& frames, const LogCallback& log) {
  Json report = reportJson(command, job);
  report["seconds"] = nullptr;
  report["pictures"] = Json::array();
  addFrames(frames, report);
  if (!frames) {
    noteEmptyChunk(*command.motion.chunk(), log);
    return report;
  }
  FilmOrder order =
      job.filmOrder(*frames, command.picture.aov(), command.describeMethod(job.options));
  order.resume = command.resume;
  order.quiet = command.quiet;
  const std::size_t missing = framesToMake(order, log);
  if (missing > 0) {
    if (!job.sequence) noteStandstill(job.scene, job.time.clip, log);
    ReferenceFilm(command, job, order, log).make(missing, report);
  }
  report["outputs"] = outputsOf(order);
  report["seconds"] = secondsSince(job.begin);
  return report;
}

void requireCheckpoint(const Json& picture) {
  if (picture.contains(unsavedCheckpoint) && picture.at(unsavedCheckpoint).is_string())
    throw Error(picture.at(unsavedCheckpoint).get<std::string>());
}

// Pictures are written first.
void requireCheckpoints(const Json& report) {
  requireCheckpoint(report);
  if (!report.contains("pictures")) return;
  for (const Json& picture : report.at("pictures")) requireCheckpoint(picture);
}

}  // namespace

void runReference(const Arguments& arguments) {
  CommandLine line("reference",
                   "The truth, by the CPU. Lengths in mm, light in linear RGB, defaults in [].");
  ReferenceCommand command;
  command.addTo(line);
  if (!line.parse(arguments)) return;
  command.check();

  const Clock::time_point begin = Clock::now();
  const LogCallback log = noteTaker(command.quiet);
  const std::optional<FrameRange> frames = command.motion.frames();
  Target output = command.picture.target(command.scene.name(), frames);
  command.path.check(output.path, command.report, frames.has_value());
  requireOutputs(output, frames, command.report);

  ReferenceJob job = prepareReference(command, std::move(output), log);
  job.begin = begin;
  const Json report = frames ? makeFrames(command, job, command.motion.framesOfChunk(), log)
                             : makeStill(command, job, log);
  const std::string text = toText(report);
  if (command.report) writeWhole(*command.report, text);
  if (command.json) printOut(text);
  requireCheckpoints(report);
}

}  // namespace opaline::app
