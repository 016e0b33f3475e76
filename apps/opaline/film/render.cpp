#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/device_options.h"
#include "cli/json.h"
#include "cli/motion_options.h"
#include "cli/object_sizes.h"
#include "cli/output.h"
#include "cli/paths.h"
#include "cli/picture_options.h"
#include "cli/scene_options.h"
#include "film/film.h"
#include "film/film_encoder.h"
#include "film/film_output.h"
#include "film/frames_asked_for.h"
#include "film/framing.h"
#include "film/kept_positions.h"
#include "film/render_report.h"
#include "film/sequence_frames.h"
#include "opaline/error.h"
#include "opaline/file.h"
#include "opaline/renderer.h"
#include "opaline/scene.h"
#include "opaline/scene_file.h"

namespace opaline::app {

namespace {

struct RenderCommand {
  SceneOptions scene;
  LightOptions lights;
  CameraOptions camera;
  MotionOptions motion;
  MethodOptions method;
  PictureOptions picture;
  DeviceOptions device;
  std::optional<std::filesystem::path> report;
  bool resume = false;
  bool quiet = false;
  bool json = false;

  void addTo(CommandLine& line) {
    line.section("Scene");
    scene.addTo(line);
    line.section(LightOptions::section);
    lights.addTo(line);
    line.section("Picture");
    camera.addTo(line);
    picture.addTo(line);
    line.section("Motion");
    motion.addTo(line);
    line.flag("--resume", "skip frames that exist and are the same", resume);
    line.section("Method");
    method.addTo(line);
    line.section("Run");
    device.addTo(line);
    line.value("--report", "FILE.json", "what was done, and how long it took",
               [this](const Given& given) { report = readOutput(given, {".json"}); });
    line.outputFlags("the report on standard output", json, quiet);
  }

  /// Refuses options that contradict each other, before any work.
  void check() const {
    camera.check();
    motion.check();
    picture.requireNameFor(motion.frames().has_value(), resume, motion.chunk().has_value());
    static_cast<void>(options({}));
  }

  RenderOptions options(const SceneFileSettings& settings) const {
    RenderOptions options = optionsOf(settings);
    method.applyTo(options, settings);
    picture.applyTo(options);
    method.requireUse(options, picture.aov());
    return options;
  }
};

/// Everything that is settled before rendering starts.
struct RenderJob : PictureJob {
  SceneFileSettings settings;
  std::vector<std::filesystem::path> inputs;
};

RenderJob prepareRender(const RenderCommand& command, Target output, const LogCallback& log) {
  LoadedScene loaded = command.scene.load(log);
  command.lights.applyTo(loaded);
  auto& [scene, settings, source, sequence] = loaded;
  RenderOptions options = command.options(settings);
  command.camera.applyTo(scene);
  command.motion.applyTo(scene);
  const SceneTime time = command.motion.time(scene, settings);
  for (const std::string& note : notesOnSize(scene)) log(LogLevel::Note, note);
  const ToneOptions tone = command.picture.tone(settings, scene);
  const auto exposure = command.picture.noteOnExposure(settings, tone);
  if (exposure) log(LogLevel::Note, *exposure);
  noteFilmSize(output, options, log);
  return {{std::move(scene), options, time, tone, std::move(output), std::move(sequence)},
          std::move(settings),
          filesOf(source)};
}

std::string onDevice(const DeviceDescription& device) {
  return fmt::format("rendered on {} ({})", device.name, device.type);
}

/// What was made, and the messages of Vulkan's validation layer.
struct Done {
  Json report;
  std::size_t validationMessages = 0;
};

Renderer makeRenderer(const RenderCommand& command, const RenderJob& job, const LogCallback& log) {
  Renderer renderer(command.device.rendererOptions(job.settings.named.device.value_or(""), log));
  renderer.setScene(job.scene);
  return renderer;
}

bool isEmpty(const Image& image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4)
    if (image.rgba[i] > 0) return false;
  return true;
}

Done makeStill(const RenderCommand& command, const RenderJob& job, const LogCallback& log) {
  Renderer renderer = makeRenderer(command, job, log);
  if (job.sequence) {
    std::vector<Vec3> positionsMm;
    const int number = numberAt(*job.sequence, job.time.seconds);
    if (!job.kept->take(number, positionsMm)) job.sequence->read(number, positionsMm);
    renderer.replacePositions(0, positionsMm);
  }
  renderer.setTime(job.time);
  View view(renderer, job.options);
  const FrameOrder order{.aovs = {command.picture.aov()}};
  RenderResult result = view.render(order);
  // A report gives the time of a warm frame, so a second one is rendered.
  if (command.report || command.json) result = view.render(order);
  const Image& image = result.images.at(0);
  if (isEmpty(image)) {
    log(LogLevel::Note,
        "the camera sees nothing of the scene; what is flat shows nothing from its edge: "
        "--camera-direction 0.2,0.6,1 looks from above");
  }
  const std::filesystem::path file = writePicture(job.output, image, job.tone);
  log(LogLevel::Note,
      fmt::format("wrote {}, {}", nameText(file, job.output.path), onDevice(result.report.device)));
  return {renderReportJson(result.report, job.options, {file.string()}),
          renderer.validationMessages()};
}

/// A report for frames that all existed already.
Json emptyReportJson(const RenderJob& job, const std::vector<std::string>& outputs) {
  RenderReport nothing;
  nothing.sum = job.options.sum;
  Json json = renderReportJson(nothing, job.options, outputs);
  for (const char* unknown :
       {"device", "transport", "site", "triangles", "vertices", "sources", "clusters", "frame_ms",
        "dispatches", "barriers", "recordings", "peak_memory_mb"}) {
    json[unknown] = nullptr;
  }
  return json;
}

Done renderMissing(const RenderCommand& command, const RenderJob& job, FilmOrder order,
                   const LogCallback& log) {
  if (!job.sequence) noteStandstill(job.scene, job.time.clip, log);
  Renderer renderer = makeRenderer(command, job, log);
  if (job.sequence) order.place = placeBySequence(job.sequence, order.frames, job.kept);
  const auto [made, report] = renderFilm(renderer, order);
  log(LogLevel::Note, fmt::format("wrote {} to {}, {}", countOfFrames(made),
                                  job.output.path.string(), onDevice(report.device)));
  return {renderReportJson(report, job.options, outputsOf(order)), renderer.validationMessages()};
}

/// As pictures say it of themselves.
Json methodOf(const RenderOptions& options) {
  return {{"transport", options::nameOf(options.transport)},
          {"sum", options::nameOf(options.sum)},
          {"site", options::nameOf(options.site)}};
}

FilmOrder filmOrder(const RenderCommand& command, const RenderJob& job, const FrameRange& frames) {
  FilmOrder order = job.filmOrder(frames, command.picture.aov(), methodOf(job.options));
  order.resume = command.resume;
  order.quiet = command.quiet;
  return order;
}

void requireNoInput(const RenderCommand& command, const RenderJob& job) {
  std::vector<Output> outputs;
  if (job.output.existing == Existing::Replace)
    addOutputs("-o", job.output.path, command.motion.frames(), outputs);
  if (command.report) outputs.push_back({"--report", *command.report});
  requireNoInput(outputs, job.inputs);
}

Done makeNothing(const RenderJob& job, const Chunk& chunk, const LogCallback& log) {
  noteEmptyChunk(chunk, log);
  return {emptyReportJson(job, {})};
}

Done makeFrames(const RenderCommand& command, const RenderJob& job, const FrameRange& frames,
                const LogCallback& log) {
  const FilmOrder order = filmOrder(command, job, frames);
  return framesToMake(order, log) > 0 ? renderMissing(command, job, order, log)
                                      : Done{emptyReportJson(job, outputsOf(order))};
}

Done make(const RenderCommand& command, const RenderJob& job, const LogCallback& log) {
  if (!command.motion.frames()) return makeStill(command, job, log);
  const std::optional<FrameRange> frames = command.motion.framesOfChunk();
  Done done = frames ? makeFrames(command, job, *frames, log)
                     : makeNothing(job, *command.motion.chunk(), log);
  addFrames(frames, done.report);
  return done;
}

}  // namespace

void runRender(const Arguments& arguments) {
  CommandLine line("render",
                   "Renders stills and films. Lengths in mm, light in linear RGB, defaults in [].");
  RenderCommand command;
  command.addTo(line);
  if (!line.parse(arguments)) return;
  command.check();
  command.device.limitHostMemory();

  const LogCallback log = noteTaker(command.quiet);
  const std::optional<FrameRange> frames = command.motion.frames();
  Target output = command.picture.target(command.scene.name(), frames);
  requireOutputs(output, frames, command.report);

  RenderJob job = prepareRender(command, std::move(output), log);
  job.aimCamera(frames);  // the same in every chunk
  requireNoInput(command, job);
  Done done = make(command, job, log);
  done.report["exposure_stops"] =
      command.picture.isExr() ? Json() : shortJson(job.tone.exposureStops);
  const std::string report = toText(done.report);
  if (command.report) writeWhole(*command.report, report);
  if (command.json) printOut(report);
  if (done.validationMessages > 0) {
    throw Error(
        fmt::format("--validation: the validation layer had {} messages", done.validationMessages));
  }
}

}  // namespace opaline::app
