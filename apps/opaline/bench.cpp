#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include "command_line.h"
#include "commands.h"
#include "core/file.h"
#include "core/image_file.h"
#include "methods.h"
#include "opaline/error.h"
#include "output.h"
#include "paths.h"
#include "scene_options.h"
#include "table1.h"
#include "values.h"

namespace opaline::app {

namespace {

enum class Suite { Table1, Methods };

struct BenchCommand {
  std::optional<Suite> suite;
  SceneOptions scene;
  LightOptions lights;
  CameraOptions camera;
  std::optional<std::filesystem::path> models;
  std::optional<std::string> device;
  std::optional<int> frames;
  std::optional<int> edge;
  std::optional<int> every;
  std::optional<std::filesystem::path> truth;
  std::optional<std::filesystem::path> plot;
  bool quiet = false;
  bool json = false;

  void addTo(CommandLine& line) {
    line.positional("SUITE", "table1: the paper's Table 1; methods: error against cost",
                    [this](const Given& given) {
                      suite = readChoice<Suite>(
                          given, {{"table1", Suite::Table1}, {"methods", Suite::Methods}});
                    });
    line.section("table1: five models at 1024x1024, 9 frames each");
    line.value("--models", "FOLDER", "[OPALINE_MODELS, else ../shared/models]",
               [this](const Given& given) { models = given.text; });
    line.section("methods: every way to render a scene, 3 frames each; takes minutes");
    scene.addTo(line);
    lights.addTo(line);
    camera.addTo(line);
    line.value("--size", "N", "edge of the picture in pixels, 8 to 2048 [256]",
               [this](const Given& given) { edge = readInteger(given, 8, 2048); });
    line.value("--every", "N", "of the integral's pixels, without --truth [2]",
               [this](const Given& given) { every = readInteger(given, 1, 64); });
    line.value("--truth", "FILE.exr", "exitance by reference --path, in the same view",
               [this](const Given& given) { truth = given.text; });
    line.value("--plot", "FILE.svg", "draw errors against times",
               [this](const Given& given) { plot = readOutput(given, {".svg"}); });
    line.section("Run");
    line.value("--frames", "N", "of each measurement, 1 to 1000",
               [this](const Given& given) { frames = readInteger(given, 1, 1000); });
    line.value("--device", "NAME|INDEX", "as opaline info lists them [the best]",
               [this](const Given& given) { device = given.text; });
    line.flag("--json", "one JSON object on standard output", json);
    line.flag("--quiet", "no notes on standard error", quiet);
  }

  std::filesystem::path folder() const {
    if (models) return *models;
    const char* const variable = std::getenv("OPALINE_MODELS");
    return variable != nullptr && *variable != '\0' ? variable : "../shared/models";
  }

  /// Refuses what belongs to the other suite.
  void check() const {
    if (!suite) throw UsageError("bench needs the name of a suite: table1 or methods");
    if (*suite == Suite::Methods && models) {
      throw UsageError("--models belongs to bench table1; methods measures one SCENE");
    }
    if (*suite == Suite::Table1 && (edge || every || truth || plot)) {
      throw UsageError("--size, --every, --truth and --plot belong to bench methods");
    }
    if (*suite == Suite::Table1 && (scene.any() || lights.any() || camera.any())) {
      throw UsageError(
          "a scene, its medium, lights and camera belong to bench methods; table1 has its own");
    }
  }

  void runTable1() const {
    Table1Order order;
    order.models = folder();
    order.device = device.value_or("");
    order.frames = frames.value_or(order.frames);
    order.log = noteTaker(quiet);
    const Table1 table = measureTable1(order);
    printOut(json ? toText(toJson(table)) : toReadable(table));
  }

  void runMethods() const {
    if (plot) core::requireWritable(*plot);
    MethodsOrder order;
    order.log = noteTaker(quiet);
    order.scene = scene.load(order.log).scene;
    lights.applyTo(order.scene);
    camera.applyTo(order.scene);
    order.edgePixels = edge.value_or(order.edgePixels);
    order.every = every.value_or(order.every);
    order.frames = frames.value_or(order.frames);
    order.device = device.value_or("");
    if (truth) order.truth = core::readHdrImage(*truth);
    const Methods methods = measureMethods(order);
    if (plot) core::writeWhole(*plot, plotSvg(methods));
    printOut(json ? toText(toJson(methods)) : toReadable(methods));
  }
};

}  // namespace

void runBench(const Arguments& arguments) {
  CommandLine line("bench",
                   "Measures this machine's device: every frame is gathered and scattered anew. In "
                   "[] is the default.");
  BenchCommand command;
  command.addTo(line);
  if (!line.parse(arguments)) return;
  command.check();
  if (*command.suite == Suite::Table1) {
    command.runTable1();
  } else {
    command.runMethods();
  }
}

}  // namespace opaline::app
