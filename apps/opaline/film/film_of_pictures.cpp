#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <optional>
#include <string>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/fields.h"
#include "cli/frame_range.h"
#include "cli/json.h"
#include "cli/output.h"
#include "cli/paths.h"
#include "cli/progress.h"
#include "film/film_encoder.h"
#include "film/frames_asked_for.h"
#include "film/picture_row.h"
#include "opaline/error.h"
#include "opaline/file.h"
#include "opaline/options/picture.h"
#include "opaline/tone.h"

namespace opaline::app {

namespace fs = std::filesystem;

namespace {

struct FilmCommand {
  fs::path pictures;
  std::optional<fs::path> output;
  std::optional<FrameRange> frames;
  std::optional<double> framesPerSecond;
  bool check = false;
  options::Chosen<options::PictureSettings> look;
  bool json = false;
  bool quiet = false;

  void addTo(CommandLine& line) {
    line.requiredPositional("DIR", "its numbered .png or .exr pictures, or DIR/frame_%04d.png",
                            [this](const Given& given) { pictures = given.text; });
    line.value("-o,--output", "FILE", ".mp4 [named like DIR]",
               [this](const Given& given) { output = readOutput(given, {".mp4"}); });
    line.value("--frames", "A:B[:STEP]", "that must be there [from the first to the last there is]",
               [this](const Given& given) { frames = readFrames(given); });
    line.value("--fps", "N", "frames a second, 1 to 1000 [as rendered, or 30]",
               [this](const Given& given) { framesPerSecond = readFramesPerSecond(given); });
    line.flag("--check", "read all pictures, write nothing", check);
    const auto& exposure = options::fieldOf<options::PictureSettings>("exposure");
    addField(line, exposure, look, {},
             helpOf("of .exr pictures", exposure.allowed, exposure.like, "0"));
    addField(line, options::fieldOf<options::PictureSettings>("tone"), look, {},
             "curve for .exr pictures: none, neutral [neutral]");
    addField(line, options::fieldOf<options::PictureSettings>("background"), look, {},
             "behind what is not covered, linear, 0 to 1 [0,0,0]");
    line.outputFlags("what was done on standard output", json, quiet);
  }

  /// Refuses options that contradict each other, before any work.
  void requireUse() const {
    if (check && output) throw UsageError("--check writes nothing and needs no -o");
    if (check && (!look.empty() || framesPerSecond)) {
      throw UsageError("--check makes no film, so a speed or a look cannot be chosen");
    }
    const options::Value* const background = look.find("background");
    if (background != nullptr && !std::holds_alternative<Rgb>(*background)) {
      throw UsageError("--background of a film of pictures is a colour R,G,B");
    }
  }

  ToneOptions toneFor(const PictureRow& row) const {
    if (!row.isExr() && (look.has("exposure") || look.has("tone"))) {
      throw UsageError("--exposure and --tone are for .exr pictures; a .png has had them already");
    }
    options::PictureSettings settings;
    if (!row.isExr()) settings.tone.curve = ToneCurve::None;
    settings.tone.background = Rgb{0, 0, 0};  // a film has no alpha
    look.applyTo(settings);
    return settings.tone;
  }
};

std::string nameAfter(const fs::path& pictures) {
  std::error_code ignored;
  const fs::path folder = fs::absolute(
      fs::is_directory(pictures, ignored) ? pictures : pictures.parent_path(), ignored);
  const fs::path plain = folder.lexically_normal();
  const std::string name = (plain.has_filename() ? plain : plain.parent_path()).filename().string();
  return (name.empty() ? "film" : name) + ".mp4";
}

/// Calls `take` with every picture of the row.
template <typename Take>
void readAll(const PictureRow& row, bool quiet, const Take& take) {
  Progress bar(row.frames.count(), quiet);
  std::size_t done = 0;
  for (int frame = row.frames.first; frame <= row.frames.last; frame += row.frames.step) {
    take(readPicture(row, frame));
    bar.show(++done, 0);
  }
}

fs::path encode(const PictureRow& row, const Target& target, double framesPerSecond,
                const ToneOptions& tone, bool quiet, const LogCallback& log) {
  std::optional<FilmEncoder> encoder;
  WholeFile file(target);
  try {
    readAll(row, quiet, [&](const Image& picture) {
      if (!encoder) {
        if (const auto note = noteOnFilmSize(picture.width, picture.height))
          log(LogLevel::Note, *note);
        encoder.emplace(file.temporary(), picture.width, picture.height, framesPerSecond);
      }
      encoder->add(toneMap(picture, tone));
    });
    encoder->finish();
  } catch (const Error&) {
    throw;
  } catch (const std::exception& failure) {
    file.fail(failure.what());
  }
  return file.keep();
}

}  // namespace

void runFilm(const Arguments& arguments) {
  CommandLine line(
      "film",
      "Makes a film of numbered pictures, after it has seen that all of them are there "
      "and whole. Needs the program ffmpeg.");
  FilmCommand command;
  command.addTo(line);
  if (!line.parse(arguments)) return;
  command.requireUse();
  const LogCallback log = noteTaker(command.quiet);

  const Target target = command.output
                            ? Target(*command.output)
                            : Target(nameAfter(command.pictures), Existing::TakeNextName);
  if (!command.check) {
    requireFfmpeg();
    requireWritable(target);
  }
  const PictureRow row = findPictureRow(command.pictures, command.frames);
  const ToneOptions tone = command.toneFor(row);
  requireWhole(row);
  if (const auto note = noteOnOthers(row)) log(LogLevel::Note, *note);

  const FrameRange& frames = row.frames;
  Json report{{"frames", {frames.first, frames.last}},
              {"frame_step", frames.step},
              {"fps", nullptr},
              {"outputs", Json::array()}};
  if (command.check) {
    readAll(row, command.quiet, [](const Image&) {});
    log(LogLevel::Note, fmt::format("all {} frames are whole", frames.count()));
  } else {
    const double speed =
        command.framesPerSecond.value_or(framesPerSecondOf(row).value_or(frames.perSecond));
    const fs::path file = encode(row, target, speed, tone, command.quiet, log);
    log(LogLevel::Note,
        fmt::format("wrote {} to {}", countOfFrames(frames.count()), nameText(file, target.path)));
    report["fps"] = speed;
    report["outputs"].push_back(file.string());
  }
  if (command.json) printOut(toText(report));
}

}  // namespace opaline::app
