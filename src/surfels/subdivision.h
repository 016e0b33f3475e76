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
  /// Of its three corners, barycentric coordinates of the triangle's second and third corner.
  std::array<std::array<float, 2>, 3> corners{};
  float fraction = 1;  ///< of the triangle's area
};

/// Size of a triangle as the edge of a square whose points lie as far from its middle, mm, root
/// mean square: sqrt((a² + b² + c²) / 6) of its edges.
double spacingOfMm(const core::RestSurface& surface, std::uint32_t triangle);

/// A triangle's normal, as long as twice its area, mm².
std::array<double, 3> crossOf(const core::RestSurface& surface, std::uint32_t triangle);

double areaMm2(const core::RestSurface& surface, std::uint32_t triangle);

Vec3 middleOfMm(const core::RestSurface& surface, const Piece& piece);

/// Bisects the longest edge of every triangle and of its parts until none is larger than its
/// object's spacing, mm (spacingOfMm). Nothing when that makes more than `limit` pieces.
std::optional<std::vector<Piece>> subdivide(const core::RestSurface& surface,
                                            std::span<const double> spacingOfObjectMm,
                                            std::size_t limit);

/// The same of one triangle, of those pieces that are of use. `isOfUse` is asked of the corners,
/// mm, of every part on the way to them, and holds of each that has a part of use. Nothing when
/// there are more than `limit`.
std::optional<std::vector<Piece>> subdivideWhere(
    const core::RestSurface& surface, std::uint32_t triangle, double spacingMm, std::size_t limit,
    const std::function<bool(const std::array<std::array<double, 3>, 3>&)>& isOfUse);

}  // namespace opaline::surfels
