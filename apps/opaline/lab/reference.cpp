#include <fmt/format.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/json.h"
#include "cli/motion_options.h"
#include "cli/object_sizes.h"
#include "cli/output.h"
#include "cli/paths.h"
#include "cli/picture_options.h"
#include "cli/progress.h"
#include "cli/scene_options.h"
#include "cli/values.h"
#include "film/film_output.h"
#include "film/framing.h"
#include "film/sequence_frames.h"
#include "lab/path_method.h"
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

rf::Region readRegion(const Given& given) {
  const auto refuse = [&] {
    throw UsageError(fmt::format("{} {}: must be X,Y,WIDTH,HEIGHT, whole numbers of pixels",
                                 given.option, given.text));
  };
  std::array<int, 4> values{};
  std::size_t begin = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t comma = given.text.find(',', begin);
    if ((comma == std::string::npos) != (i + 1 == values.size())) refuse();
    try {
      values[i] = readInteger({given.option, given.text.substr(begin, comma - begin)}, 0, 16384);
    } catch (const UsageError&) {
      // That message would quote one number as if it were the whole argument.
      refuse();
    }
    begin = comma + 1;
  }
  return {values[0], values[1], values[2], values[3]};
}

struct ReferenceCommand {
  SceneOptions scene;
  LightOptions lights;
  CameraOptions camera;
  MotionOptions motion;
  PictureOptions picture;
  bool integral = false;
  bool ambientOcclusion = false;
  std::optional<Transport> transport;
  std::optional<double> tolerance;
  PathMethod path;
  std::optional<rf::Region> region;
  int every = 1;
  std::optional<std::filesystem::path> report;
  bool quiet = false;
  bool json = false;

  void addTo(CommandLine& line) {
    line.section("Scene");
    scene.addTo(line);
    line.section("Light; lights given here replace all lights of the scene");
    lights.addTo(line);
    line.section("Picture");
    camera.addTo(line);
    picture.addTo(line, {.films = false, .sourceMap = false});
    line.value("--region", "X,Y,W,H", "only these pixels, from the upper left",
               [this](const Given& given) { region = readRegion(given); });
    line.value("--every", "N", "only every N-th pixel across and down [1]",
               [this](const Given& given) { every = readInteger(given, 1, 16384); });
    line.section("Motion");
    motion.addTo(line, false);
    line.section("Method");
    line.flag("--integral", "the exact surface integral of the dipole", integral);
    line.value(
        "--transport", "NAME", "dipole or better-dipole [dipole]",
        [this](const Given& given) { transport = readChoice(given, halfSpaceTransports()); });
    line.value("--tolerance", "X", "relative error allowed, 1e-7 to 0.5 [0.001]",
               [this](const Given& given) {
                 tolerance = readNumber(given, {1e-7, 0.5});
               });
    line.flag("--ambient-occlusion", "what hides the sky darkens --aov irradiance",
              ambientOcclusion);
    path.addTo(line);
    line.section("Run");
    line.value("--report", "FILE.json", "what was done, and how exact it is",
               [this](const Given& given) { report = readOutput(given, {".json"}); });
    line.outputFlags("the report on standard output", json, quiet);
  }

  /// Refuses options that contradict each other or that only the GPU renderer supports, before any
  /// work.
  void check() const {
    if (integral == path.wanted()) {
      throw UsageError("reference needs one method: --integral or --path");
    }
    if (path.wanted() && (transport || tolerance)) {
      throw UsageError("--transport and --tolerance belong to --integral");
    }
    if (ambientOcclusion && (path.wanted() || picture.aov() != Aov::Irradiance)) {
      throw UsageError(
          "--ambient-occlusion needs --integral --aov irradiance: of light that has scattered, "
          "only "
          "--path finds it");
    }
    camera.check();
    picture.requireNameOfStill();
    if (!picture.seenByCamera()) {
      throw UsageError("--aov dsm-*: the reference has no diffusion source map; render shows it");
    }
    if (picture.aov() == Aov::Evaluations) {
      throw UsageError("--aov evaluations: counts the work of render; the reference has none");
    }
    if (picture.aov() == Aov::Surfels) {
      throw UsageError("--aov surfels: the reference works without surfels; render shows them");
    }
    if (picture.asksForReflection() && integral) {
      throw UsageError(
          "--roughness: the integral leaves out reflections; compare it with render "
          "--no-specular");
    }
    static_cast<void>(options({}));
  }

  RenderOptions options(const SceneFileSettings& settings) const {
    RenderOptions options = optionsOf(settings);
    options.transport = reference::transportOfIntegral(options.transport);
    if (transport) options.transport = *transport;
    picture.applyTo(options);
    return options;
  }

  /// The outputs that were named.
  std::vector<Output> outputs() const {
    std::vector<Output> outputs;
    if (picture.hasFile()) outputs.push_back({"-o", picture.target("", {}).path});
    if (report) outputs.push_back({"--report", *report});
    if (path.checkpoint()) outputs.push_back({"--checkpoint", *path.checkpoint()});
    return outputs;
  }

  double toleranceOf() const { return tolerance.value_or(rf::IntegralOptions{}.tolerance); }

  rf::PictureOptions pictureOptions(const RenderOptions& render) const {
    rf::PictureOptions options;
    options.width = render.width;
    options.height = render.height;
    options.aov = picture.aov();
    options.antialias = render.antialias;
    options.environmentBehind = render.environmentBehind;
    options.eye = {render.specular, double{render.roughness}};
    options.region = region;
    options.every = every;
    return options;
  }
};

/// Everything that is settled before the computation starts.
struct ReferenceJob {
  rf::Scene scene;
  RenderOptions options;
  ToneOptions tone;
  Target output;
};

/// The positions of a still, read from a sequence's files.
PositionsByObject positionsOf(const MeshSequence* sequence, double seconds) {
  PositionsByObject positionsMm;
  if (sequence) sequence->read(numberAt(*sequence, seconds), positionsMm[0]);
  return positionsMm;
}

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
  showAll(scene,
          {time.clip, aspectOf(options), sequence.get(), momentOf(time.seconds, sequence.get())});
  if (command.integral && options.specular && command.picture.aov() == Aov::Radiance) {
    log(LogLevel::Note,
        "the integral leaves out the reflection on surfaces; compare it with render "
        "--no-specular");
  }
  requireNoInput(command.outputs(), filesOf(source));
  const ToneOptions tone = command.picture.tone(settings, scene);
  const auto exposure = command.picture.noteOnExposure(settings, tone);
  if (exposure) log(LogLevel::Note, *exposure);
  return {reference::posedScene(scene, time, positionsOf(sequence.get(), time.seconds)), options,
          tone, std::move(output)};
}

/// The result of the computation.
struct Made {
  rf::Picture picture;
  Json facts = Json::object();  ///< specific to the method
  double blockError = 0;        ///< with --path only
};

Made makeIntegral(const ReferenceCommand& command, const ReferenceJob& job) {
  using Sky = rf::Irradiance::Sky;
  const rf::Geometry geometry(job.scene);
  const rf::Irradiance irradiance(geometry,
                                  command.ambientOcclusion ? Sky::Shadowed : Sky::Unshadowed);
  std::optional<Progress> progress;
  reference::IntegralTruth truth = reference::integralTruth(
      geometry, irradiance, {job.options.transport, command.toleranceOf()},
      command.pictureOptions(job.options), [&](std::size_t done, std::size_t total) {
        if (!progress) progress.emplace(total, command.quiet, "pixel");
        progress->show(done, 0);
      });
  return {std::move(truth.picture),
          {{"transport", options::nameOf(job.options.transport)},
           {"tolerance", command.toleranceOf()},
           {"patches", truth.patches}}};
}

Made makePath(const ReferenceCommand& command, const ReferenceJob& job, const LogCallback& log) {
  const rf::Geometry geometry(job.scene);
  const rf::Irradiance irradiance(geometry);
  Made made;
  made.picture = command.path.make(geometry, irradiance, command.pictureOptions(job.options),
                                   command.quiet, log, made.facts);
  made.blockError = made.facts.at("block_error");
  return made;
}

Json reportJson(const ReferenceCommand& command, const ReferenceJob& job, const Made& made,
                double seconds, const std::filesystem::path& file) {
  std::size_t triangles = 0;
  std::size_t vertices = 0;
  for (const rf::Body& body : job.scene.bodies) {
    triangles += body.triangles.size();
    vertices += body.positionsMm.size();
  }
  const rf::ErrorSummary& error = made.picture.error;
  Json json{
      {"method", command.integral ? "integral" : "path"},
      {"size", {job.options.width, job.options.height}},
      {"triangles", triangles},
      {"vertices", vertices},
      {"pixels", made.picture.pixels},
      {"relative_error",
       {{"mean", error.mean}, {"p95", error.percentile95}, {"max", error.largest}}},
      {"seconds", seconds},
      {"exposure_stops", command.picture.isExr() ? Json() : shortJson(job.tone.exposureStops)},
      {"outputs", {file.string()}}};
  json.update(made.facts);
  return json;
}

}  // namespace

void runReference(const Arguments& arguments) {
  CommandLine line(
      "reference",
      "A still on the CPU, exactly. Lengths in mm, light in linear RGB, defaults in [].");
  ReferenceCommand command;
  command.addTo(line);
  if (!line.parse(arguments)) return;
  command.check();

  const auto begin = std::chrono::steady_clock::now();
  const LogCallback log = noteTaker(command.quiet);
  Target output = command.picture.target(command.scene.name(), std::nullopt);
  command.path.check(output.path, command.report);
  requireWritable(output);
  if (command.report) requireWritable(*command.report);

  const ReferenceJob job = prepareReference(command, std::move(output), log);
  const Made made = command.integral ? makeIntegral(command, job) : makePath(command, job, log);
  const std::filesystem::path file = writePicture(job.output, made.picture.image, job.tone);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  std::string note =
      fmt::format("wrote {}, in {:.1f} s", nameText(file, job.output.path), seconds.count());
  if (rf::showsExitance(command.picture.aov())) {
    // Single pixels of a path-traced picture are noise, and pixels without particles show nothing,
    // so blocks are judged.
    note += command.integral
                ? fmt::format("; estimated error {:.2g} in the mean, {:.2g} at most",
                              made.picture.error.mean, made.picture.error.largest)
                : fmt::format("; standard error of 8x8 blocks {:.2g}", made.blockError);
  }
  log(LogLevel::Note, note);
  const std::string report = toText(reportJson(command, job, made, seconds.count(), file));
  if (command.report) writeWhole(*command.report, report);
  if (command.json) printOut(report);
}

}  // namespace opaline::app
