#include "viewer/window/glyphs.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "viewer/window/font_files.h"

namespace opaline::app::viewer {
namespace {

TEST(Glyphs, OnlyWhatIsNotLatinIsWantedAndOnlyOnceNews) {
  glyphs::takeNews();
  glyphs::want("bear, M\u00fcnchen");
  EXPECT_FALSE(glyphs::takeNews());
  glyphs::want("\u718a \u043c\u0435\u0434 \U0001d11e");
  EXPECT_TRUE(glyphs::takeNews());
  for (const char32_t character : std::u32string(U"\u718a\u043c\u0435\u0434\U0001d11e")) {
    EXPECT_TRUE(glyphs::wanted().contains(character)) << std::uint32_t{character};
  }
  EXPECT_FALSE(glyphs::wanted().contains(U'b'));
  glyphs::want("\u718a");
  EXPECT_FALSE(glyphs::takeNews());
}

TEST(Glyphs, BytesThatAreNoTextAreSkipped) {
  const std::size_t before = glyphs::wanted().size();
  for (const std::string text :
       {"\xff\xfe", "\xc0\x80", "\xe7\x86", "a\x80z", "\xf8\x88\x80\x80\x80"}) {
    glyphs::want(text);
  }
  EXPECT_EQ(glyphs::wanted().size(), before);
  glyphs::want("\xe7\x86\xe4\xb8\xad");  // half a character, then a whole one
  EXPECT_EQ(glyphs::wanted().size(), before + 1);
  EXPECT_TRUE(glyphs::wanted().contains(0x4e2d));
}

// Which fonts a system has is its own affair: what they say they have, they have.
TEST(Glyphs, FontsAreAskedForWhatIsMissing) {
  const std::vector<FontFile> fonts = fontsFor({0x416, 0x718a, 0xe000});
  std::set<char32_t> found;
  for (const FontFile& font : fonts) {
    EXPECT_TRUE(std::filesystem::is_regular_file(font.file)) << font.file;
    for (const char32_t character : font.has) {
      EXPECT_TRUE(found.insert(character).second) << "twice";
    }
  }
}

}  // namespace
}  // namespace opaline::app::viewer
