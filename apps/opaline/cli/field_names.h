#pragma once

#include <string>
#include <string_view>

namespace opaline::app {

/// A sentence of the library, which names a field as its headers do, RenderOptions::bounces, with
/// the option that sets the field instead.
std::string withOptionNames(std::string_view sentence);

}  // namespace opaline::app
