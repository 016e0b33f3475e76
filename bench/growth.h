#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "families.h"

namespace opaline::bench {

/// The cost of one stage in the preparation of a scene.
struct Cost {
  std::string stage;
  double seconds = 0;      ///< summed over all cores, regardless of other load
  double peakBytes = 0;    ///< beyond what was in use before
  double allocations = 0;  ///< a measure of work that is equal on all machines
};

/// Costs of reading a family's file of that size, and of preparing it for a renderer's first frame.
std::vector<Cost> costsOf(const Family& family, std::uint32_t count);

/// The exponent of the power law that fits costs best, by least squares of logarithms. The size
/// grows by `factor` from each cost to the next. Needs at least two costs; 0 where one of them is 0
/// and no fit is possible.
double exponent(std::span<const double> costs, double factor);

}  // namespace opaline::bench
