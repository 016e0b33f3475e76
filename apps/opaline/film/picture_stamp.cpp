#include "film/picture_stamp.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <utility>

#include "cli/json.h"
#include "cli/picture_options.h"
#include "film/sequence_frames.h"
#include "opaline/digest.h"
#include "opaline/file.h"
#include "opaline/version.h"

namespace opaline::app {

namespace {

/// All options, read from their table.
std::string settingsText(const RenderOptions& options, const std::optional<ToneOptions>& tone) {
  std::string text = tone ? "with a tone curve\n" : "linear\n";
  const options::PictureSettings settings{.render = options, .tone = tone.value_or(ToneOptions{})};
  for (const auto& field : options::fieldsOf<options::PictureSettings>()) {
    // Each frame of a film has its own time.
    if (field.key == "seconds") continue;
    const std::optional<options::Value> value = field.get(settings);
    text += fmt::format("{} {}\n", field.key, value ? options::textOf(*value) : "");
  }
  return text + fmt::format("tree_level {}\n", options.treeLevel);
}

std::string digestText(const std::string& text) {
  return fmt::format("{:016x}", digestOf(std::as_bytes(std::span(text))));
}

std::uint64_t digestOfFile(const std::filesystem::path& file) {
  constexpr std::size_t mostBytes = std::size_t{1} << 31U;
  return digestOf(readFile(file, mostBytes));
}

/// What people want to know about a picture that they find.
Json readable(const PictureMakers& makers) {
  Json media = Json::array();
  for (const Object& object : makers.scene.objects) {
    if (object.opaque) continue;
    media.push_back({{"object", object.name},
                     {"medium", object.medium.name},
                     {"sigma_s_per_mm", object.medium.sigmaSPrimePerMm},
                     {"sigma_a_per_mm", object.medium.sigmaAPerMm},
                     {"eta", object.medium.eta},
                     {"g", object.medium.g}});
  }
  const RenderOptions& options = makers.options;
  Json json{{"program", "opaline " OPALINE_VERSION},
            {"scene", makers.scene.name},
            {"diagonal_mm", diagonalMm(makers.scene)},
            {"media", std::move(media)},
            {"size", {options.width, options.height}}};
  json.update(makers.method);
  return json;
}

}  // namespace

std::function<std::string(int frame)> frameStamps(const PictureMakers& makers,
                                                  const FrameRange& frames) {
  const std::string ofAll =
      fmt::format("{}\nscene {:016x}\n{}clip {}\nvariable {}\nmethod {}\nfps {}\n", OPALINE_VERSION,
                  digestOf(makers.scene), settingsText(makers.options, makers.tone), makers.clip,
                  static_cast<int>(makers.aov), makers.method.dump(), frames.perSecond);
  Json readableOfAll = readable(makers);
  readableOfAll["fps"] = frames.perSecond;
  readableOfAll["row"] = digestText(ofAll);
  return [ofAll, frames, json = std::move(readableOfAll), sequence = makers.sequence](int frame) {
    std::string all = ofAll + fmt::format("seconds {}\n", frames.seconds(frame));
    if (sequence) {
      const std::uint64_t mesh = digestOfFile(sequence->file(numberOfFrame(*sequence, frame)));
      all += fmt::format("mesh {:016x}\n", mesh);
    }
    Json stamp = json;
    stamp["seconds"] = frames.seconds(frame);
    stamp["digest"] = digestText(all);
    return stamp.dump(-1, ' ', true, Json::error_handler_t::replace);
  };
}

bool isSamePicture(const std::string& stamp, const std::string& other) {
  const auto digestOf = [](const std::string& text) {
    const Json json = Json::parse(text, nullptr, false);
    const bool holdsOne = json.is_object() && json.contains("digest");
    return holdsOne && json["digest"].is_string() ? json["digest"].get<std::string>() : "";
  };
  const std::string digest = digestOf(stamp);
  return !digest.empty() && digest == digestOf(other);
}

bool isSameRow(const std::string& stamp, const std::string& other) {
  if (stamp == other) return true;
  Json a = Json::parse(stamp, nullptr, false);
  Json b = Json::parse(other, nullptr, false);
  if (!a.is_object() || !b.is_object()) return a == b;
  const auto erase = [&](const char* key) {
    a.erase(key);
    b.erase(key);
  };
  for (const char* ofFrame : {"seconds", "digest"}) erase(ofFrame);
  // Older stamps lack these.
  for (const char* later : {"fps", "row"})
    if (!a.contains(later) || !b.contains(later)) erase(later);
  return a == b;
}

std::optional<double> secondsOf(const std::string& stamp) {
  const Json json = Json::parse(stamp, nullptr, false);
  const bool holdsIt = json.is_object() && json.contains("seconds") && json["seconds"].is_number();
  return holdsIt ? std::optional(json["seconds"].get<double>()) : std::nullopt;
}

}  // namespace opaline::app
