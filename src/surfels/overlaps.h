#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "core/rest_surface.h"
#include "surfels/box.h"
#include "surfels/vector.h"
#include "surfels/winding.h"

namespace opaline::surfels {

/// Where parts of one body reach into each other or lie in each other: the balls of a snowman, a
/// limb stuck into a trunk. The medium goes on there, so a part's surface within another one does
/// not bound it. Only the rest pose decides what lies where.
class Overlaps {
 public:
  /// No overlaps.
  Overlaps() = default;
  /// Of closed parts with a medium inside; `boundsMedium` says for each triangle whether it belongs
  /// to one.
  Overlaps(const core::RestSurface& surface, const std::vector<bool>& boundsMedium);

  bool any() const { return !bodies_.empty(); }

  /// Whether a place on a triangle, with its unit normal, lies in another part of the body. So do
  /// places where two parts touch.
  bool isWithin(std::uint32_t triangle, const Vector& placeMm, const Vector& normal) const;

 private:
  struct Part {
    std::uint32_t object = 0;
    Box box{};
    std::vector<Box> others{};  ///< of parts that may overlap it
  };
  class Finder;

  std::vector<std::uint32_t> partOfTriangle_;
  std::map<std::uint32_t, Part> parts_;            ///< those with others, by their number
  std::map<std::uint32_t, WindingNumber> bodies_;  ///< with such parts, by their object
};

}  // namespace opaline::surfels
