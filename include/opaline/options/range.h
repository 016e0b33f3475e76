#pragma once

#include <string>

#include "opaline/export.h"

namespace opaline::options {

/// A range of numbers. It includes its ends, but not `least` if `aboveLeast` is set.
struct OPALINE_API Range {
  double least;
  double most;
  const char* unit = "";    ///< written after the numbers: "mm", "degrees"
  bool aboveLeast = false;  ///< `least` itself is not allowed

  bool holds(double value) const;  ///< false for numbers that are not finite
  float leastFloat() const;        ///< the smallest float in the range
  float mostFloat() const;         ///< the largest float in the range
};

/// The number, as short as possible: "0.05", "4194304", "1e6".
OPALINE_API std::string numberText(double number);

/// The range in words: "from 0 to 8", "above 0 and at most 100 mean free paths".
OPALINE_API std::string describe(const Range& range);

}  // namespace opaline::options
