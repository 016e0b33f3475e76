#include "opaline/options/picture.h"

namespace opaline::options {

template <>
const std::vector<std::string_view>& namesOf<Transport>() {
  static const std::vector<std::string_view> names{"dipole", "better-dipole", "boundary"};
  return names;
}

template <>
const std::vector<std::string_view>& namesOf<Sum>() {
  static const std::vector<std::string_view> names{"pattern", "tree", "all"};
  return names;
}

template <>
const std::vector<std::string_view>& namesOf<Site>() {
  static const std::vector<std::string_view> names{"auto", "vertex", "fragment"};
  return names;
}

template <>
const std::vector<std::string_view>& namesOf<ToneCurve>() {
  static const std::vector<std::string_view> names{"none", "neutral"};
  return names;
}

template <>
const std::vector<std::string_view>& namesOf<Aov>() {
  static const std::vector<std::string_view> names{
      "radiance",   "exitance",       "irradiance", "position", "normal",
      "depth",      "evaluations",    "object",     "surfels",  "dsm-position",
      "dsm-normal", "dsm-irradiance", "dsm-area"};
  return names;
}

namespace {

template <auto... path>
Field<PictureSettings> of(std::string_view key, Allowed allowed, std::string_view help,
                          std::string_view standard = {}) {
  return field<PictureSettings, &PictureSettings::render, path...>(key, std::move(allowed), help,
                                                                   standard);
}

template <auto member>
Field<PictureSettings> ofPattern(std::string_view key, Range range, std::string_view help) {
  return of<&RenderOptions::pattern, member>(key, {range}, help);
}

template <auto member>
Field<PictureSettings> ofTone(std::string_view key, Allowed allowed, std::string_view help,
                              std::string_view standard = {}) {
  return field<PictureSettings, &PictureSettings::tone, member>(key, std::move(allowed), help,
                                                                standard);
}

Field<PictureSettings> size() {
  return {"size",
          {},
          "pixels",
          {},
          {.range = {1, 16384}},
          [](const PictureSettings& settings) -> std::optional<Value> {
            return Size{settings.render.width, settings.render.height};
          },
          [](PictureSettings& settings, const Value& value) {
            const auto& [width, height] = std::get<Size>(value);
            settings.render.width = width;
            settings.render.height = height;
          },
          Size{}};
}

constexpr std::string_view environment = "environment";

Field<PictureSettings> background() {
  return {"background",
          {},
          "linear",
          "none",
          {.range = {0, 1}, .choices = {environment, "none"}},
          [](const PictureSettings& settings) -> std::optional<Value> {
            if (settings.render.environmentBehind) return std::string(environment);
            return valueOf(settings.tone.background);
          },
          [](PictureSettings& settings, const Value& value) {
            const auto* named = std::get_if<std::string>(&value);
            settings.render.environmentBehind = named != nullptr && *named == environment;
            settings.tone.background.reset();
            if (named == nullptr) settings.tone.background = std::get<Rgb>(value);
          },
          Rgb{}};
}

}  // namespace

template <>
const std::vector<Field<PictureSettings>>& fieldsOf() {
  using Options = RenderOptions;
  using Pattern = PatternOptions;
  static const std::vector<Field<PictureSettings>> table{
      size(),
      of<&Options::transport>("transport", {}, "light"),
      of<&Options::sum>("sum", {}, "sources"),
      of<&Options::site>("site", {}, "sums at"),
      of<&Options::tolerance>("tolerance", {{1e-4, 1}}, "error of tree and solver"),
      of<&Options::bounces>("bounces", {{0, Options::maxBounces}},
                            "how often light may enter again"),
      of<&Options::ambientOcclusion>("ambient_occlusion", {},
                                     "what hides the sky darkens it, not its reflection"),
      formerly("boundary_surfels",
               of<&Options::maxClusters>("max_clusters", {{64, 1 << 18}}, "limit on clusters")),
      formerly("max_sources",
               of<&Options::maxSurfels>("max_surfels", {{1024, 1 << 22}}, "limit on surfels")),
      ofPattern<&Pattern::nearRings>("near_rings", {0, 15}, "rings around the middle sample"),
      ofPattern<&Pattern::nearSpacing>("near_spacing", {1e-3, 100, "mean free paths"},
                                       "between samples"),
      ofPattern<&Pattern::farDistance>("far_distance", {1e-3, 1000, "mean free paths"},
                                       "of far ones"),
      of<&Options::dsmSize>("dsm_size", {{64, 4096}}, "edge of the source map, texels"),
      of<&Options::shadowSize>("shadow_size", {{64, 8192}}, "edge of a shadow map, texels"),
      of<&Options::specular>("specular", {}, "reflection on the surface"),
      of<&Options::roughness>("roughness", {{0.05, 1}}, "of that reflection"),
      of<&Options::antialias>("antialias", {.range = {1, 8}, .counts = {1, 2, 4, 8}},
                              "samples a pixel", "4; AOVs 1"),
      ofTone<&ToneOptions::exposureStops>("exposure", {{-32, 32, "stops"}}, "for PNG and films",
                                          "by the light"),
      ofTone<&ToneOptions::curve>("tone", {}, "curve for PNG and films"),
      background(),
      field<PictureSettings, &PictureSettings::time, &SceneTime::seconds>(
          "seconds", {{0, 1e6, "s"}}, "time of clip and deformers"),
  };
  return table;
}

template <>
const std::vector<Field<NamedSettings>>& fieldsOf() {
  static const std::vector<Field<NamedSettings>> table{
      // A scene file may give the number without quotes.
      field<NamedSettings, &NamedSettings::device>("device", {{0, 255}},
                                                   "name or number from opaline info", "the best"),
      field<NamedSettings, &NamedSettings::clip>("clip", {}, "name from opaline info, or none",
                                                 "the first"),
  };
  return table;
}

template <>
const std::vector<Field<RendererOptions>>& fieldsOf() {
  static const std::vector<Field<RendererOptions>> table{
      called("memory limit",
             field<RendererOptions, &RendererOptions::memoryLimit>(
                 "memory_limit", {{64, 1e7, "MB"}}, "of host and device each", "none")),
  };
  return table;
}

void apply(const Chosen<PictureSettings>& chosen, RenderOptions& options) {
  PictureSettings settings{.render = options};
  chosen.applyTo(settings);
  options = settings.render;
}

std::string complaintAbout(const RenderOptions& options) {
  if (std::string complaint = complaintAboutFields(PictureSettings{.render = options});
      !complaint.empty())
    return complaint;
  if (options.treeLevel < 0 || options.treeLevel > 64)
    return "the level of the tree must be a whole number from 0 to 64";
  if (options.transport == Transport::Boundary && options.sum == Sum::Pattern)
    return "boundary transport works with surfels: the pattern needs another transport";
  return {};
}

std::string complaintAbout(const SceneTime& time) {
  if (time.clip < -1) return "the clip must be a whole number of at least -1";
  return complaintAboutFields(PictureSettings{.time = time});
}

}  // namespace opaline::options
