#pragma once

#include <string>
#include <string_view>

namespace opaline::app::viewer {

/// A note of the library in the window's words: what the command line does by an option, the window
/// does by a control, where it has one.
std::string withControlNames(std::string_view note);

}  // namespace opaline::app::viewer
