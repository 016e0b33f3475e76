#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "command_line.h"
#include "commands.h"
#include "core/file.h"
#include "film.h"
#include "json.h"
#include "motion_options.h"
#include "opaline/error.h"
#include "opaline/renderer.h"
#include "opaline/scene.h"
#include "output.h"
#include "paths.h"
#include "picture_options.h"
#include "render_report.h"
#include "scene_options.h"

namespace opaline::app {

namespace {

struct RenderCommand {
  SceneOptions scene;
  LightOptions lights;
  CameraOptions camera;
  MotionOptions motion;
  MethodOptions method;
  PictureOptions picture;
  std::optional<std::string> device;
  std::optional<std::filesystem::path> report;
  bool resume = false;
  bool validation = false;
  bool quiet = false;
  bool json = false;

  void addTo(CommandLine& line) {
    line.section("Scene");
    scene.addTo(line);
    line.section("Light; the first of these replaces all the scene has");
    lights.addTo(line);
    line.section("Picture");
    camera.addTo(line);
    picture.addTo(line);
    line.section("Motion");
    motion.addTo(line);
    line.flag("--resume", "leave out frames whose pictures are there", resume);
    line.section("Method");
    method.addTo(line);
    line.section("Run");
    line.value("--device", "NAME|INDEX", "as opaline info lists them [the best]",
               [this](const Given& given) {
                 if (given.text.empty()) {
                   throw UsageError("--device needs a value, NAME|INDEX");
                 }
                 device = given.text;
               });
    line.flag("--validation", "run Vulkan's validation layer, fail on messages", validation);
    line.value("--report", "FILE.json", "what was done, and how long it took",
               [this](const Given& given) { report = readOutput(given, {".json"}); });
    line.flag("--json", "the same on standard output", json);
    line.flag("--quiet", "no notes on standard error", quiet);
  }

  /// Refuses what contradicts itself, before any work.
  void check() const {
    motion.check();
    picture.requireNameFor(motion.frames().has_value(), resume);
    static_cast<void>(options({}));
  }

  RenderOptions options(const scene::SceneFileSettings& settings) const {
    RenderOptions options = optionsOf(settings);
    method.applyTo(options);
    picture.applyTo(options);
    // A report gives the time of a warm frame, so it takes a second one.
    options.frames = report || json ? 2 : 1;
    return options;
  }
};

/// What is settled before anything is rendered.
struct Job {
  Scene scene;
  scene::SceneFileSettings settings;
  RenderOptions options;
  std::filesystem::path output;
};

Job prepare(const RenderCommand& command, std::filesystem::path output, const LogCallback& log) {
  auto [scene, settings] = command.scene.load(log);
  RenderOptions options = command.options(settings);
  command.lights.applyTo(scene);
  command.camera.applyTo(scene);
  command.motion.applyTo(scene);
  command.motion.applyTo(options, scene);
  for (const std::string& note : notesOnSize(scene)) log(LogLevel::Note, note);
  if (command.picture.seenByCamera()) {
    const auto note = command.camera.noteOnFraming(scene, options.width, options.height);
    if (note) log(LogLevel::Note, *note);
  }
  return {std::move(scene), std::move(settings), options, std::move(output)};
}

std::string onDevice(const DeviceDescription& device) {
  return fmt::format("rendered on {} ({})", device.name, device.type);
}

Json makeStill(Renderer& renderer, const RenderCommand& command, const Job& job,
               const LogCallback& log) {
  renderer.setScene(job.scene);
  const RenderResult result = renderer.render(job.options, {command.picture.aov()});
  writePicture(job.output, result.images.at(0), command.picture.tone(job.settings));
  log(LogLevel::Note,
      fmt::format("wrote {}, {}", job.output.string(), onDevice(result.report.device)));
  return renderReportJson(result.report, job.options, {job.output.string()});
}

Json makeFrames(Renderer& renderer, const RenderCommand& command, const Job& job,
                const FrameRange& frames, const LogCallback& log) {
  const FilmOrder order{frames,
                        job.output,
                        command.picture.aov(),
                        job.options,
                        command.picture.tone(job.settings),
                        command.resume,
                        command.quiet};
  if (!moves(job.scene, job.options.clip)) {
    log(LogLevel::Note,
        "nothing in the scene moves, so all frames are the same picture; --deform wobble:0.1 makes "
        "it move");
  }
  renderer.setScene(job.scene);
  const std::size_t skipped = renderFilm(renderer, order);
  const std::size_t made = frames.count() - skipped;
  const RenderReport report = renderer.report();
  if (skipped > 0) {
    log(LogLevel::Note, fmt::format("{} of {} frames were there already", skipped, frames.count()));
  }
  if (made > 0) {
    log(LogLevel::Note, fmt::format("wrote {} frames to {}, {}", made, job.output.string(),
                                    onDevice(report.device)));
  }
  Json json = renderReportJson(report, job.options, outputsOf(order));
  if (made == 0) json["frame_ms"] = nullptr;
  json["frames"] = {frames.first, frames.last};
  json["fps"] = frames.perSecond;
  return json;
}

}  // namespace

void runRender(const Arguments& arguments) {
  CommandLine line(
      "render",
      "Renders a still or a film. Lengths are mm, light is linear RGB, in [] is the default.");
  RenderCommand command;
  command.addTo(line);
  if (!line.parse(arguments)) return;
  command.check();

  const LogCallback log = noteTaker(command.quiet);
  const std::optional<FrameRange> frames = command.motion.frames();
  std::filesystem::path output = command.picture.file(command.scene.name(), frames.has_value());
  if (frames) {
    requireFilmWritable(output, *frames);
  } else {
    core::requireWritable(output);
  }
  if (command.report) core::requireWritable(*command.report);

  const Job job = prepare(command, std::move(output), log);
  Renderer renderer(
      {command.device.value_or(job.settings.device.value_or("")), command.validation, log});
  const Json json = frames ? makeFrames(renderer, command, job, *frames, log)
                           : makeStill(renderer, command, job, log);
  const std::string report = toText(json);
  if (command.report) core::writeWhole(*command.report, report);
  if (command.json) printOut(report);
  if (renderer.validationMessages() > 0) {
    throw Error(fmt::format("--validation: the validation layer had {} messages",
                            renderer.validationMessages()));
  }
}

}  // namespace opaline::app
