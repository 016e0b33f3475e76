#pragma once

#include <span>
#include <string>
#include <string_view>

#include "opaline/types.h"

namespace opaline::scene::toml_text {

// Values as a .toml file spells them. Numbers are as short as they can be and still come back bit
// by bit. All throw Error, naming `what`, for what such a file cannot hold: text that is no UTF-8,
// and numbers that are not finite or above 1e30.

std::string text(std::string_view value, std::string_view what);

/// Without quotes where it needs none.
std::string key(std::string_view value, std::string_view what);

std::string number(float value, std::string_view what);
std::string number(double value, std::string_view what);
std::string list(std::span<const float> values, std::string_view what);
std::string list(std::span<const double> values, std::string_view what);

/// A place, to be read as centre + offset.
std::string offset(const Vec3& place, const Vec3& centre, std::string_view what);

}  // namespace opaline::scene::toml_text
