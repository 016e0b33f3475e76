#pragma once

#include <set>
#include <string_view>

/// Which characters the window's texts need beyond the Latin ones that are always there: names of
/// files, objects and media may be in any script.
namespace opaline::app::viewer::glyphs {

/// A text will be shown from the next frame on. Cheap where its characters are known.
void want(std::string_view utf8);

/// Whether characters were wanted since the last call that had not been wanted before.
bool takeNews();

/// All that were wanted so far.
const std::set<char32_t>& wanted();

}  // namespace opaline::app::viewer::glyphs
