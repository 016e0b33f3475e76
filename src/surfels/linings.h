#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/rest_surface.h"
#include "surfels/subdivision.h"
#include "surfels/vector.h"

namespace opaline::surfels {

/// What a part of an object is to what lies in it, or to that in which it lies.
enum class Substance : std::uint8_t {
  Medium,  ///< light diffuses in it
  Solid,   ///< light ends at its surface
  Sheet,   ///< so it does, but there is nothing within
  Other,   ///< lies in nothing, nor does anything in it
};

/// Where the light in bodies ends at solids that lie in them, or reach into them: a bone, a wick, a
/// table in which a body stands. Such a surface, turned round, is a part of the body's, its lining.
/// Only the rest pose decides what lies where.
class Linings {
 public:
  /// None.
  Linings() = default;
  /// One substance a triangle. What touches without reaching in has no part in it.
  Linings(const core::RestSurface& surface, std::span<const Substance> substanceOfTriangle);

  bool any() const { return !pieces_.empty(); }

  /// That surface and behind it the triangles of linings, each of the object whose light ends
  /// there.
  core::RestSurface lined(const core::RestSurface& surface) const;
  /// The first of these. Of each, the solid's triangle.
  std::uint32_t firstTriangle() const { return firstTriangle_; }
  const std::vector<std::uint32_t>& triangleOfSolid() const { return triangleOfSolid_; }
  /// Of these triangles what lies inside, about as fine as the smallest clusters of the body.
  const std::vector<Piece>& pieces() const { return pieces_; }

  /// Whether a part of a body's surface lies in one of these solids, so that it has no light. By a
  /// place on it and the unit normal there.
  bool isCovered(std::uint32_t object, const Vector& placeMm, const Vector& normal) const;

  /// Objects that lie for the greater part in a body, but are sheets: light goes through them.
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
