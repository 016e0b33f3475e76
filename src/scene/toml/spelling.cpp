#include "scene/toml/spelling.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <vector>

#include "opaline/error.h"
#include "scene/text.h"

namespace opaline::scene::toml_text {

namespace {

/// Whether the loader, which counts brackets before it parses, sees matching brackets.
bool bracketsMatch(std::string_view value) {
  int open = 0;
  for (const char c : value) {
    if (c == '[' || c == '{') ++open;
    if ((c == ']' || c == '}') && --open < 0) return false;
  }
  return open == 0;
}

bool isBracket(char c) {
  return c == '[' || c == '{' || c == ']' || c == '}';
}

void requireHeld(double value, std::string_view what) {
  if (std::abs(value) <= double{1e30F}) return;  // a little more than 1e30, which it is read as
  throw Error(fmt::format("{} is {}, which a scene file cannot hold", what, value));
}

/// In TOML, -0 is a whole number and so loses its sign.
std::string withSign(const std::string& digits) {
  return digits == "-0" ? "-0.0" : digits;
}

double parsed(const std::string& digits) {
  double value = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return value;
}

template <typename Number>
std::string listOf(std::span<const Number> values, std::string_view what) {
  std::vector<std::string> parts;
  for (const Number value : values) parts.push_back(number(value, what));
  return fmt::format("[{}]", fmt::join(parts, ", "));
}

bool isSame(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

/// The offset that yields `place` when added to the centre; a zero may lose its sign.
std::string offset(float place, float centre, std::string_view what) {
  requireHeld(double{place}, what);
  requireHeld(double{centre}, what);
  const double difference = double{place} - double{centre};
  const auto arrives = [&](const std::string& digits) {
    return static_cast<float>(double{centre} + parsed(digits)) == place;
  };
  std::string digits = fmt::format("{}", static_cast<float>(difference));
  for (int precision = 9; precision <= 17 && !arrives(digits); ++precision) {
    digits = fmt::format("{:.{}g}", difference, precision);
  }
  return withSign(digits);
}

}  // namespace

std::string text(std::string_view value, std::string_view what) {
  if (!isUtf8(value)) {
    throw Error(
        fmt::format("{} '{}' is not UTF-8, which a scene file must be", what, cleanText(value)));
  }
  const bool keepBrackets = bracketsMatch(value);
  std::string quoted = "\"";
  for (const char c : value) {
    if (c == '"' || c == '\\') {
      quoted += {'\\', c};
    } else if (static_cast<unsigned char>(c) < 0x20U || c == 0x7F ||
               (isBracket(c) && !keepBrackets)) {
      quoted += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
    } else {
      quoted += c;
    }
  }
  return quoted + '"';
}

std::string key(std::string_view value, std::string_view what) {
  const bool bare = !value.empty() && std::all_of(value.begin(), value.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_';
  });
  return bare ? std::string(value) : text(value, what);
}

std::string number(float value, std::string_view what) {
  requireHeld(double{value}, what);
  std::string digits = withSign(fmt::format("{}", value));
  // The loader reads a double first, and rounding twice can differ from rounding once.
  if (isSame(static_cast<float>(parsed(digits)), value)) return digits;
  return number(double{value}, what);
}

std::string number(double value, std::string_view what) {
  requireHeld(value, what);
  return withSign(fmt::format("{}", value));
}

std::string list(std::span<const float> values, std::string_view what) {
  return listOf(values, what);
}

std::string list(std::span<const double> values, std::string_view what) {
  return listOf(values, what);
}

std::string offset(const Vec3& place, const Vec3& centre, std::string_view what) {
  return fmt::format("[{}, {}, {}]", offset(place[0], centre[0], what),
                     offset(place[1], centre[1], what), offset(place[2], centre[2], what));
}

}  // namespace opaline::scene::toml_text
