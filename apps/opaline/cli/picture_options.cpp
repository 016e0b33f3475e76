#include "cli/picture_options.h"

#include <fmt/format.h>

#include "cli/fields.h"
#include "cli/frame_names.h"
#include "cli/paths.h"
#include "opaline/error.h"
#include "opaline/exposure.h"

namespace opaline::app {

namespace {

const Choices<Aov>& aovs() {
  static const Choices<Aov> table = [] {
    Choices<Aov> choices;
    for (const std::string_view name : options::namesOf<Aov>()) {
      choices.push_back({std::string(name), options::named<Aov>(name)});
    }
    return choices;
  }();
  return table;
}

using Chosen = options::Chosen<options::PictureSettings>;

/// Chooses what --method paper stands for, unless another value was given.
void choosePaper(Chosen& chosen, std::string_view key, std::string_view paper) {
  const options::Value* const asked = chosen.find(key);
  if (asked && options::textOf(*asked) != paper) {
    throw UsageError(fmt::format("{} {} contradicts --method paper, which means {}", optionOf(key),
                                 options::textOf(*asked), paper));
  }
  chosen.set(options::fieldOf<options::PictureSettings>(key), std::string(paper));
}

/// Throws UsageError for what was typed though nothing reads it.
void refuseUnused(const Chosen& chosen, const RenderOptions& options) {
  const auto unused = options::findUnused(chosen, options, asTyped);
  if (!unused) return;
  const auto& field = options::fieldOf<options::PictureSettings>(unused->key);
  throw UsageError(fmt::format("{} {}", asTyped(field, *chosen.find(unused->key)), unused->why));
}

}  // namespace

const Choices<Transport>& halfSpaceTransports() {
  static const Choices<Transport> table{{"dipole", Transport::Dipole},
                                        {"better-dipole", Transport::BetterDipole}};
  return table;
}

RenderOptions optionsOf(const SceneFileSettings& settings) {
  RenderOptions options;
  options::apply(settings.picture, options);
  return options;
}

SceneFileSettings settingsOf(const options::PictureSettings& picture, const Scene& scene) {
  SceneFileSettings settings;
  settings.picture = options::chosenIn(picture);
  const int clip = picture.time.clip;
  if (clip < 0) {
    settings.named.clip = "none";
  } else if (static_cast<std::size_t>(clip) < scene.clips.size()) {
    settings.named.clip = scene.clips[static_cast<std::size_t>(clip)].name;
  }
  return settings;
}

ToneOptions toneOf(const SceneFileSettings& settings, const Scene& scene) {
  options::PictureSettings found;
  if (!settings.picture.has("exposure")) found.tone.exposureStops = automaticExposureStops(scene);
  settings.picture.applyTo(found);
  return found.tone;
}

void MethodOptions::addTo(CommandLine& line) {
  constexpr std::array<std::string_view, 3> choices{"transport", "sum", "site"};
  constexpr std::array<std::string_view, 3> shapes{"tolerance", "bounces", "ambient_occlusion"};
  addFields<options::PictureSettings>(line, choices, chosen_);
  line.value("--method", "paper", "dipole, pattern, fragment", [this](const Given& given) {
    paper_ = readChoice<bool>(given, {{"paper", true}});
  });
  addFields<options::PictureSettings>(line, shapes, chosen_);
  addTogether(line, {"max_clusters", "max_surfels"}, {"at most", "and"}, chosen_);
  addTogether(line, {"near_spacing", "far_distance"}, {"mean free paths", "of far samples"},
              chosen_);
  addTogether(line, {"near_rings", "dsm_size", "shadow_size"}, {"rings", "texels", "and"}, chosen_);
}

void MethodOptions::applyTo(RenderOptions& options, const SceneFileSettings& settings) const {
  Chosen chosen = chosen_;
  if (paper_) {
    choosePaper(chosen, "transport", options::nameOf(Transport::Dipole));
    choosePaper(chosen, "sum", options::nameOf(Sum::Pattern));
    choosePaper(chosen, "site", options::nameOf(Site::Fragment));
  }
  options::apply(chosen, options);
  if (!settings.picture.has("transport") && !chosen.has("transport"))
    options::chooseTransport(options);
  refuseUnused(chosen, options);
}

void MethodOptions::requireUse(const RenderOptions& options, Aov aov) const {
  requireMethodFor(aov, options);
  if (!chosen_.has("dsm_size") || options.sum == Sum::Pattern || showsMap(aov)) return;
  throw UsageError(
      "--dsm-size is of the diffusion source map, which only --sum pattern and --aov dsm-* make");
}

void LookOptions::addTo(CommandLine& line) {
  constexpr std::array<std::string_view, 2> before{"antialias", "specular"};
  constexpr std::array<std::string_view, 2> after{"tone", "background"};
  addFields<options::PictureSettings>(line, before, chosen_);
  addTogether(line, {"roughness", "exposure"}, {"of that reflection", "stops"}, chosen_);
  addFields<options::PictureSettings>(line, after, chosen_);
}

bool LookOptions::asksForAntialiasing() const {
  const options::Value* const samples = chosen_.find("antialias");
  return samples != nullptr && std::get<int>(*samples) != 1;
}

bool LookOptions::asksForTone() const {
  const options::Value* const background = chosen_.find("background");
  return chosen_.has("exposure") || chosen_.has("tone") ||
         (background != nullptr && std::holds_alternative<Rgb>(*background));
}

void LookOptions::applyTo(RenderOptions& options) const {
  options::apply(chosen_, options);
  refuseUnused(chosen_, options);
}

ToneOptions LookOptions::tone(const SceneFileSettings& settings, const Scene& scene) const {
  options::PictureSettings found{.tone = toneOf(settings, scene)};
  chosen_.applyTo(found);
  return found.tone;
}

void AovOption::addTo(CommandLine& line, const std::string& what, bool surfels) {
  line.value("--aov", "NAME",
             fmt::format("{} radiance exitance irradiance position normal depth object{}", what,
                         surfels ? " evaluations surfels[:N] dsm-*" : ""),
             [this](const Given& given) { take(given); });
}

void AovOption::take(const Given& given) {
  const std::string withLevel = "surfels:";
  treeLevel_.reset();
  if (given.text.rfind(withLevel, 0) != 0) {
    aov_ = readChoice(given, aovs());
    return;
  }
  aov_ = Aov::Surfels;
  treeLevel_ = readInteger({given.option, given.text.substr(withLevel.size()), given.text}, 0, 64);
}

void requireMethodFor(Aov aov, const RenderOptions& options) {
  if (aov != Aov::Surfels || options.sum != Sum::Pattern) return;
  throw UsageError("--aov surfels needs --sum tree or --sum all; the pattern has no surfels");
}

void PictureOptions::addTo(CommandLine& line, bool surfels) {
  line.value("-o,--output", "FILE", ".png, .exr (linear), frame_%04d.png, film.mp4",
             [this](const Given& given) {
               file_ = readOutput(given, {".png", ".exr", ".mp4"});
             });
  addField(line, options::fieldOf<options::PictureSettings>("size"), chosen_);
  aov_.addTo(line, "EXR of", surfels);
  look_.addTo(line);
}

void PictureOptions::applyTo(RenderOptions& options) const {
  const bool picture = aov() == Aov::Radiance;
  if (aov_.aov() && !isExr()) {
    throw UsageError("--aov writes values, not colours: the name after -o must end in .exr");
  }
  if (isExr() && look_.asksForTone()) {
    throw UsageError(
        "--exposure, --tone and a --background of one colour belong to PNG pictures and films; an "
        "EXR file keeps linear radiance");
  }
  if (!picture && look_.asksForAntialiasing()) {
    throw UsageError("--antialias belongs to radiance; other AOVs are sampled once a pixel");
  }
  options::apply(chosen_, options);
  if (aov_.treeLevel()) options.treeLevel = *aov_.treeLevel();
  look_.applyTo(options);
  if (!picture) options.antialias = 1;
}

std::optional<std::string> PictureOptions::noteOnExposure(const SceneFileSettings& settings,
                                                          const ToneOptions& tone) const {
  if (isExr() || !look_.exposesByLight(settings) || tone.exposureStops == 0) return std::nullopt;
  return fmt::format("exposure set to {:+} stops to suit the light; --exposure 0 keeps it at 0",
                     tone.exposureStops);
}

bool PictureOptions::isExr() const {
  return file_ ? extensionOf(*file_) == ".exr" : aov_.aov().has_value();
}

void PictureOptions::requireNameFor(bool frames, bool resume, bool chunk) const {
  const std::string name = file_ ? file_->string() : "";
  const bool film = file_ && extensionOf(*file_) == ".mp4";
  const bool numbered = FrameNames::parse(name).has_value();
  if (!frames && (film || numbered)) {
    throw UsageError(fmt::format("-o {} {} and needs --frames A:B", name,
                                 film ? "is a film" : "stands for many files"));
  }
  if (!frames && resume) {
    throw UsageError("--resume continues numbered pictures and needs --frames A:B");
  }
  if (resume && !file_) {
    throw UsageError(
        "--resume continues numbered pictures and needs their name: -o frame_%04d.png");
  }
  if (chunk && (!file_ || film)) {
    throw UsageError(
        "--chunk makes some of a row of pictures and needs their name, -o frame_%04d.png; opaline "
        "film makes a film of them");
  }
  if (film && resume) {
    throw UsageError(
        "--resume continues numbered pictures, -o frame_%04d.png; a film is made in one go");
  }
  if (frames && file_ && !film && !numbered) {
    throw UsageError(
        fmt::format("-o {}: --frames makes many files and needs a name with one %d or %04d, as "
                    "frame_%04d.png, or a film, .mp4",
                    name));
  }
}

Target PictureOptions::target(const std::string& sceneName,
                              const std::optional<FrameRange>& frames) const {
  if (file_) return *file_;
  const std::string ending = isExr() ? ".exr" : ".png";
  if (!frames) return {sceneName + ending, Existing::TakeNextName};
  return {freeRow(sceneName, ending, *frames), Existing::Refuse};
}

}  // namespace opaline::app
