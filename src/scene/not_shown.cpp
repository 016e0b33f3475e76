#include "scene/not_shown.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/formats.h"
#include "scene/text.h"

namespace opaline::scene {

namespace {

constexpr std::size_t mostNames = 4;
constexpr std::size_t mostKinds = 24;

std::string lineOf(const NotShown& kind) {
  if (kind.names.empty()) return fmt::format("{} ({})", kind.what, kind.count);
  return fmt::format("{} ({}: {}{})", kind.what, kind.count, fmt::join(kind.names, ", "),
                     kind.names.size() < kind.count ? ", …" : "");
}

/// The entry of that kind, or the entry that collects the rest once there are too many kinds.
NotShown& kindOf(std::vector<NotShown>& kinds, std::string_view what) {
  const auto find = [&] {
    return std::find_if(kinds.begin(), kinds.end(),
                        [&](const NotShown& kind) { return kind.what == what; });
  };
  auto kind = find();
  if (kind == kinds.end() && kinds.size() >= mostKinds) {
    what = "other things";
    kind = find();
  }
  if (kind == kinds.end()) kind = kinds.insert(kinds.end(), {std::string(what), 0, {}});
  return *kind;
}

void addName(NotShown& kind, const std::string& name) {
  std::vector<std::string>& names = kind.names;
  if (name.empty() || names.size() == mostNames) return;
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

}  // namespace

void addNotShown(std::vector<NotShown>& to, std::string_view what, std::string_view name) {
  NotShown& kind = kindOf(to, what);
  ++kind.count;
  addName(kind, cleanText(name, 40));
}

HiddenParts partsOf(const OpaqueMaterial& material) {
  return {.baseColor = material.baseColor != Rgb{1, 1, 1},
          .baseColorTexture = material.baseColorTexture.has_value(),
          .metal = material.metallic > 0,
          .occlusionTexture = material.occlusionTexture.has_value(),
          .emission = material.emission != Rgb{0, 0, 0},
          .alphaMask = material.alphaCutoff > 0};
}

void addNotShown(std::vector<NotShown>& to, const HiddenParts& parts, std::string_view name) {
  const auto add = [&](bool isThere, std::string_view what) {
    if (isThere) addNotShown(to, what, name);
  };
  add(parts.baseColor, "base colours");
  add(parts.baseColorTexture, "base-colour textures");
  add(parts.metal, "metals");
  add(parts.occlusionTexture, "occlusion textures");
  add(parts.emission, "emission");
  add(parts.alphaMask, "alpha masks");
}

void noteReplaced(const std::vector<NotShown>& replaced, const LogCallback& log,
                  std::vector<NotShown>& notShown) {
  if (replaced.empty()) return;
  note(log, fmt::format("not shown where a medium replaces a material: {}", textOf(replaced)));
  addNotShown(notShown, replaced);
}

void addNotShown(std::vector<NotShown>& to, const std::vector<NotShown>& more) {
  for (const NotShown& added : more) {
    NotShown& kind = kindOf(to, added.what);
    kind.count += added.count;
    for (const std::string& name : added.names) addName(kind, name);
  }
}

}  // namespace opaline::scene

namespace opaline {

std::string textOf(const std::vector<NotShown>& kinds) {
  std::string text;
  for (const NotShown& kind : kinds) text += (text.empty() ? "" : ", ") + scene::lineOf(kind);
  return text;
}

}  // namespace opaline
