#include "cli/picture_options.h"

#include <fmt/format.h>

#include "cli/frame_names.h"
#include "cli/paths.h"
#include "opaline/error.h"
#include "opaline/exposure.h"

namespace opaline::app {

namespace {

const Choices<Aov>& aovs() {
  static const Choices<Aov> table{
      {"radiance", Aov::Radiance},     {"exitance", Aov::Exitance},
      {"irradiance", Aov::Irradiance}, {"position", Aov::Position},
      {"normal", Aov::Normal},         {"depth", Aov::Depth},
      {"object", Aov::Object},         {"evaluations", Aov::Evaluations},
      {"surfels", Aov::Surfels},       {"dsm-position", Aov::DsmPosition},
      {"dsm-normal", Aov::DsmNormal},  {"dsm-irradiance", Aov::DsmIrradiance},
      {"dsm-area", Aov::DsmArea}};
  return table;
}

template <typename T>
void setFrom(T& value, const std::optional<T>& asked) {
  if (asked) value = *asked;
}

template <typename T>
void setFromName(T& value, const std::optional<std::string>& name, const Choices<T>& choices) {
  if (name) value = readChoice(Given{"[render]", *name}, choices);
}

float readFloat(const Given& given, const Range& range) {
  return static_cast<float>(readNumber(given, range));
}

/// The value that --method paper stands for, unless another was asked for beside it.
template <typename T>
T paperValue(const std::optional<T>& asked, T paper, const char* option,
             const Choices<T>& choices) {
  if (asked && *asked != paper) {
    throw UsageError(fmt::format("{} {} contradicts --method paper, which means {}", option,
                                 nameOf(*asked, choices), nameOf(paper, choices)));
  }
  return paper;
}

}  // namespace

const Choices<core::ToneCurve>& toneCurves() {
  static const Choices<core::ToneCurve> table{{"neutral", core::ToneCurve::Neutral},
                                              {"none", core::ToneCurve::None}};
  return table;
}

const Choices<Transport>& transports() {
  static const Choices<Transport> table{{"dipole", Transport::Dipole},
                                        {"better-dipole", Transport::BetterDipole},
                                        {"boundary", Transport::Boundary}};
  return table;
}

const Choices<Transport>& halfSpaceTransports() {
  static const Choices<Transport> table{{"dipole", Transport::Dipole},
                                        {"better-dipole", Transport::BetterDipole}};
  return table;
}

const Choices<Sum>& sums() {
  static const Choices<Sum> table{
      {"pattern", Sum::Pattern}, {"tree", Sum::Tree}, {"all", Sum::All}};
  return table;
}

const Choices<Site>& sites() {
  static const Choices<Site> table{
      {"auto", Site::Auto}, {"vertex", Site::Vertex}, {"fragment", Site::Fragment}};
  return table;
}

RenderOptions optionsOf(const scene::SceneFileSettings& settings) {
  RenderOptions options;
  setFrom(options.width, settings.width);
  setFrom(options.height, settings.height);
  setFromName(options.transport, settings.transport, transports());
  setFromName(options.sum, settings.sum, sums());
  setFromName(options.site, settings.site, sites());
  setFrom(options.tolerance, settings.tolerance);
  setFrom(options.maxSources, settings.maxSources);
  setFrom(options.bounces, settings.bounces);
  setFrom(options.boundarySurfels, settings.boundarySurfels);
  setFrom(options.pattern.nearRings, settings.nearRings);
  setFrom(options.pattern.nearSpacing, settings.nearSpacing);
  setFrom(options.pattern.farDistance, settings.farDistance);
  setFrom(options.dsmSize, settings.dsmSize);
  setFrom(options.shadowSize, settings.shadowSize);
  setFrom(options.specular, settings.specular);
  setFrom(options.roughness, settings.roughness);
  setFrom(options.antialias, settings.antialias);
  return options;
}

scene::SceneFileSettings settingsOf(const RenderOptions& options, const core::ToneOptions& tone,
                                    const Scene& scene) {
  scene::SceneFileSettings settings;
  settings.width = options.width;
  settings.height = options.height;
  settings.transport = nameOf(options.transport, transports());
  settings.sum = nameOf(options.sum, sums());
  settings.site = nameOf(options.site, sites());
  settings.tolerance = options.tolerance;
  settings.maxSources = options.maxSources;
  settings.bounces = options.bounces;
  settings.boundarySurfels = options.boundarySurfels;
  settings.nearRings = options.pattern.nearRings;
  settings.nearSpacing = options.pattern.nearSpacing;
  settings.farDistance = options.pattern.farDistance;
  settings.dsmSize = options.dsmSize;
  settings.shadowSize = options.shadowSize;
  settings.specular = options.specular;
  settings.roughness = options.roughness;
  settings.antialias = options.antialias;
  settings.exposureStops = tone.exposureStops;
  settings.tone = nameOf(tone.curve, toneCurves());
  settings.background = tone.background;
  settings.seconds = options.seconds;
  if (options.clip < 0) {
    settings.clip = "none";
  } else if (const auto clip = static_cast<std::size_t>(options.clip); clip < scene.clips.size()) {
    settings.clip = scene.clips[clip].name;
  }
  return settings;
}

core::ToneOptions toneOf(const scene::SceneFileSettings& settings, const Scene& scene) {
  core::ToneOptions tone;
  tone.exposureStops =
      settings.exposureStops ? *settings.exposureStops : automaticExposureStops(scene);
  setFromName(tone.curve, settings.tone, toneCurves());
  tone.background = settings.background;
  return tone;
}

void MethodOptions::addTo(CommandLine& line) {
  const RenderOptions defaults;
  line.value("--transport", "NAME", "boundary, better-dipole or dipole [boundary]",
             [this](const Given& given) { transport_ = readChoice(given, transports()); });
  line.value("--sum", "NAME", "tree, all (every surfel) or pattern [tree]",
             [this](const Given& given) { sum_ = readChoice(given, sums()); });
  line.value("--site", "NAME", "vertex, fragment or auto [auto]",
             [this](const Given& given) { site_ = readChoice(given, sites()); });
  line.value("--method", "paper", "dipole, pattern, fragment", [this](const Given& given) {
    paper_ = readChoice<bool>(given, {{"paper", true}});
  });
  line.value("--tolerance", "X",
             fmt::format("of nodes and solution, relative, 1e-4 to 1 [{}]", defaults.tolerance),
             [this](const Given& given) {
               tolerance_ = readFloat(given, {1e-4, 1});
             });
  line.value("--bounces", "N",
             fmt::format("of light that leaves and enters again, 0 to 8 [{}]", defaults.bounces),
             [this](const Given& given) { bounces_ = readInteger(given, 0, 8); });
  line.value("--boundary-surfels", "N",
             fmt::format("unknowns at most, 64 to 262144 [{}]", defaults.boundarySurfels),
             [this](const Given& given) { boundarySurfels_ = readInteger(given, 64, 1 << 18); });
  line.value("--max-sources", "N",
             fmt::format("surfels at most, 1024 to 4194304 [{}]", defaults.maxSources),
             [this](const Given& given) { maxSources_ = readInteger(given, 1024, 1 << 22); });
  line.value("--near-rings", "N",
             fmt::format("samples around the middle one, 0 to 15 [{}]", defaults.pattern.nearRings),
             [this](const Given& given) { nearRings_ = readInteger(given, 0, 15); });
  line.value("--near-spacing", "X",
             fmt::format("mean free paths [{}], of far ones [{}]", defaults.pattern.nearSpacing,
                         defaults.pattern.farDistance),
             [this](const Given& given) {
               nearSpacing_ = readFloat(given, {1e-3, 100, "mean free paths"});
             });
  line.value("--far-distance", "X", "", [this](const Given& given) {
    farDistance_ = readFloat(given, {1e-3, 1000, "mean free paths"});
  });
  line.value(
      "--dsm-size", "N",
      fmt::format("texels of the map [{}], of shadows [{}]", defaults.dsmSize, defaults.shadowSize),
      [this](const Given& given) { dsmSize_ = readInteger(given, 64, 4096); });
  line.value("--shadow-size", "N", "",
             [this](const Given& given) { shadowSize_ = readInteger(given, 64, 8192); });
}

void MethodOptions::applyTo(RenderOptions& options,
                            const scene::SceneFileSettings& settings) const {
  setFrom(options.sum, sum_);
  // The pattern alone means the paper's.
  if (options.sum == Sum::Pattern && !settings.transport) options.transport = Transport::Dipole;
  setFrom(options.transport, transport_);
  setFrom(options.site, site_);
  if (paper_) {
    options.transport = paperValue(transport_, Transport::Dipole, "--transport", transports());
    options.sum = paperValue(sum_, Sum::Pattern, "--sum", sums());
    options.site = paperValue(site_, Site::Fragment, "--site", sites());
  }
  if (options.sum != Sum::Pattern && (nearRings_ || nearSpacing_ || farDistance_)) {
    throw UsageError(
        "--near-rings, --near-spacing and --far-distance shape the pattern and need --sum pattern");
  }
  if (options.sum != Sum::Tree && tolerance_) {
    throw UsageError("--tolerance is what the tree may be off and needs --sum tree");
  }
  if (options.sum == Sum::Pattern && maxSources_) {
    throw UsageError("--max-sources limits surfels and needs --sum tree or --sum all");
  }
  if (options.transport != Transport::Boundary && (bounces_ || boundarySurfels_)) {
    throw UsageError("--bounces and --boundary-surfels need --transport boundary");
  }
  if (options.transport == Transport::Boundary && options.sum == Sum::Pattern) {
    throw UsageError("--transport boundary works with surfels and needs --sum tree or --sum all");
  }
  setFrom(options.bounces, bounces_);
  setFrom(options.boundarySurfels, boundarySurfels_);
  setFrom(options.tolerance, tolerance_);
  setFrom(options.maxSources, maxSources_);
  setFrom(options.pattern.nearRings, nearRings_);
  setFrom(options.pattern.nearSpacing, nearSpacing_);
  setFrom(options.pattern.farDistance, farDistance_);
  setFrom(options.dsmSize, dsmSize_);
  setFrom(options.shadowSize, shadowSize_);
}

void MethodOptions::requireUse(const RenderOptions& options, Aov aov) const {
  if (aov == Aov::Surfels && options.sum == Sum::Pattern) {
    throw UsageError(
        "--aov surfels shows what --sum tree and --sum all sum over; the pattern has none");
  }
  if (!dsmSize_ || options.sum == Sum::Pattern || showsMap(aov)) return;
  throw UsageError(
      "--dsm-size is of the diffusion source map, which only --sum pattern and --aov irradiance or "
      "dsm-* make");
}

void LookOptions::addTo(CommandLine& line) {
  const RenderOptions defaults;
  line.value("--antialias", "N",
             fmt::format("samples a pixel: 1, 2, 4 or 8 [{}; AOVs 1]", defaults.antialias),
             [this](const Given& given) {
               antialias_ = readChoice<int>(given, {{"1", 1}, {"2", 2}, {"4", 4}, {"8", 8}});
             });
  line.flag("--no-specular", "without the reflection on the surface", noSpecular_);
  line.value("--roughness", "X",
             fmt::format("of that reflection, 0.05 to 1 [{}]", defaults.roughness),
             [this](const Given& given) {
               roughness_ = readFloat(given, {0.05, 1});
             });
  line.value("--exposure", "X", "stops, -32 to 32, not EXR [by the light]",
             [this](const Given& given) {
               exposureStops_ = readFloat(given, {-32, 32, "stops"});
             });
  line.value("--tone", "NAME", "curve: neutral or none, not EXR [neutral]",
             [this](const Given& given) { curve_ = readChoice(given, toneCurves()); });
  line.value("--background", "R,G,B", "linear, 0 to 1, not EXR [transparent]",
             [this](const Given& given) {
               background_ = readColour(given, {0, 1});
             });
}

void LookOptions::applyTo(RenderOptions& options) const {
  if (noSpecular_ && roughness_) {
    throw UsageError("--roughness and --no-specular exclude each other");
  }
  setFrom(options.antialias, antialias_);
  options.specular = options.specular && !noSpecular_;
  setFrom(options.roughness, roughness_);
}

core::ToneOptions LookOptions::tone(const scene::SceneFileSettings& settings,
                                    const Scene& scene) const {
  core::ToneOptions options = toneOf(settings, scene);
  setFrom(options.exposureStops, exposureStops_);
  setFrom(options.curve, curve_);
  if (background_) options.background = background_;
  return options;
}

void PictureOptions::addTo(CommandLine& line, const Kinds& kinds) {
  const RenderOptions defaults;
  line.value("-o,--output", "FILE",
             kinds.films ? ".png, .exr (linear), frame_%04d.png, film.mp4" : ".png, .exr (linear)",
             [this, films = kinds.films](const Given& given) {
               file_ = films ? readOutput(given, {".png", ".exr", ".mp4"})
                             : readOutput(given, {".png", ".exr"});
             });
  line.value("--size", "WxH",
             fmt::format("pixels, each 1 to 16384 [{}x{}]", defaults.width, defaults.height),
             [this](const Given& given) { size_ = readSize(given, 16384); });
  line.value("--aov", "NAME",
             fmt::format("EXR of radiance exitance irradiance position normal depth object{}",
                         kinds.sourceMap ? " evaluations surfels[:N] dsm-*" : ""),
             [this](const Given& given) { takeAov(given); });
  look_.addTo(line);
}

void PictureOptions::takeAov(const Given& given) {
  const std::string withLevel = "surfels:";
  treeLevel_.reset();
  if (given.text.rfind(withLevel, 0) != 0) {
    aov_ = readChoice(given, aovs());
    return;
  }
  aov_ = Aov::Surfels;
  treeLevel_ = readInteger(Given{given.option, given.text.substr(withLevel.size())}, 0, 64);
}

void PictureOptions::applyTo(RenderOptions& options) const {
  const bool picture = aov() == Aov::Radiance;
  if (aov_ && !isExr()) {
    throw UsageError("--aov writes figures, not colours: the name after -o must end in .exr");
  }
  if (isExr() && look_.asksForTone()) {
    throw UsageError(
        "--exposure, --tone and --background belong to PNG pictures and films; an EXR file keeps "
        "linear radiance");
  }
  if (!picture && look_.antialias().value_or(1) != 1) {
    throw UsageError("--antialias belongs to radiance; other AOVs are sampled once a pixel");
  }
  if (size_) {
    options.width = (*size_)[0];
    options.height = (*size_)[1];
  }
  setFrom(options.treeLevel, treeLevel_);
  look_.applyTo(options);
  if (!picture) options.antialias = 1;
}

std::optional<std::string> PictureOptions::noteOnExposure(const scene::SceneFileSettings& settings,
                                                          const core::ToneOptions& tone) const {
  if (isExr() || !look_.exposesByLight(settings) || tone.exposureStops == 0) return std::nullopt;
  return fmt::format(
      "the light asks for an exposure of {:+} stops; --exposure 0 leaves it as it is",
      tone.exposureStops);
}

void PictureOptions::requireNameOfStill() const {
  if (file_ && FrameNames::parse(file_->string())) {
    throw UsageError(fmt::format(
        "-o {}: only one still is made, whose name has no number to fill in", file_->string()));
  }
}

bool PictureOptions::isExr() const {
  return file_ ? extensionOf(*file_) == ".exr" : aov_.has_value();
}

void PictureOptions::requireNameFor(bool frames, bool resume) const {
  const std::string name = file_ ? file_->string() : "";
  const bool film = file_ && extensionOf(*file_) == ".mp4";
  const bool numbered = FrameNames::parse(name).has_value();
  if (!frames && (film || numbered)) {
    throw UsageError(fmt::format("-o {} {} and needs --frames A:B", name,
                                 film ? "is a film" : "stands for many files"));
  }
  if (!frames && resume) {
    throw UsageError("--resume goes on with a row of pictures and needs --frames A:B");
  }
  if (resume && !file_) {
    throw UsageError(
        "--resume goes on with a row of pictures and needs its name: -o frame_%04d.png");
  }
  if (film && resume) {
    throw UsageError(
        "--resume goes on with a row of pictures, -o frame_%04d.png; a film is made in one go");
  }
  if (frames && file_ && !film && !numbered) {
    throw UsageError(
        fmt::format("-o {}: --frames makes many files, whose name needs one %d or %04d for the "
                    "number, as frame_%04d.png, or a film, .mp4",
                    name));
  }
}

core::Target PictureOptions::target(const std::string& sceneName,
                                    const std::optional<FrameRange>& frames) const {
  if (file_) return *file_;
  const std::string ending = isExr() ? ".exr" : ".png";
  if (!frames) return {sceneName + ending, core::Existing::TakeNextName};
  return {freeRow(sceneName, ending, *frames), core::Existing::Refuse};
}

}  // namespace opaline::app
