#include "cli/medium_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "cli/fields.h"
#include "opaline/error.h"
#include "opaline/media.h"

namespace opaline::app {

namespace {

Medium namedMedium(const Given& given, std::string_view name) {
  if (auto medium = findMedium(name)) return *medium;
  std::vector<std::string> names;
  for (const auto& row : measuredMedia()) names.push_back(row.medium.name);
  for (const Medium& medium : artisticMedia()) names.push_back(medium.name);
  throw UsageError(fmt::format("{} {}: there is no medium '{}'{}", given.option, given.text, name,
                               suggestion(name, names, "opaline media")));
}

constexpr const char* helpOnNames = "a name that opaline media lists";

}  // namespace

void MediumOptions::addTo(CommandLine& line) {
  line.repeated("--medium", "NAME[@OBJECT]", helpOnNames,
                [this](const Given& given) { read(given); });
  addCoefficientsTo(line);
}

void MediumOptions::addWithoutObjectsTo(CommandLine& line) {
  line.value("--medium", "NAME", helpOnNames, [this](const Given& given) {
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
  const std::string_view text = given.text;
  const std::size_t at = text.find('@');
  const Medium medium = namedMedium(given, text.substr(0, at));
  if (at != std::string_view::npos) {
    if (at + 1 == text.size()) {
      throw UsageError(fmt::format("{} {}: the name of an object is missing after the @",
                                   given.option, given.text));
    }
    const std::string_view object = text.substr(at + 1);
    for (const MediumOfObject& before : ofObjects_) {
      if (before.object != object) continue;
      throw UsageError(
          fmt::format("{} {}: the medium of this object is given twice", given.option, text));
    }
    ofObjects_.push_back({std::string(object), medium});
    return;
  }
  if (named_) {
    throw UsageError(
        fmt::format("{} {}: the medium of all objects is given twice; NAME@OBJECT is "
                    "that of one",
                    given.option, given.text));
  }
  named_ = medium;
}

std::optional<Medium> MediumOptions::medium() const {
  const bool scatters = chosen_.has("sigma_s_per_mm");
  const bool absorbs = chosen_.has("sigma_a_per_mm");
  if (!scatters && !absorbs) {
    if (chosen_.has("eta")) {
      throw UsageError("--eta belongs to --sigma-s and --sigma-a; a named medium has its own");
    }
    if (chosen_.has("g") && !named_) {
      throw UsageError("--g needs --medium NAME, or --sigma-s and --sigma-a, beside it");
    }
    std::optional<Medium> medium = named_;
    if (medium) chosen_.applyTo(*medium);
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
