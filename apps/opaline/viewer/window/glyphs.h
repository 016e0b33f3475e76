#pragma once

#include <set>
#include <string_view>

/// Which characters the window's texts need beyond Latin, which is always loaded. Names of files,
/// objects and media may be in any script.
namespace opaline::app::viewer::glyphs {

/// Announces a text that will be shown from the next frame on. Cheap where its characters are
/// known.
void want(std::string_view utf8);

/// Whether new characters were wanted since the last call.
bool takeNews();

/// All characters wanted so far.
const std::set<char32_t>& wanted();

}  // namespace opaline::app::viewer::glyphs
