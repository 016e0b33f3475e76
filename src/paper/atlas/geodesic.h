#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "paper/atlas/atlas.h"

namespace opaline::atlas {

/// A point on a surface.
struct SurfacePoint {
  static constexpr std::uint32_t nowhere = 0xffffffffU;

  std::uint32_t triangle = nowhere;
  std::array<float, 3> barycentric{};  ///< weights of the triangle's corners
  float walkedMm = 0;                  ///< how far the walk came
};

/// Where straight walks over a surface end.
using GeodesicStar = std::array<SurfacePoint, 8>;

/// From every vertex eight straightest geodesics (Polthier and Schmies 1998), 45° apart, each as
/// long as `distanceMm` says for its vertex. The first lies 22.5° from the direction in which the
/// surface rises most along +y. A walk ends early at the surface's border, and nowhere where it
/// cannot start. Vertices that share a position give the same star.
std::vector<GeodesicStar> walkFromVertices(const core::RestSurface& surface,
                                           std::span<const double> distanceMm);

}  // namespace opaline::atlas
