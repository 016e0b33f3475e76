#include "cli/motion_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "cli/fields.h"
#include "cli/values.h"
#include "opaline/error.h"
#include "opaline/options/scene.h"

namespace opaline::app {

namespace {

constexpr int lastFrame = 999999;
constexpr const char* noClip = "none";

std::vector<std::string> splitAtColons(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(':', begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

Deformer readDeformer(const Given& given) {
  const std::vector<std::string> parts = splitAtColons(given.text);
  Deformer deformer;
  const auto read = [&](std::string_view key, const Given& part) {
    const auto& field = options::fieldOf<Deformer>(key);
    field.set(deformer, readValue(part, field.allowed, field.like));
  };
  read("kind", {given.option, parts[0]});
  if (parts.size() != 2 && parts.size() != 3) {
    throw UsageError(fmt::format("{} {}: must be KIND:AMOUNT or KIND:AMOUNT:PERIOD, as {}:0.5:2",
                                 given.option, given.text, parts[0]));
  }
  const std::string option = given.option + " " + parts[0];
  if (parts.size() == 3) read("period_seconds", {option, parts[2]});
  deformer.amount =
      static_cast<float>(readNumber({option, parts[1]}, options::rangeOfAmount(deformer)));
  if (const std::string complaint = options::complaintAbout(deformer); !complaint.empty()) {
    throw UsageError(fmt::format("{} {}: {}", given.option, given.text, complaint));
  }
  return deformer;
}

FrameRange readFrames(const Given& given) {
  const std::vector<std::string> ends = splitAtColons(given.text);
  if (ends.size() != 2 && ends.size() != 3) {
    throw UsageError(
        fmt::format("{} {}: must be FIRST:LAST or FIRST:LAST:STEP, as 0:239 or 0:239:10",
                    given.option, given.text));
  }
  FrameRange frames;
  frames.first = readInteger({given.option, ends[0]}, 0, lastFrame);
  frames.last = readInteger({given.option, ends[1]}, 0, lastFrame);
  if (frames.first > frames.last) {
    throw UsageError(
        fmt::format("{} {}: the last frame comes before the first", given.option, given.text));
  }
  if (ends.size() == 3) {
    frames.step = readInteger({given.option, ends[2]}, 1, lastFrame);
    frames.last -= (frames.last - frames.first) % frames.step;
  }
  return frames;
}

int findClip(const Given& given, const Scene& scene) {
  Choices<int> choices{{noClip, -1}};
  for (const Clip& clip : scene.clips) {
    choices.emplace_back(clip.name, static_cast<int>(choices.size()) - 1);
  }
  if (choices.size() == 1 && given.text != noClip) {
    throw UsageError(fmt::format("{} {}: the scene has no clips", given.option, given.text));
  }
  return readChoice(given, choices);
}

bool moves(const Deformer& deformer) {
  return deformer.amount != 0 &&
         (deformer.kind == DeformerKind::Wobble || deformer.periodSeconds > 0);
}

}  // namespace

void MotionOptions::addTo(CommandLine& line, bool films) {
  addField(line, options::fieldOf<options::PictureSettings>("seconds"), chosen_, "--time");
  if (films) {
    line.value("--frames", "A:B[:STEP]", "a film; frame n shows time n / fps",
               [this](const Given& given) { frames_ = readFrames(given); });
    line.value("--fps", "N", "frames a second, 1 to 1000 [30]", [this](const Given& given) {
      framesPerSecond_ = readNumber(given, {1, 1000});
    });
  }
  addField(line, options::fieldOf<options::NamedSettings>("clip"), named_);
  line.repeated("--deform", "KIND:X[:PERIOD]", "twist or bend (radians), squash, wobble; seconds",
                [this](const Given& given) { deformers_.push_back(readDeformer(given)); });
}

void MotionOptions::check() const {
  if (!chosen_.empty() && frames_) {
    throw UsageError("--time is one moment and --frames are many: use one of the two");
  }
  if (framesPerSecond_ && !frames_) {
    throw UsageError("--fps is the speed of a film and needs --frames A:B; a still has --time");
  }
}

std::optional<FrameRange> MotionOptions::frames() const {
  std::optional<FrameRange> frames = frames_;
  if (frames && framesPerSecond_) frames->perSecond = *framesPerSecond_;
  return frames;
}

void MotionOptions::applyTo(Scene& scene) const {
  scene.deformers.insert(scene.deformers.end(), deformers_.begin(), deformers_.end());
}

SceneTime MotionOptions::time(const Scene& scene, const SceneFileSettings& settings) const {
  options::PictureSettings found;
  settings.picture.applyTo(found);
  chosen_.applyTo(found);
  SceneTime time = found.time;
  options::NamedSettings named = settings.named;
  named_.applyTo(named);
  if (named.clip)
    time.clip = findClip({named_.has("clip") ? "--clip" : "[render] clip", *named.clip}, scene);
  return time;
}

bool moves(const Scene& scene, int clip) {
  return (clip >= 0 && !scene.clips.empty()) ||
         std::any_of(scene.deformers.begin(), scene.deformers.end(),
                     [](const Deformer& deformer) { return moves(deformer); });
}

}  // namespace opaline::app
