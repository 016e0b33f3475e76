#include "cli/values.h"

#include <algorithm>

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

[[noreturn]] void refuse(const Given& given, const std::string& reason) {
  if (!given.whole.empty())
    throw UsageError(fmt::format("{} {}: '{}': {}", given.option, given.whole, given.text, reason));
  throw UsageError(fmt::format("{} {}: {}", given.option, given.text, reason));
}

double numberIn(const Given& given, std::string_view part, const Range& range) {
  const std::optional<double> value = toNumber(part);
  if (!value) refuse(given, fmt::format("'{}' is not a number", part));
  if (!range.holds(*value)) refuse(given, "must be " + options::describe(range));
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

std::optional<std::array<double, 3>> channelsIn(std::string_view text, const Range& range) {
  std::vector<std::string_view> parts = split(text, ',');
  if (parts.size() == 1) parts.resize(3, parts.front());
  if (parts.size() != 3) return {};
  std::array<double, 3> channels{};
  for (std::size_t c = 0; c < 3; ++c) {
    const std::optional<double> value = toNumber(parts[c]);
    if (!value || !range.holds(*value)) return {};
    channels[c] = *value;
  }
  return channels;
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

bool isNumber(std::string_view text) {
  return toNumber(text).has_value();
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

namespace {

std::array<double, 3> channelsOf(const Given& given, const options::Allowed& allowed) {
  const auto channels = channelsIn(given.text, allowed.range);
  if (!channels) refuse(given, options::typedRequirement(allowed, Rgb{}));
  return *channels;
}

}  // namespace

std::array<double, 3> readChannels(const Given& given, const Range& range) {
  return channelsOf(given, {range});
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

std::array<int, 2> readSize(const Given& given, const Range& range) {
  const std::vector<std::string_view> parts = split(given.text, 'x');
  options::Size size{};
  for (std::size_t i = 0; i < size.size() && parts.size() == size.size(); ++i)
    size[i] = toInteger(parts[i]).value_or(0);
  const options::Allowed allowed{range};
  if (!allowed.holds(size)) refuse(given, options::typedRequirement(allowed, size));
  return size;
}

options::Value readValue(const Given& given, const options::Allowed& allowed,
                         const options::Value& like) {
  const bool isNamed = std::find(allowed.choices.begin(), allowed.choices.end(), given.text) !=
                       allowed.choices.end();
  if (isNamed) return given.text;
  const auto read = [&](const auto& kind) -> options::Value {
    using Kind = std::remove_cvref_t<decltype(kind)>;
    if constexpr (std::is_same_v<Kind, int>) {
      const std::optional<int> number = toInteger(given.text);
      if (!number || !allowed.holds(*number))
        refuse(given, options::typedRequirement(allowed, like));
      return *number;
    } else if constexpr (std::is_floating_point_v<Kind>) {
      return static_cast<Kind>(readNumber(given, allowed.range));
    } else if constexpr (std::is_same_v<Kind, options::Size>) {
      return readSize(given, allowed.range);
    } else if constexpr (std::is_same_v<Kind, std::string>) {
      if (!allowed.holds(given.text) && allowed.choices.empty())
        refuse(given, options::typedRequirement(allowed, like));
      if (!allowed.holds(given.text))
        refuseChoice(given, {allowed.choices.begin(), allowed.choices.end()});
      return given.text;
    } else if constexpr (std::is_same_v<Kind, Rgb>) {
      return toFloat(channelsOf(given, allowed));
    } else if constexpr (std::is_same_v<Kind, bool>) {
      return true;
    } else {
      return readChannels(given, allowed.range);
    }
  };
  return std::visit(read, like);
}

void refuseChoice(const Given& given, const std::vector<std::string>& choices) {
  refuse(given, fmt::format("must be {}{}{}", choices.size() == 1 ? "" : "one of ",
                            fmt::join(choices, ", "), suggestion(given.text, choices)));
}

}  // namespace opaline::app
