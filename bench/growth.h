#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "families.h"

namespace opaline::bench {

/// What a stage of the preparation of a scene took.
struct Cost {
  std::string stage;
  double seconds = 0;      ///< of all cores together, whatever else the machine does
  double peakBytes = 0;    ///< beyond what was taken before
  double allocations = 0;  ///< the same on every machine, as a measure of work
};

/// Reading a family's file of that size, and what a renderer makes of it before its first frame.
std::vector<Cost> costsOf(const Family& family, std::uint32_t count);

/// Of the power of the size that fits costs best, in the square of logarithms, where the size grows
/// by a factor from each to the next. At least two; 0 where one of them is 0, which says nothing.
double exponent(std::span<const double> costs, double factor);

}  // namespace opaline::bench
