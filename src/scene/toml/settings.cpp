#include "scene/toml/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "scene/text.h"

namespace opaline::scene {

SceneFileSettings readSettings(const TomlTable& root, const LogCallback& log) {
  SceneFileSettings settings;
  const auto table = root.table("render");
  if (!table) return settings;
  std::vector<std::string_view> known;
  for (const auto& field : options::fieldsOf<options::NamedSettings>()) known.push_back(field.key);
  std::vector<std::string_view> former;
  for (const auto& field : options::fieldsOf<options::PictureSettings>()) {
    known.push_back(field.key);
    if (field.formerKey.empty()) continue;
    former.push_back(field.formerKey);
    if (log && table->has(field.formerKey)) {
      log(LogLevel::Note,
          fmt::format("'{}' in [render] is called '{}' now", field.formerKey, field.key));
    }
  }
  table->requireKeys(known, former);
  settings.picture = chosenIn<options::PictureSettings>(*table);
  chosenIn<options::NamedSettings>(*table).applyTo(settings.named);
  return settings;
}

void requireClip(const TomlTable& root, const LoadedScene& loaded) {
  const std::optional<std::string>& wanted = loaded.settings.named.clip;
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
