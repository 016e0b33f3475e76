#pragma once

#include <string>

namespace opaline::app {

// Lengths and exposures as people write them, for messages and pictures. Files hold plain numbers.

/// The number of a length without an exponent; infinite where it is not finite.
std::string lengthNumber(double mm, int digits = 3);

/// The same with its unit: 176000 mm, 35.4 mm, 0.05 mm.
std::string lengthText(double mm, int digits = 3);

/// A coordinate in a scene of that size, rounded as a length of the size would be.
std::string coordinateNumber(double mm, double sizeMm, int digits = 4);

/// +1.5 stops, -1 stop, 0 stops.
std::string stopsText(double stops);

}  // namespace opaline::app
