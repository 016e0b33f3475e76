#pragma once

#include <string_view>

#include "opaline/options/picture.h"

namespace opaline::app::viewer {

/// A control for an option of the picture, which takes what the table allows. True where it was
/// changed.
bool drawOption(const char* name, RenderOptions& options, std::string_view key, const char* about);

}  // namespace opaline::app::viewer
