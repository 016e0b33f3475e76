#include "cli/values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <optional>

#include "opaline/error.h"

namespace opaline::app {

namespace {

std::optional<double> toNumber(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || text.empty()) return {};
  return value;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

[[noreturn]] void refuse(const Given& given, const std::string& reason) {
  throw UsageError(fmt::format("{} {}: {}", given.option, given.text, reason));
}

std::string describe(const Range& range) {
  const std::string unit = *range.unit == '\0' ? "" : fmt::format(" {}", range.unit);
  return range.aboveLeast ? fmt::format("above {} and at most {}{}", range.least, range.most, unit)
                          : fmt::format("from {} to {}{}", range.least, range.most, unit);
}

double numberIn(const Given& given, std::string_view part, const Range& range) {
  const std::optional<double> value = toNumber(part);
  if (!value) refuse(given, fmt::format("'{}' is not a number", part));
  const bool inside = std::isfinite(*value) && *value <= range.most &&
                      (range.aboveLeast ? *value > range.least : *value >= range.least);
  if (!inside) refuse(given, fmt::format("{} is not {}", part, describe(range)));
  return *value;
}

std::optional<int> toInteger(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || text.empty()) return {};
  return value;
}

std::array<double, 3> numbersIn(const Given& given, const std::vector<std::string_view>& parts,
                                const Range& range) {
  return {numberIn(given, parts[0], range), numberIn(given, parts[1], range),
          numberIn(given, parts[2], range)};
}

std::array<double, 3> readTriple(const Given& given, const Range& range) {
  const std::vector<std::string_view> parts = split(given.text, ',');
  if (parts.size() != 3) refuse(given, "needs three numbers with commas between them");
  return numbersIn(given, parts, range);
}

std::array<float, 3> toFloat(const std::array<double, 3>& triple) {
  return {static_cast<float>(triple[0]), static_cast<float>(triple[1]),
          static_cast<float>(triple[2])};
}

}  // namespace

double readNumber(const Given& given, const Range& range) {
  return numberIn(given, given.text, range);
}

int readInteger(const Given& given, int least, int most) {
  const std::optional<int> value = toInteger(given.text);
  if (!value || *value < least || *value > most) {
    refuse(given, fmt::format("must be a whole number from {} to {}", least, most));
  }
  return *value;
}

std::array<float, 3> readPlace(const Given& given, const Range& range) {
  return toFloat(readTriple(given, range));
}

std::array<double, 3> readChannels(const Given& given, const Range& range) {
  const std::vector<std::string_view> parts = split(given.text, ',');
  if (parts.size() == 1) {
    const double grey = numberIn(given, parts[0], range);
    return {grey, grey, grey};
  }
  if (parts.size() != 3) {
    refuse(given, "needs three numbers with commas between them, or one for all three");
  }
  return numbersIn(given, parts, range);
}

std::array<float, 3> readColour(const Given& given, const Range& range) {
  return toFloat(readChannels(given, range));
}

std::array<float, 3> readDirection(const Given& given) {
  const std::array<double, 3> v = readTriple(given, {-1e9, 1e9});
  const double length = std::hypot(v[0], v[1], v[2]);
  if (length < 1e-9) refuse(given, "a direction must not be zero");
  return {static_cast<float>(v[0] / length), static_cast<float>(v[1] / length),
          static_cast<float>(v[2] / length)};
}

std::array<int, 2> readSize(const Given& given, int most) {
  const std::vector<std::string_view> parts = split(given.text, 'x');
  const auto width = toInteger(parts[0]);
  const auto height = parts.size() == 2 ? toInteger(parts[1]) : std::nullopt;
  if (!width || !height || *width < 1 || *height < 1 || *width > most || *height > most) {
    refuse(given, fmt::format("must be WIDTHxHEIGHT, each from 1 to {} pixels", most));
  }
  return {*width, *height};
}

void refuseChoice(const Given& given, const std::vector<std::string>& choices) {
  refuse(given, fmt::format("must be one of {}{}", fmt::join(choices, ", "),
                            suggestion(given.text, choices)));
}

}  // namespace opaline::app
