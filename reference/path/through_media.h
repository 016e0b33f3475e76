#pragma once

#include <array>
#include <optional>
#include <vector>

#include "reference/geometry.h"
#include "reference/path/random.h"
#include "reference/path/walk.h"

namespace opaline::reference {

/// The ways of light that media do not scatter, against its direction: what is seen through them.
/// Boundaries are smooth, as for the particles of Walk.
class ThroughMedia {
 public:
  /// Both must outlive it.
  ThroughMedia(const Geometry& geometry, const InteriorsByChannel& interiors);

  /// Where such a way ends: outside or, if it has met an opaque body within, there.
  struct Exit {
    SurfacePoint point;
    Vector direction{};  ///< unit
    bool isOpaque = false;
    Colour share{};  ///< of the radiance there that arrives
  };
  /// Goes into a medium at a point of its boundary, in that direction outside. What the boundary
  /// there mirrors is left out. Reflection at other places is decided at random. None where
  /// nothing would arrive.
  std::optional<Exit> from(const SurfacePoint& point, const Vector& direction,
                           Random& random) const;

 private:
  Colour pastLayer(const SurfacePoint& point, double cosine) const;
  Colour left(std::uint32_t body, const Vector& place, const Vector& direction, double distanceMm,
              Random& random) const;

  const Geometry& geometry_;
  const InteriorsByChannel& interiors_;
  std::array<std::vector<double>, 3> densest_;
};

}  // namespace opaline::reference
