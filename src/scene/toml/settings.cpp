#include "scene/toml/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "scene/text.h"

namespace opaline::scene {

namespace {

using options::PictureSettings;

std::string spelled(const options::Field<PictureSettings>& field, const options::Value& value) {
  const bool quoted = std::holds_alternative<std::string>(value);
  return fmt::format("{0} = {2}{1}{2}", field.key, options::textOf(value), quoted ? "\"" : "");
}

}  // namespace

std::optional<options::Unused> unusedIn(options::Chosen<PictureSettings> said) {
  RenderOptions options;
  options::apply(said, options);
  if (!said.has("transport")) options::chooseTransport(options);
  for (const auto& field : options::fieldsOf<PictureSettings>())
    if (const options::Value* value = said.find(field.key); value && field.get({}) == *value)
      said.erase(field.key);
  return options::findUnused(said, options, spelled);
}

SceneFileSettings readSettings(const TomlTable& root, const LogCallback& log) {
  SceneFileSettings settings;
  const auto table = root.table("render");
  if (!table) return settings;
  std::vector<std::string_view> known;
  for (const auto& field : options::fieldsOf<options::NamedSettings>()) known.push_back(field.key);
  std::vector<std::string_view> former;
  for (const auto& field : options::fieldsOf<PictureSettings>()) {
    known.push_back(field.key);
    if (field.formerKey.empty()) continue;
    former.push_back(field.formerKey);
    if (log && table->has(field.formerKey)) {
      log(LogLevel::Note,
          fmt::format("'{}' in [render] is called '{}' now", field.formerKey, field.key));
    }
  }
  table->requireKeys(known, former);
  settings.picture = chosenIn<PictureSettings>(*table);
  if (const auto unused = unusedIn(settings.picture)) {
    const auto& field = options::fieldOf<PictureSettings>(unused->key);
    table->fail(table->has(field.key) ? field.key : field.formerKey, unused->why);
  }
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
                                 : "names no clip of the model" + suggestionOrList(*wanted, names));
}

}  // namespace opaline::scene
