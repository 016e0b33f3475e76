#include "scene/not_shown.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/text.h"

namespace opaline::scene {

namespace {

constexpr std::size_t mostNames = 4;
constexpr std::size_t mostKinds = 24;

std::string textOf(const NotShown& kind) {
  if (kind.names.empty()) return fmt::format("{} ({})", kind.what, kind.count);
  return fmt::format("{} ({}: {}{})", kind.what, kind.count, fmt::join(kind.names, ", "),
                     kind.names.size() < kind.count ? ", …" : "");
}

/// That kind, or what stands for all that there are too many of.
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

void addNotShown(std::vector<NotShown>& to, const std::vector<NotShown>& more) {
  for (const NotShown& added : more) {
    NotShown& kind = kindOf(to, added.what);
    kind.count += added.count;
    for (const std::string& name : added.names) addName(kind, name);
  }
}

std::string textOf(const std::vector<NotShown>& kinds) {
  std::string text;
  for (const NotShown& kind : kinds) text += (text.empty() ? "" : ", ") + textOf(kind);
  return text;
}

}  // namespace opaline::scene
