#include <fmt/format.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <array>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/device_options.h"
#include "cli/frame_names.h"
#include "cli/json.h"
#include "cli/motion_options.h"
#include "cli/output.h"
#include "cli/paths.h"
#include "cli/picture_options.h"
#include "cli/scene_options.h"
#include "cli/values.h"
#include "film/film.h"
#include "film/sequence_frames.h"
#include "opaline/error.h"
#include "opaline/file.h"
#include "viewer/viewer.h"

namespace opaline::app {

namespace {

struct ViewCommand {
  SceneOptions scene;
  LightOptions lights;
  CameraOptions camera;
  MotionOptions motion;
  MethodOptions method;
  LookOptions look;
  std::optional<std::array<int, 2>> size;
  AovOption variable;
  std::optional<std::filesystem::path> output;
  DeviceOptions device;
  std::optional<std::filesystem::path> report;
  std::optional<std::filesystem::path> controls;
  bool quiet = false;
  bool json = false;

  void addTo(CommandLine& line) {
    line.section("Scene");
    scene.addTo(line);
    line.section(LightOptions::section);
    lights.addTo(line);
    line.section("Picture");
    camera.addTo(line);
    look.addTo(line);
    line.value(
        "--size", "WxH", "of the window, pixels [as it was left]", [this](const Given& given) {
          size = readSize(given, options::fieldOf<options::PictureSettings>("size").allowed.range);
        });
    line.value("-o,--output", "FILE", "to save, when you ask for it: .png, .exr, .mp4",
               [this](const Given& given) {
                 output = readOutput(given, {".png", ".exr", ".mp4"});
               });
    variable.addTo(line, "shows");
    line.section("Motion");
    motion.addTo(line, false);
    line.section("Method");
    method.addTo(line);
    line.section("Run");
    device.addTo(line);
    line.value("--report", "FILE.json", "report of the last picture, at the end",
               [this](const Given& given) { report = readOutput(given, {".json"}); });
    line.outputFlags("the same on standard output", json, quiet);
    line.value("--controls", "FILE.json", "writes where each control is, to drive the window",
               [this](const Given& given) { controls = readOutput(given, {".json"}); });
  }

  /// Refuses options that contradict each other, and files that cannot be written, before any
  /// window opens.
  void check() const {
    scene.checkMedia();
    camera.check();
    static_cast<void>(options({}));
    if (const auto frames = motion.frames()) requireEveryFrame(*frames);
    if (output && FrameNames::parse(output->string())) {
      throw UsageError(
          fmt::format("-o {}: the window saves one picture or a film at a time; render "
                      "--frames makes numbered pictures",
                      output->string()));
    }
    if (output) requireWritable({*output, Existing::TakeNextName});
    if (report) requireWritable(*report);
  }

  /// Refuses options that contradict each other, too.
  RenderOptions options(const SceneFileSettings& settings) const {
    RenderOptions options = optionsOf(settings);
    method.applyTo(options, settings);
    look.applyTo(options);
    if (variable.aov()) requireMethodFor(*variable.aov(), options);
    return options;
  }

  /// The film, and the variable that is shown.
  void chooseWhatIsShown(const LoadedScene& loaded, viewer::Session& session) const {
    if (const auto rate = motion.framesPerSecond()) session.film.perSecond = *rate;
    if (const auto frames = motion.frames()) {
      const MeshSequence* const sequence = loaded.sequence.get();
      if (sequence != nullptr) static_cast<void>(numberOfFrame(*sequence, frames->last));
      session.film = {frames->perSecond, false, frames->first, frames->last};
      if (!motion.asksForTime() && !loaded.settings.picture.has("seconds"))
        session.time.seconds = shownAt(sequence, *frames, frames->first);
    }
    session.aov = variable.aov().value_or(Aov::Radiance);
    if (const auto level = variable.treeLevel()) {
      session.treeLevel = *level;
      session.surfelIndex = viewer::SurfelIndex::Node;
    }
  }

  void nameFiles(viewer::Session& session) const {
    if (!output) return;
    session.saveName = (output->parent_path() / output->stem()).string();
    if (extensionOf(*output) == ".exr") session.savedByKey = viewer::Save::Exr;
  }

  void prepare(LoadedScene& loaded, viewer::Session& session) const {
    lights.applyTo(loaded);
    camera.applyTo(loaded.scene);
    motion.applyTo(loaded.scene);
    session.options = options(loaded.settings);
    session.time = motion.time(loaded.scene, loaded.settings);
    session.tone = look.tone(loaded.settings, loaded.scene);
    session.exposesByLight = look.exposesByLight(loaded.settings);
    chooseWhatIsShown(loaded, session);
    nameFiles(session);
    if (const options::Value* given = loaded.settings.picture.find("size")) {
      session.pictureSize = std::get<options::Size>(*given);
    }
  }
};

/// Makes large blocks return to the system when they are freed. By default glibc raises its
/// threshold for them up to 32 MB. Hundreds of megabytes would then stay in holes of the heap after
/// some hundred edits.
void returnLargeBlocks() {
#ifdef __GLIBC__
  constexpr int largeBytes = 1 << 20;
  constexpr int keptAtEndBytes = 16 << 20;
  mallopt(M_MMAP_THRESHOLD, largeBytes);
  mallopt(M_TRIM_THRESHOLD, keptAtEndBytes);
#endif
}

/// $XDG_CONFIG_HOME/opaline, by default ~/.config/opaline. Empty where the folder neither exists
/// nor can be made.
std::filesystem::path configFolder() {
  const char* const config = std::getenv("XDG_CONFIG_HOME");
  const char* const home = std::getenv("HOME");
  std::filesystem::path folder;
  if (config != nullptr && *config == '/') {
    folder = config;
  } else if (home != nullptr && *home == '/') {
    folder = std::filesystem::path(home) / ".config";
  } else {
    return {};
  }
  folder /= "opaline";
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  return std::filesystem::is_directory(folder, error) ? folder : std::filesystem::path();
}

}  // namespace

void runView(const Arguments& arguments) {
  CommandLine line("view",
                   "Opens a window on a scene. Lengths in mm, light in linear RGB, "
                   "defaults in [].");
  ViewCommand command;
  command.addTo(line);
  if (!line.parse(arguments)) return;
  command.check();
  command.device.limitHostMemory();
  returnLargeBlocks();
  const LogCallback log = noteTaker(command.quiet);
  viewer::ViewerOptions options;
  options.source = command.scene;
  // The options apply to the first scene; later ones are shown as their files say.
  options.prepare = [next = command](LoadedScene& loaded, viewer::Session& session) mutable {
    std::exchange(next, {}).prepare(loaded, session);
  };
  options.renderer = command.device.rendererOptions("", log);
  options.size = command.size;
  options.configFolder = configFolder();
  options.controls = command.controls;
  viewer::Viewer viewer(options);
  viewer.run();
  const std::string report = toText(viewer.report());
  if (command.report) writeWhole(*command.report, report);
  if (command.json) printOut(report);
  if (viewer.validationMessages() > 0) {
    throw Error(fmt::format("--validation: the validation layer had {} messages",
                            viewer.validationMessages()));
  }
}

}  // namespace opaline::app
