#pragma once

#include <span>
#include <string>
#include <string_view>

#include "opaline/types.h"

namespace opaline::scene::toml_text {

// Spells values for a .toml file. Numbers are as short as possible while they come back bit by bit.
// All throw Error, naming `what`, for values that such a file cannot hold: text that is not UTF-8,
// and numbers that are not finite or above 1e30.

std::string text(std::string_view value, std::string_view what);

/// Spells a key, without quotes where it needs none.
std::string key(std::string_view value, std::string_view what);

std::string number(float value, std::string_view what);
std::string number(double value, std::string_view what);
std::string list(std::span<const float> values, std::string_view what);
std::string list(std::span<const double> values, std::string_view what);

/// Spells a place that is read back as centre + offset.
std::string offset(const Vec3& place, const Vec3& centre, std::string_view what);

}  // namespace opaline::scene::toml_text
