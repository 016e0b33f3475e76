#include "viewer/window/glyphs.h"

#include <cstddef>
#include <cstdint>

namespace opaline::app::viewer::glyphs {

namespace {

// The fonts are always loaded up to this character.
constexpr char32_t lastOfLatin = 0xFF;
// More than any window shows, and few enough for a texture.
constexpr std::size_t most = 4000;

std::set<char32_t> all;
bool news = false;

struct Character {
  char32_t code = 0;  // 0: none
  std::size_t bytes = 1;
};

// The first character; code 0 where the bytes are not UTF-8.
Character firstOf(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || bytes > text.size()) return {};
  char32_t code = lead & (0xFFU >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xC0U) != 0x80) return {};
    code = code << 6U | (byte(i) & 0x3FU);
  }
  return {code, bytes};
}

}  // namespace

void want(std::string_view utf8) {
  while (!utf8.empty()) {
    const Character first = firstOf(utf8);
    utf8.remove_prefix(first.bytes);
    if (first.code <= lastOfLatin || all.size() >= most) continue;
    news = all.insert(first.code).second || news;
  }
}

bool takeNews() {
  const bool were = news;
  news = false;
  return were;
}

const std::set<char32_t>& wanted() {
  return all;
}

}  // namespace opaline::app::viewer::glyphs
