#pragma once

#include <vector>

#include "environment/sky_irradiance.h"
#include "reference/vector.h"

namespace opaline::reference {

/// SkyIrradiance tabulated by normal, since an integral needs it a million times. Interpolation
/// adds an error of about 1e-4.
class SkyTable {
 public:
  explicit SkyTable(const SkyIrradiance& irradiance);

  Colour at(const Vector& normal) const;

 private:
  const Colour& node(int row, int column) const;

  std::vector<Colour> nodes_;  ///< by latitude and longitude, row by row; the poles are rows
};

}  // namespace opaline::reference
