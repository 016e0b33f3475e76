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

}  // namespace

void addNotShown(std::vector<NotShown>& to, std::string_view what, std::string_view name) {
  const auto find = [&] {
    return std::find_if(to.begin(), to.end(), [&](const NotShown& k) { return k.what == what; });
  };
  auto kind = find();
  if (kind == to.end() && to.size() >= mostKinds) {
    what = "other things";
    kind = find();
  }
  if (kind == to.end()) kind = to.insert(to.end(), {std::string(what), 0, {}});
  ++kind->count;
  const std::string clean = cleanText(name, 40);
  const auto& names = kind->names;
  if (clean.empty() || names.size() == mostNames) return;
  if (std::find(names.begin(), names.end(), clean) == names.end()) kind->names.push_back(clean);
}

std::string textOf(const std::vector<NotShown>& kinds) {
  std::string text;
  for (const NotShown& kind : kinds) text += (text.empty() ? "" : ", ") + textOf(kind);
  return text;
}

}  // namespace opaline::scene
