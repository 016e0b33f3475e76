#pragma once

#include <cstddef>
#include <cstdint>
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

/// Of a power of the size that goes through two costs.
double exponent(double small, double large, double factor);

}  // namespace opaline::bench
