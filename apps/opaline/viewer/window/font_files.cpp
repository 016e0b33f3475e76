#include "viewer/window/font_files.h"

#include <fontconfig/fontconfig.h>

#include <memory>
#include <optional>
#include <string_view>

namespace opaline::app::viewer {

namespace {

template <typename T, void (*destroy)(T*)>
struct Destroy {
  void operator()(T* object) const { destroy(object); }
};
using Config = std::unique_ptr<FcConfig, Destroy<FcConfig, FcConfigDestroy>>;
using Pattern = std::unique_ptr<FcPattern, Destroy<FcPattern, FcPatternDestroy>>;
using Characters = std::unique_ptr<FcCharSet, Destroy<FcCharSet, FcCharSetDestroy>>;
using Fonts = std::unique_ptr<FcFontSet, Destroy<FcFontSet, FcFontSetDestroy>>;

const FcChar8* bytes(const char* text) {
  return reinterpret_cast<const FcChar8*>(text);
}

std::string_view textOf(const FcPattern* font, const char* property) {
  FcChar8* text = nullptr;
  if (FcPatternGetString(font, property, 0, &text) != FcResultMatch) return {};
  return reinterpret_cast<const char*>(text);
}

Pattern patternFor(FcConfig* config, const std::set<char32_t>& characters) {
  Pattern pattern(FcPatternCreate());
  FcPatternAddString(pattern.get(), FC_FAMILY, bytes("sans-serif"));
  FcPatternAddBool(pattern.get(), FC_OUTLINE, FcTrue);
  FcPatternAddBool(pattern.get(), FC_COLOR, FcFalse);
  if (!characters.empty()) {
    const Characters set(FcCharSetCreate());
    for (const char32_t character : characters) FcCharSetAddChar(set.get(), character);
    FcPatternAddCharSet(pattern.get(), FC_CHARSET, set.get());
  }
  FcConfigSubstitute(config, pattern.get(), FcMatchPattern);
  FcDefaultSubstitute(pattern.get());
  return pattern;
}

// None for a kind of font that the window cannot draw.
std::optional<FontFile> fontOf(const FcPattern* font, const std::set<char32_t>& characters) {
  const std::string_view format = textOf(font, FC_FONTFORMAT);
  const std::string_view file = textOf(font, FC_FILE);
  if ((format != "TrueType" && format != "CFF") || file.empty()) return std::nullopt;
  FontFile found{file};
  int index = 0;
  constexpr int faceBits = 0xFFFF;  // higher bits give the instance of a variable font
  if (FcPatternGetInteger(font, FC_INDEX, 0, &index) == FcResultMatch) {
    found.index = index & faceBits;
  }
  FcCharSet* has = nullptr;
  if (FcPatternGetCharSet(font, FC_CHARSET, 0, &has) != FcResultMatch) return found;
  for (const char32_t character : characters) {
    if (FcCharSetHasChar(has, character) != FcFalse) found.has.insert(character);
  }
  return found;
}

Fonts bestFirst(FcConfig* config, const std::set<char32_t>& characters) {
  const Pattern pattern = patternFor(config, characters);
  FcResult result = FcResultNoMatch;
  return Fonts(FcFontSort(config, pattern.get(), FcFalse, nullptr, &result));
}

}  // namespace

std::vector<FontFile> fontsFor(const std::set<char32_t>& characters) {
  std::vector<FontFile> fonts;
  const Config config(FcInitLoadConfigAndFonts());
  if (!config) return fonts;
  std::set<char32_t> missing = characters;
  const auto addFrom = [&](const Fonts& list, std::size_t most) {
    for (int i = 0; list && i < list->nfont && fonts.size() < most; ++i) {
      std::optional<FontFile> font = fontOf(list->fonts[i], missing);
      if (!font || (!fonts.empty() && font->has.empty())) continue;
      for (const char32_t character : font->has) missing.erase(character);
      fonts.push_back(std::move(*font));
    }
  };
  // First the font that the desktop uses for Latin.
  addFrom(bestFirst(config.get(), {U'a', U'z'}), 1);
  constexpr std::size_t mostFonts = 12;
  if (!fonts.empty() && !missing.empty()) addFrom(bestFirst(config.get(), missing), mostFonts);
  return fonts;
}

}  // namespace opaline::app::viewer
