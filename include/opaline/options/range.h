#pragma once

#include <string>

#include "opaline/export.h"

namespace opaline::options {

/// What a number may be; the ends belong to it unless `aboveLeast`.
struct OPALINE_API Range {
  double least;
  double most;
  const char* unit = "";    ///< written after the numbers: "mm", "degrees"
  bool aboveLeast = false;  ///< `least` itself is not allowed

  bool holds(double value) const;  ///< false for what is not finite
  float leastFloat() const;        ///< the smallest of its numbers that a float can be
  float mostFloat() const;         ///< and the largest
};

/// As short as it can be: "0.05", "4194304", "1e6".
OPALINE_API std::string numberText(double number);

/// "from 0 to 8", "above 0 and at most 100 mean free paths".
OPALINE_API std::string describe(const Range& range);

}  // namespace opaline::options
