#include "scene/toml/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

#include "scene/text.h"
#include "scene/toml/keys.h"

namespace opaline::scene {

namespace {

std::optional<float> asFloat(std::optional<double> value) {
  return value ? std::optional(static_cast<float>(*value)) : std::nullopt;
}

/// "1024x1024", as it is typed on the command line.
std::optional<std::array<int, 2>> sizeFromText(std::string_view text) {
  std::array<int, 2> edges{};
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, edges[0]);
  if (width.ec != std::errc() || width.ptr == end || *width.ptr != 'x') return std::nullopt;
  const auto height = std::from_chars(width.ptr + 1, end, edges[1]);
  if (height.ec != std::errc() || height.ptr != end) return std::nullopt;
  return edges;
}

void readSize(const TomlTable& table, SceneFileSettings& settings) {
  constexpr const char* hint = "must be \"WIDTHxHEIGHT\" or [WIDTH, HEIGHT], each in [1, 16384]";
  if (!table.has("size")) return;
  std::array<int, 2> edges{};
  if (table.holdsText("size")) {
    edges = sizeFromText(*table.text("size")).value_or(edges);
  } else {
    const auto numbers = table.numbers("size", 2);
    for (std::size_t i = 0; i < 2; ++i) {
      const double edge = (*numbers)[i];
      if (std::abs(edge) <= 1e6 && edge == std::floor(edge)) edges[i] = static_cast<int>(edge);
    }
  }
  for (const int edge : edges) {
    if (edge < 1 || edge > 16384) table.fail("size", hint);
  }
  settings.width = edges[0];
  settings.height = edges[1];
}

}  // namespace

SceneFileSettings readSettings(const TomlTable& root) {
  constexpr keys::Keys<3> transports{"dipole", "better-dipole", "boundary"};
  constexpr keys::Keys<3> sums{"pattern", "tree", "all"};
  constexpr keys::Keys<3> sites{"auto", "vertex", "fragment"};
  constexpr keys::Keys<2> tones{"neutral", "none"};
  SceneFileSettings settings;
  const auto table = root.table("render");
  if (!table) return settings;
  table->requireKeys(keys::render);
  readSize(*table, settings);
  settings.transport = table->choice("transport", transports);
  settings.sum = table->choice("sum", sums);
  settings.site = table->choice("site", sites);
  settings.tolerance = asFloat(table->number("tolerance", 1e-4, 1));
  settings.maxSources = table->integer("max_sources", 1024, 1 << 22);
  settings.bounces = table->integer("bounces", 0, 8);
  settings.boundarySurfels = table->integer("boundary_surfels", 64, 1 << 18);
  settings.nearRings = table->integer("near_rings", 0, 15);
  settings.nearSpacing = asFloat(table->number("near_spacing", 1e-3, 100));
  settings.farDistance = asFloat(table->number("far_distance", 1e-3, 1000));
  settings.dsmSize = table->integer("dsm_size", 64, 4096);
  settings.shadowSize = table->integer("shadow_size", 64, 8192);
  settings.specular = table->flag("specular");
  settings.roughness = asFloat(table->number("roughness", 0.05, 1));
  settings.antialias = table->integer("antialias", 1, 8);
  if (settings.antialias && (*settings.antialias & (*settings.antialias - 1)) != 0) {
    table->fail("antialias", "must be 1, 2, 4 or 8");
  }
  settings.exposureStops = asFloat(table->number("exposure", -32, 32));
  settings.tone = table->choice("tone", tones);
  settings.background = table->color("background");
  if (settings.background && std::ranges::max(*settings.background) > 1) {
    table->fail("background", "must be in [0, 1]");
  }
  settings.device = table->text("device");
  settings.seconds = table->number("seconds", 0, 1e6);
  settings.clip = table->text("clip");
  return settings;
}

void requireClip(const TomlTable& root, const LoadedScene& loaded) {
  const std::optional<std::string>& wanted = loaded.settings.clip;
  if (!wanted) return;
  std::vector<std::string_view> names{"none"};
  for (const Clip& clip : loaded.scene.clips) names.emplace_back(clip.name);
  if (std::find(names.begin(), names.end(), *wanted) != names.end()) return;
  root.table("render")->fail("clip",
                             loaded.scene.clips.empty()
                                 ? "names a clip, but the model has none"
                                 : fmt::format("names no clip of the model; the nearest is '{}'",
                                               nearest(*wanted, names).value_or("")));
}

}  // namespace opaline::scene
