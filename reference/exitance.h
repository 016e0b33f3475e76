#pragma once

#include "reference/vector.h"

namespace opaline::reference {

/// Exitance B at a point, and how far it may be off.
struct Exitance {
  Colour value{};
  Colour error{};  ///< absolute
};

}  // namespace opaline::reference
