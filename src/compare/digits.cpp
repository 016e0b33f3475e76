#include "compare/digits.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace opaline::compare {

namespace {

/// Seven rows of five dots.
struct Glyph {
  char character;
  std::array<std::string_view, glyphHeight> rows;
};

constexpr std::array<Glyph, 12> glyphs{{
    {'0', {".###.", "#...#", "#..##", "#.#.#", "##..#", "#...#", ".###."}},
    {'1', {"..#..", ".##..", "..#..", "..#..", "..#..", "..#..", ".###."}},
    {'2', {".###.", "#...#", "....#", "...#.", "..#..", ".#...", "#####"}},
    {'3', {".###.", "#...#", "....#", "..##.", "....#", "#...#", ".###."}},
    {'4', {"...#.", "..##.", ".#.#.", "#..#.", "#####", "...#.", "...#."}},
    {'5', {"#####", "#....", "####.", "....#", "....#", "#...#", ".###."}},
    {'6', {"..##.", ".#...", "#....", "####.", "#...#", "#...#", ".###."}},
    {'7', {"#####", "....#", "...#.", "..#..", ".#...", ".#...", ".#..."}},
    {'8', {".###.", "#...#", "#...#", ".###.", "#...#", "#...#", ".###."}},
    {'9', {".###.", "#...#", "#...#", ".####", "....#", "...#.", ".##.."}},
    {'.', {".....", ".....", ".....", ".....", ".....", ".##..", ".##.."}},
    {'%', {"##..#", "##..#", "...#.", "..#..", ".#...", "#..##", "#..##"}},
}};

}  // namespace

void fillRectangle(Image8& picture, int x, int y, int width, int height, Rgb8 color) {
  const int right = std::min(x + width, picture.width);
  const int bottom = std::min(y + height, picture.height);
  for (int row = std::max(y, 0); row < bottom; ++row) {
    for (int column = std::max(x, 0); column < right; ++column) {
      const std::size_t pixel =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
          static_cast<std::size_t>(column);
      std::copy(color.begin(), color.end(),
                picture.rgba.begin() + static_cast<std::ptrdiff_t>(4 * pixel));
      picture.rgba[4 * pixel + 3] = 255;
    }
  }
}

void drawNumber(Image8& picture, int x, int y, int scale, std::string_view text, Rgb8 color) {
  for (const char character : text) {
    const auto glyph = std::find_if(glyphs.begin(), glyphs.end(), [&](const Glyph& candidate) {
      return candidate.character == character;
    });
    for (int row = 0; glyph != glyphs.end() && row < glyphHeight; ++row) {
      const std::string_view dots = glyph->rows[static_cast<std::size_t>(row)];
      for (int column = 0; column < glyphWidth; ++column) {
        if (dots[static_cast<std::size_t>(column)] != '#') continue;
        fillRectangle(picture, x + column * scale, y + row * scale, scale, scale, color);
      }
    }
    x += glyphAdvance * scale;
  }
}

}  // namespace opaline::compare
