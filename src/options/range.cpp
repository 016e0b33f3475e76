#include "options/range.h"

#include <fmt/format.h>

#include <cmath>

namespace opaline::options {

bool Range::holds(double value) const {
  return std::isfinite(value) && value <= most && (aboveLeast ? value > least : value >= least);
}

std::string describe(const Range& range) {
  const std::string unit = *range.unit == '\0' ? "" : fmt::format(" {}", range.unit);
  return range.aboveLeast ? fmt::format("above {} and at most {}{}", range.least, range.most, unit)
                          : fmt::format("from {} to {}{}", range.least, range.most, unit);
}

}  // namespace opaline::options
