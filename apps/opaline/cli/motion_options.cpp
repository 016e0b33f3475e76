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

constexpr const char* noClip = "none";

Deformer readDeformer(const Given& given) {
  const std::vector<std::string_view> parts = split(given.text, ':');
  Deformer deformer;
  const auto read = [&](std::string_view key, const Given& part) {
    const auto& field = options::fieldOf<Deformer>(key);
    field.set(deformer, readValue(part, field.allowed, field.like));
  };
  read("kind", {given.option, std::string(parts[0])});
  if (parts.size() != 2 && parts.size() != 3) {
    throw UsageError(fmt::format("{} {}: must be KIND:AMOUNT or KIND:AMOUNT:PERIOD, as {}:0.5:2",
                                 given.option, given.text, parts[0]));
  }
  const std::string option = fmt::format("{} {}", given.option, parts[0]);
  if (parts.size() == 3) read("period_seconds", {option, std::string(parts[2])});
  deformer.amount = static_cast<float>(
      readNumber({option, std::string(parts[1])}, options::rangeOfAmount(deformer)));
  if (const std::string complaint = options::complaintAbout(deformer); !complaint.empty()) {
    throw UsageError(fmt::format("{} {}: {}", given.option, given.text, complaint));
  }
  return deformer;
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

void MotionOptions::addTo(CommandLine& line, bool chunks) {
  addField(line, options::fieldOf<options::PictureSettings>("seconds"), chosen_, "--time");
  line.value("--frames", chunks ? "A:B[:STEP]" : "A:B", "a film; frame n shows time n / fps",
             [this](const Given& given) { frames_ = readFrames(given); });
  line.value("--fps", "N",
             chunks ? "N frames a second [30]; only part I of N of them" : "frames a second [30]",
             [this](const Given& given) { framesPerSecond_ = readFramesPerSecond(given); });
  if (chunks)
    line.value("--chunk", "I/N", "", [this](const Given& given) { chunk_ = readChunk(given); });
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
  if (chunk_ && !frames_) {
    throw UsageError("--chunk is a part of many frames and needs --frames A:B");
  }
}

std::optional<FrameRange> MotionOptions::frames() const {
  std::optional<FrameRange> frames = frames_;
  if (frames && framesPerSecond_) frames->perSecond = *framesPerSecond_;
  return frames;
}

std::optional<FrameRange> MotionOptions::framesOfChunk() const {
  const std::optional<FrameRange> all = frames();
  return all && chunk_ ? framesOf(*chunk_, *all) : all;
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
