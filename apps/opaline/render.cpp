#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <string>
#include <system_error>

#include "command_line.h"
#include "commands.h"
#include "core/file.h"
#include "core/image_file.h"
#include "core/tone.h"
#include "json.h"
#include "opaline/error.h"
#include "opaline/renderer.h"
#include "opaline/scene.h"
#include "output.h"
#include "paths.h"
#include "picture_options.h"
#include "scene_options.h"

namespace opaline::app {

namespace {

struct RenderCommand {
  SceneOptions scene;
  LightOptions lights;
  CameraOptions camera;
  MethodOptions method;
  PictureOptions picture;
  std::optional<std::string> device;
  std::optional<std::filesystem::path> report;
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

  RenderOptions options(const scene::SceneFileSettings& settings) const {
    RenderOptions options = optionsOf(settings);
    method.applyTo(options);
    picture.applyTo(options);
    // A report gives the time of a warm frame, so it takes a second one.
    options.frames = report || json ? 2 : 1;
    return options;
  }
};

Json reportJson(const RenderReport& report, const RenderOptions& options,
                const std::filesystem::path& output) {
  Json passes = Json::array();
  for (const PassTime& pass : report.passes) {
    passes.push_back({{"name", pass.name}, {"ms", pass.milliseconds}});
  }
  return {{"device",
           {{"name", report.device.name},
            {"type", report.device.type},
            {"driver", report.device.driver}}},
          {"size", {options.width, options.height}},
          {"transport", nameOf(report.transport, transports())},
          {"sum", nameOf(report.sum, sums())},
          {"site", nameOf(report.site, sites())},
          {"triangles", report.triangles},
          {"vertices", report.vertices},
          {"sources", report.sources},
          {"passes", std::move(passes)},
          {"frame_ms", report.frameMilliseconds},
          {"peak_memory_mb", report.peakMemoryMegabytes},
          {"outputs", {output.string()}}};
}

}  // namespace

void runRender(const Arguments& arguments) {
  CommandLine line("render",
                   "Renders a still. Lengths are mm, light is linear RGB, in [] is the default.");
  RenderCommand command;
  command.addTo(line);
  if (!line.parse(arguments)) return;

  static_cast<void>(command.options({}));  // refuses what contradicts itself before any work
  const LogCallback log = noteTaker(command.quiet);
  const std::filesystem::path output = command.picture.file(command.scene.name());
  core::requireWritable(output);
  if (command.report) core::requireWritable(*command.report);

  auto [scene, settings] = command.scene.load(log);
  const RenderOptions options = command.options(settings);
  command.lights.applyTo(scene);
  command.camera.applyTo(scene);
  for (const std::string& note : notesOnSize(scene)) log(LogLevel::Note, note);
  if (command.picture.seenByCamera()) {
    const auto note = command.camera.noteOnFraming(scene, options.width, options.height);
    if (note) log(LogLevel::Note, *note);
  }

  Renderer renderer(
      {command.device.value_or(settings.device.value_or("")), command.validation, log});
  renderer.setScene(scene);
  const RenderResult result = renderer.render(options, {command.picture.aov()});
  if (command.picture.isExr()) {
    core::writeExr(output, result.images.at(0));
  } else {
    core::writePng(output, core::toneMap(result.images.at(0), command.picture.tone(settings)));
  }
  log(LogLevel::Note, fmt::format("wrote {}, rendered on {} ({})", output.string(),
                                  result.report.device.name, result.report.device.type));

  const std::string report = toText(reportJson(result.report, options, output));
  if (command.report) core::writeWhole(*command.report, report);
  if (command.json) printOut(report);
  if (renderer.validationMessages() > 0) {
    throw Error(fmt::format("--validation: the validation layer had {} messages",
                            renderer.validationMessages()));
  }
}

}  // namespace opaline::app
