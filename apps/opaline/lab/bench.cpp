#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/fields.h"
#include "cli/output.h"
#include "cli/paths.h"
#include "cli/scene_options.h"
#include "cli/values.h"
#include "film/framing.h"
#include "lab/methods.h"
#include "lab/scaling.h"
#include "lab/table1.h"
#include "opaline/error.h"
#include "opaline/file.h"
#include "opaline/image_file.h"
#include "opaline/options/picture.h"

namespace opaline::app {

namespace {

enum class Suite { Table1, Methods, Scaling };

struct BenchCommand {
  std::optional<Suite> suite;
  SceneOptions scene;
  LightOptions lights;
  CameraOptions camera;
  std::optional<std::filesystem::path> models;
  options::Chosen<options::NamedSettings> named;  // the device
  std::optional<int> frames;
  std::optional<int> edge;
  std::optional<double> seconds;
  std::optional<int> every;
  std::optional<std::filesystem::path> truth;
  bool all = false;
  std::optional<int> maxSurfels;
  std::optional<std::filesystem::path> plot;
  bool quiet = false;
  bool json = false;

  void addTo(CommandLine& line) {
    line.positional("SUITE", "table1: the paper's Table 1; methods: error against cost; scaling",
                    [this](const Given& given) {
                      suite = readChoice<Suite>(given, {{"table1", Suite::Table1},
                                                        {"methods", Suite::Methods},
                                                        {"scaling", Suite::Scaling}});
                    });
    line.section("table1: five models at 1024x1024, 9 frames each");
    line.value("--models", "FOLDER", "[OPALINE_MODELS, else ../shared/models]",
               [this](const Given& given) { models = given.text; });
    line.section("methods: every way to render a scene, 3 frames each; takes minutes");
    line.value("--truth", "FILE.exr", "exitance by reference --path, in the same view",
               [this](const Given& given) { truth = given.text; });
    line.value("--seconds", "S", "to trace a truth if no file is given; 0: none [30]",
               [this](const Given& given) {
                 seconds = readNumber(given, {0, 1e7, "s"});
               });
    line.value("--every", "N", "integrate every N-th pixel, needs --seconds 0 [1]",
               [this](const Given& given) { every = readInteger(given, 1, 64); });
    line.flag("--all", "also the sum over every surfel; slow without a GPU", all);
    line.section("scaling: times by surfels, clusters, lights, pixels and more, 5 frames each");
    line.value("--max-surfels", "N", "largest budget, 16384 to 4194304 [1048576]",
               [this](const Given& given) { maxSurfels = readInteger(given, 1 << 14, 1 << 22); });
    line.section("methods and scaling");
    scene.addTo(line);
    lights.addTo(line);
    camera.addTo(line);
    line.value("--size", "N", "edge in pixels, 8 to 2048 [methods: 256, scaling: 512]",
               [this](const Given& given) { edge = readInteger(given, 8, 2048); });
    line.value("--plot", "FILE.svg", "plot the error over time, or time over difficulty",
               [this](const Given& given) { plot = readOutput(given, {".svg"}); });
    line.section("Run");
    line.value("--frames", "N", "frames of each measurement, 1 to 1000",
               [this](const Given& given) { frames = readInteger(given, 1, 1000); });
    addField(line, options::fieldOf<options::NamedSettings>("device"), named);
    line.outputFlags("one JSON object on standard output", json, quiet);
  }

  std::string device() const {
    options::NamedSettings chosen;
    named.applyTo(chosen);
    return chosen.device.value_or("");
  }

  std::filesystem::path folder() const {
    if (models) return *models;
    const char* const variable = std::getenv("OPALINE_MODELS");
    return variable != nullptr && *variable != '\0' ? variable : "../shared/models";
  }

  /// Refuses options that belong to another suite.
  void check() const {
    if (!suite) throw UsageError("bench needs the name of a suite: table1, methods or scaling");
    if (*suite != Suite::Table1 && models)
      throw UsageError("--models belongs to bench table1; methods and scaling measure one SCENE");
    if (*suite != Suite::Methods && (every || truth || seconds || all))
      throw UsageError("--truth, --seconds, --every and --all belong to bench methods");
    if (truth && seconds) throw UsageError("--truth and --seconds exclude each other");
    if (every.value_or(1) != 1 && seconds != 0.0)
      throw UsageError(
          "--every skips pixels that the comparison with the truth needs; use it with --seconds 0");
    if (*suite != Suite::Scaling && maxSurfels)
      throw UsageError("--max-surfels belongs to bench scaling");
    if (*suite == Suite::Table1 && (edge || plot))
      throw UsageError("--size and --plot belong to bench methods and bench scaling");
    if (*suite == Suite::Table1 && (scene.any() || lights.any() || camera.any()))
      throw UsageError(
          "a scene, its medium, lights and camera belong to bench methods and bench scaling; "
          "table1 "
          "has its own");
  }

  Scene loadScene(const LogCallback& log) const {
    LoadedScene loaded = scene.load(log);
    lights.applyTo(loaded);
    camera.applyTo(loaded.scene);
    showAll(loaded.scene, {SceneTime{}.clip, 1, nullptr, {Moment{}}});
    return std::move(loaded.scene);
  }

  void run() const {
    if (plot) requireWritable(*plot);
    switch (*suite) {
      case Suite::Table1:
        return runTable1();
      case Suite::Methods:
        return runMethods();
      case Suite::Scaling:
        return runScaling();
    }
  }

  void runTable1() const {
    Table1Order order;
    order.models = folder();
    order.device = device();
    order.frames = frames.value_or(order.frames);
    order.log = noteTaker(quiet);
    order.status = statusTaker(quiet);
    const Table1 table = measureTable1(order);
    printOut(json ? toText(toJson(table)) : toReadable(table));
  }

  void runMethods() const {
    MethodsOrder order;
    order.log = noteTaker(quiet);
    order.status = statusTaker(quiet);
    order.scene = loadScene(order.log);
    order.edgePixels = edge.value_or(order.edgePixels);
    order.every = every.value_or(order.every);
    order.truthSeconds = seconds.value_or(order.truthSeconds);
    order.frames = frames.value_or(order.frames);
    order.all = all;
    order.device = device();
    if (truth) order.truth = readHdrImage(*truth);
    const Methods methods = measureMethods(order);
    if (plot) writeWhole(*plot, plotSvg(methods));
    printOut(json ? toText(toJson(methods)) : toReadable(methods));
  }

  void runScaling() const {
    ScalingOrder order;
    order.log = noteTaker(quiet);
    order.status = statusTaker(quiet);
    order.scene = loadScene(order.log);
    order.edgePixels = edge.value_or(order.edgePixels);
    order.mostSurfels = maxSurfels.value_or(order.mostSurfels);
    order.frames = frames.value_or(order.frames);
    order.device = device();
    const Scaling scaling = measureScaling(order);
    if (plot) writeWhole(*plot, plotSvg(scaling));
    printOut(json ? toText(toJson(scaling)) : toReadable(scaling));
  }
};

}  // namespace

void runBench(const Arguments& arguments) {
  CommandLine line("bench",
                   "Measures this machine's device; every frame is computed anew. In "
                   "[] is the default.");
  BenchCommand command;
  command.addTo(line);
  if (!line.parse(arguments)) return;
  command.check();
  command.run();
}

}  // namespace opaline::app
