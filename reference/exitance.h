#pragma once

#include "reference/vector.h"

namespace opaline::reference {

/// Exitance B at a point, and its error.
struct Exitance {
  Colour value{};
  Colour error{};  ///< absolute
};

}  // namespace opaline::reference
