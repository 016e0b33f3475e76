#include "opaline/options/range.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <limits>

namespace opaline::options {

bool Range::holds(double value) const {
  return std::isfinite(value) && value <= most && (aboveLeast ? value > least : value >= least);
}

float Range::leastFloat() const {
  const auto nearest = static_cast<float>(least);
  const auto exact = static_cast<double>(nearest);
  const bool held = aboveLeast ? exact > least : exact >= least;
  return held ? nearest : std::nextafter(nearest, std::numeric_limits<float>::max());
}

float Range::mostFloat() const {
  const auto nearest = static_cast<float>(most);
  return static_cast<double>(nearest) <= most
             ? nearest
             : std::nextafter(nearest, std::numeric_limits<float>::lowest());
}

std::string numberText(double number) {
  std::string text = fmt::format("{:g}", number);
  if (std::strtod(text.c_str(), nullptr) != number) return fmt::format("{}", number);
  for (const char* const sign : {"e+0", "e-0"})
    if (const std::size_t at = text.find(sign); at != std::string::npos)
      text.replace(at, 3, sign[1] == '-' ? "e-" : "e");
  if (const std::size_t at = text.find("e+"); at != std::string::npos) text.erase(at + 1, 1);
  return text;
}

std::string describe(const Range& range) {
  const std::string unit = *range.unit == '\0' ? "" : fmt::format(" {}", range.unit);
  return range.aboveLeast ? fmt::format("above {} and at most {}{}", numberText(range.least),
                                        numberText(range.most), unit)
                          : fmt::format("from {} to {}{}", numberText(range.least),
                                        numberText(range.most), unit);
}

}  // namespace opaline::options
