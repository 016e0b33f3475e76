#pragma once

#include <string>

namespace opaline::app {

// Lengths and exposures as people write them, for messages and pictures. Files hold plain numbers.

struct LengthUnit {
  const char* name = "mm";
  double mm = 1;
};

/// The unit in which a length has the fewest zeros: nm, µm, mm, m or km.
LengthUnit lengthUnitFor(double mm);

/// A length as a number of that unit, without an exponent; "endless" where it is not finite.
std::string lengthNumber(double mm, const LengthUnit& unit, int digits = 3);

/// The same with a suitable unit: 176 m, 35.4 mm, 50 µm.
std::string lengthText(double mm, int digits = 3);

/// +1.5 stops, -1 stop, 0 stops.
std::string stopsText(double stops);

}  // namespace opaline::app
