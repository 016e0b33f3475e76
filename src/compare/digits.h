#pragma once

#include <string_view>

#include "compare/color_map.h"
#include "opaline/image_file.h"

namespace opaline::compare {

constexpr int glyphWidth = 5;
constexpr int glyphHeight = 7;
constexpr int glyphAdvance = glyphWidth + 1;

/// Writes digits, points and percent signs, each dot a square of `scale` pixels, from an
/// upper left corner. Parts outside the picture are left out; other characters are blank.
void drawNumber(Image8& picture, int x, int y, int scale, std::string_view text, Rgb8 color);

/// Fills a rectangle, clipped to the picture.
void fillRectangle(Image8& picture, int x, int y, int width, int height, Rgb8 color);

}  // namespace opaline::compare
