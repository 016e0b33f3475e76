#include "cli/measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace opaline::app {

namespace {

constexpr std::array<LengthUnit, 5> units{
    {{"nm", 1e-6}, {"\u00b5m", 1e-3}, {"mm", 1}, {"m", 1e3}, {"km", 1e6}}};

// Units up to the millimetre are used from a tenth of them on.
constexpr double leastOfUnit = 0.1;

double rounded(double value, int digits) {
  if (value == 0 || !std::isfinite(value)) return value;
  const double magnitude = std::floor(std::log10(std::abs(value)));
  const double scale = std::pow(10, digits - 1 - magnitude);
  return std::isfinite(scale) && scale > 0 ? std::round(value * scale) / scale : value;
}

}  // namespace

LengthUnit lengthUnitFor(double mm) {
  constexpr std::size_t millimetres = 2;
  const double length = rounded(std::abs(mm), 3);
  if (length == 0 || !std::isfinite(length)) return units[millimetres];
  std::size_t unit = 0;
  while (unit + 1 < units.size()) {
    const LengthUnit& next = units[unit + 1];
    if (length < (unit < millimetres ? leastOfUnit : 1) * next.mm) break;
    ++unit;
  }
  return units[unit];
}

std::string lengthNumber(double mm, const LengthUnit& unit, int digits) {
  if (!std::isfinite(mm)) return "endless";
  const double value = rounded(mm / unit.mm, digits);
  if (value == 0) return "0";
  const double magnitude = std::floor(std::log10(std::abs(value)));
  constexpr int most = 12;
  const int decimals = std::clamp(digits - 1 - static_cast<int>(magnitude), 0, most);
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (decimals == 0) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string lengthText(double mm, int digits) {
  if (!std::isfinite(mm)) return "endless";
  const LengthUnit unit = lengthUnitFor(mm);
  return fmt::format("{} {}", lengthNumber(mm, unit, digits), unit.name);
}

std::string stopsText(double stops) {
  constexpr double hundredth = 100;
  const double value = std::round(stops * hundredth) / hundredth;
  if (value == 0) return "0 stops";
  return fmt::format("{:+.4g} {}", value, std::abs(value) == 1 ? "stop" : "stops");
}

}  // namespace opaline::app
