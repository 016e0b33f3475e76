#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/rest_surface.h"
#include "surfels/subdivision.h"
#include "surfels/vector.h"

namespace opaline::surfels {

/// How a part of an object takes part in linings.
enum class Substance : std::uint8_t {
  Medium,  ///< light diffuses in it
  Solid,   ///< light ends at its surface
  Sheet,   ///< light ends at its surface, but it has no inside
  Other,   ///< takes no part
};

/// Surfaces at which light in bodies ends because solids lie in them or reach into them: a bone, a
/// wick, a table that a body stands in. Such a surface, turned round, becomes a part of the body's
/// surface, its lining. Only the rest pose decides what lies where.
class Linings {
 public:
  /// No linings.
  Linings() = default;
  /// There is one substance per triangle. A solid that only touches a body does not line it.
  Linings(const core::RestSurface& surface, std::span<const Substance> substanceOfTriangle);

  bool any() const { return !pieces_.empty(); }

  /// The surface, followed by the triangles of linings, each with the object whose light ends
  /// there.
  core::RestSurface lined(const core::RestSurface& surface) const;
  /// The first of the linings' triangles, and for each the solid's triangle.
  std::uint32_t firstTriangle() const { return firstTriangle_; }
  const std::vector<std::uint32_t>& triangleOfSolid() const { return triangleOfSolid_; }
  /// The pieces of these triangles that lie inside, about as fine as the smallest clusters of the
  /// body.
  const std::vector<Piece>& pieces() const { return pieces_; }

  /// Whether a place on a body's surface, with its unit normal, lies in one of these solids and so
  /// gets no light.
  bool isCovered(std::uint32_t object, const Vector& placeMm, const Vector& normal) const;

  /// Sheets that lie mostly in a body. Light in the body ignores them.
  const std::vector<std::uint32_t>& sheetsInside() const { return sheetsInside_; }

 private:
  class Finder;
  struct Solids;

  std::uint32_t firstTriangle_ = ~0U;
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> objectOfTriangle_;
  std::vector<std::uint32_t> triangleOfSolid_;
  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> sheetsInside_;
  std::shared_ptr<const Solids> solids_;
};

}  // namespace opaline::surfels
