#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

#include "opaline/medium.h"
#include "opaline/renderer.h"

namespace opaline::app {

/// Keeps the order in which fields are set.
using Json = nlohmann::ordered_json;

/// {r, g, b}; infinite values become null.
Json rgbJson(const std::array<double, 3>& rgb);

/// The medium's name, coefficients and the lengths that follow from them.
Json mediumJson(const Medium& medium);

/// A number with no more digits than distinguish it from its neighbours.
Json shortJson(float value);

Json deviceJson(const DeviceDescription& device);

/// Indented text with a final line break; bytes that are not UTF-8 are replaced.
std::string toText(const Json& json);

}  // namespace opaline::app
