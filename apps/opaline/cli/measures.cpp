#include "cli/measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace opaline::app {

namespace {

/// 2 for hundreds, -1 for tenths.
int magnitudeOf(double value) {
  return static_cast<int>(std::floor(std::log10(std::abs(value))));
}

double rounded(double value, int decimals) {
  const double scale = std::pow(10, decimals);
  return std::isfinite(scale) && scale > 0 ? std::round(value * scale) / scale : value;
}

/// Without an exponent and without zeros at its end.
std::string plainNumber(double value, int decimals) {
  value = rounded(value, decimals);
  if (value == 0) return "0";
  constexpr int most = 18;
  std::string text = fmt::format("{:.{}f}", value, std::clamp(decimals, 0, most));
  if (decimals <= 0) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace

std::string lengthNumber(double mm, int digits) {
  return coordinateNumber(mm, mm, digits);
}

std::string lengthText(double mm, int digits) {
  return std::isfinite(mm) ? lengthNumber(mm, digits) + " mm" : lengthNumber(mm, digits);
}

std::string coordinateNumber(double mm, double sizeMm, int digits) {
  if (!std::isfinite(mm)) return "infinite";
  return sizeMm == 0 ? "0" : plainNumber(mm, digits - 1 - magnitudeOf(sizeMm));
}

std::string stopsText(double stops) {
  constexpr double hundredth = 100;
  const double value = std::round(stops * hundredth) / hundredth;
  if (value == 0) return "0 stops";
  return fmt::format("{:+.4g} {}", value, std::abs(value) == 1 ? "stop" : "stops");
}

}  // namespace opaline::app
