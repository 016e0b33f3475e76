#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/rest_surface.h"
#include "opaline/types.h"

namespace opaline::surfels {

/// A part of a triangle that stays the same part however the triangle is deformed.
struct Piece {
  std::uint32_t triangle = 0;
  /// For its three corners, the barycentric coordinates of the triangle's second and third corner.
  std::array<std::array<float, 2>, 3> corners{};
  float fraction = 1;  ///< of the triangle's area
};

/// Size of a triangle, mm: the edge of a square whose points have the same rms distance from its
/// middle, sqrt((a² + b² + c²) / 6) for the triangle's edges.
double spacingOfMm(const core::RestSurface& surface, std::uint32_t triangle);

/// A triangle's normal with a length of twice its area, mm².
std::array<double, 3> crossOf(const core::RestSurface& surface, std::uint32_t triangle);

double areaMm2(const core::RestSurface& surface, std::uint32_t triangle);
double areaMm2(const core::RestSurface& surface, const Piece& piece);

Vec3 middleOfMm(const core::RestSurface& surface, const Piece& piece);

/// Bisects the longest edge of every triangle and of its parts until none is larger than its
/// object's spacing, mm (spacingOfMm). Returns nothing if that makes more than `limit` pieces.
std::optional<std::vector<Piece>> subdivide(const core::RestSurface& surface,
                                            std::span<const double> spacingOfObjectMm,
                                            std::size_t limit);

/// The same for one triangle and for those of its pieces that are of use. `isOfUse` gets the
/// corners, mm, of every part on the way, and has to be true for each that contains a part of use.
/// Returns nothing if there are more than `limit` pieces.
std::optional<std::vector<Piece>> subdivideWhere(
    const core::RestSurface& surface, std::uint32_t triangle, double spacingMm, std::size_t limit,
    const std::function<bool(const std::array<std::array<double, 3>, 3>&)>& isOfUse);

}  // namespace opaline::surfels
