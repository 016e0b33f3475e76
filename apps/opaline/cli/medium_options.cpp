#include "cli/medium_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "cli/fields.h"
#include "opaline/error.h"
#include "opaline/media.h"

namespace opaline::app {

namespace {

/// "there is no medium 'marbel'; did you mean marble? The scene has mine, and opaline media lists
/// all others".
std::string unknown(const std::string& name, const OwnMedia& own) {
  std::vector<std::string> names;
  for (const auto& [key, medium] : own) names.push_back(key);
  const std::string ofScene = fmt::format("{}", fmt::join(names, ", "));
  for (const auto& row : measuredMedia()) names.push_back(row.medium.name);
  for (const Medium& medium : artisticMedia()) names.push_back(medium.name);
  const std::string start = fmt::format("there is no medium '{}'", name);
  if (own.empty()) return start + suggestion(name, names, "opaline media");
  const std::string nearest = suggestion(name, names);
  return fmt::format("{}{} the scene has {}, and opaline media lists all others", start,
                     nearest.empty() ? ";" : nearest, ofScene);
}

}  // namespace

void MediumOptions::addTo(CommandLine& line) {
  line.repeated("--medium", "NAME[@OBJECT]", "of opaline media, or under [media] of the scene",
                [this](const Given& given) { read(given); });
  addCoefficientsTo(line);
}

void MediumOptions::addWithoutObjectsTo(CommandLine& line) {
  line.value("--medium", "NAME", "a name that opaline media lists", [this](const Given& given) {
    if (const std::size_t at = given.text.find('@'); at != std::string::npos)
      throw UsageError(fmt::format("{} {}: there are no objects here; name the medium alone, {}",
                                   given.option, given.text, given.text.substr(0, at)));
    read(given);
  });
  addCoefficientsTo(line);
}

void MediumOptions::addCoefficientsTo(CommandLine& line) {
  addField(line, options::fieldOf<Medium>("sigma_s_per_mm"), chosen_, "--sigma-s",
           "reduced scattering and absorption, 1/mm");
  addField(line, options::fieldOf<Medium>("sigma_a_per_mm"), chosen_, "--sigma-a", "");
  addTogether(line, {"eta", "g"}, {"index of refraction", "mean cosine"}, chosen_);
}

void MediumOptions::read(const Given& given) {
  const std::size_t at = given.text.find('@');
  Named named{given, given.text.substr(0, at), {}};
  const auto refuse = [&](const char* why) {
    throw UsageError(fmt::format("{} {}: {}", given.option, given.text, why));
  };
  if (at == std::string::npos) {
    if (named_) refuse("the medium of all objects is given twice; NAME@OBJECT is that of one");
    named_ = std::move(named);
    return;
  }
  named.object = given.text.substr(at + 1);
  if (named.object.empty()) refuse("the name of an object is missing after the @");
  if (std::any_of(ofObjects_.begin(), ofObjects_.end(),
                  [&](const Named& before) { return before.object == named.object; }))
    refuse("the medium of this object is given twice");
  ofObjects_.push_back(std::move(named));
}

Medium MediumOptions::found(const Named& named, const OwnMedia& own) {
  if (const auto medium = own.find(named.medium); medium != own.end()) return medium->second;
  if (auto medium = findMedium(named.medium)) return *medium;
  throw UsageError(
      fmt::format("{} {}: {}", named.given.option, named.given.text, unknown(named.medium, own)));
}

std::vector<MediumOfObject> MediumOptions::ofObjects(const OwnMedia& own) const {
  std::vector<MediumOfObject> media;
  for (const Named& named : ofObjects_) media.push_back({named.object, found(named, own)});
  return media;
}

std::optional<Medium> MediumOptions::medium(const OwnMedia& own) const {
  const bool scatters = chosen_.has("sigma_s_per_mm");
  const bool absorbs = chosen_.has("sigma_a_per_mm");
  if (!scatters && !absorbs) {
    if (chosen_.has("eta")) {
      throw UsageError("--eta belongs to --sigma-s and --sigma-a; a named medium has its own");
    }
    if (chosen_.has("g") && !named_) {
      throw UsageError("--g needs --medium NAME, or --sigma-s and --sigma-a, beside it");
    }
    if (!named_) return std::nullopt;
    Medium medium = found(*named_, own);
    chosen_.applyTo(medium);
    return medium;
  }
  if (named_) throw UsageError("--medium and --sigma-s or --sigma-a exclude each other");
  if (!absorbs) throw UsageError("--sigma-s needs --sigma-a beside it");
  if (!scatters) throw UsageError("--sigma-a needs --sigma-s beside it");
  Medium medium;
  medium.name = "custom";
  chosen_.applyTo(medium);
  return medium;
}

}  // namespace opaline::app
