#include "scene/toml/parse.h"

#include <fmt/format.h>

#include <cstddef>
#include <string_view>
#include <vector>

#include "opaline/error.h"
#include "opaline/file.h"
#include "scene/text.h"

namespace opaline::scene {

namespace {

/// Refuses nesting that toml++ would follow by recursion.
void requireShallow(const std::filesystem::path& file, std::string_view text) {
  constexpr std::size_t deepest = 100;
  std::size_t open = 0;
  std::size_t dots = 0;
  for (const char c : text) {
    if (c == '[' || c == '{') ++open;
    if ((c == ']' || c == '}') && open > 0) --open;
    if (c == '\n') dots = 0;
    if (c == '.') ++dots;
    if (open > deepest || dots > 4 * deepest) {
      throw Error(fmt::format("{}: it is nested too deep", cleanText(file.string(), 1000)));
    }
  }
}

}  // namespace

toml::table parseToml(const std::filesystem::path& file) {
  constexpr std::size_t longestToml = 4U << 20U;
  const std::vector<std::byte> bytes = readFile(file, longestToml);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  requireShallow(file, text);
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    throw Error(fmt::format("{}, line {}: {}", cleanText(file.string(), 1000),
                            error.source().begin.line, cleanText(error.description())));
  }
}

}  // namespace opaline::scene
