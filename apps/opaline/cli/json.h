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

/// {r, g, b}; what is infinite becomes null.
Json rgbJson(const std::array<double, 3>& rgb);

/// Name, coefficients and the lengths that follow from them.
Json mediumJson(const Medium& medium);

/// With no more digits than tell the number from its neighbours.
Json shortJson(float value);

Json deviceJson(const DeviceDescription& device);

/// Indented and with a line break at the end; what is not UTF-8 is replaced.
std::string toText(const Json& json);

}  // namespace opaline::app
