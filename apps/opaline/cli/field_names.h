#pragma once

#include <string>
#include <string_view>

namespace opaline::app {

/// Replaces fields in a sentence of the library, which names them as in RenderOptions::bounces, by
/// the options that set them.
std::string withOptionNames(std::string_view sentence);

}  // namespace opaline::app
