#pragma once

#include <string_view>

#include "opaline/options/picture.h"

namespace opaline::app::viewer {

/// A control for an option of the picture, limited to what the table allows. True if the option
/// changed.
bool drawOption(const char* name, RenderOptions& options, std::string_view key, const char* about);

}  // namespace opaline::app::viewer
