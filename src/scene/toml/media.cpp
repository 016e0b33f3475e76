#include "scene/toml/media.h"

#include <fmt/format.h>

#include "opaline/media.h"
#include "opaline/scene_file.h"
#include "scene/formats.h"
#include "scene/text.h"
#include "scene/toml/keys.h"
#include "scene/toml/parse.h"

namespace opaline::scene {

Media readMedia(const TomlTable& root) {
  Media media;
  const auto tables = root.table("media");
  if (!tables) return media;
  for (const auto& [name, table] : tables->subtables()) {
    table.requireKeys(keys::medium);
    Medium medium;
    const options::Chosen<Medium> chosen = chosenIn<Medium>(table);
    if (const auto measured = table.text("measured")) {
      const auto known = findMedium(*measured);
      if (!known) table.fail("measured", "names no medium; `opaline media` lists them");
      medium = *known;
    } else if (!chosen.has("sigma_s_per_mm") || !chosen.has("sigma_a_per_mm")) {
      table.fail("", "needs 'measured', or both 'sigma_s_per_mm' and 'sigma_a_per_mm'");
    }
    medium.name = cleanText(name);
    chosen.applyTo(medium);
    media.emplace(name, medium);
  }
  return media;
}

Medium mediumNamed(const TomlTable& table, std::string_view key, const std::string& name,
                   const Media& media) {
  const auto own = media.find(name);
  if (own != media.end()) return own->second;
  const auto known = findMedium(name);
  if (!known) {
    table.fail(key, fmt::format("names '{}', which is neither under [media] nor measured",
                                cleanText(name, 60)));
  }
  return *known;
}

}  // namespace opaline::scene

namespace opaline {

std::map<std::string, Medium, std::less<>> mediaOf(const std::filesystem::path& file) {
  if (scene::lowerExtension(file) != ".toml") return {};
  const toml::table parsed = scene::parseToml(file);
  return scene::readMedia({file, parsed, "the scene"});
}

}  // namespace opaline
