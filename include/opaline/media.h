#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "opaline/export.h"
#include "opaline/medium.h"

namespace opaline {

/// A row of the table of Jensen, Marschner, Levoy, Hanrahan 2001, Figure 5.
struct MeasuredMedium {
  Medium medium;
  std::array<double, 3> diffuseReflectance;  ///< its last column
};

/// The rows of the table, in its order.
OPALINE_API std::span<const MeasuredMedium> measuredMedia();

/// Media that were made up for their looks and never measured.
OPALINE_API std::span<const Medium> artisticMedia();

/// Finds a medium in either table by its name, in any case.
OPALINE_API std::optional<Medium> findMedium(std::string_view name);

}  // namespace opaline
