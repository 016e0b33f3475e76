#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/rest_surface.h"
#include "surfels/box.h"
#include "surfels/vector.h"

namespace opaline::surfels {

/// How often a closed surface goes round a place: 1 inside and 0 outside, in between near holes. By
/// the solid angles of its triangles, and from afar of the vector areas of many (Barill, Dickson,
/// Schmidt, Levin, Jacobson 2018).
class WindingNumber {
 public:
  /// Of those triangles of the surface, which it copies.
  WindingNumber(const core::RestSurface& surface, std::span<const std::uint32_t> triangles);

  /// Within .02 but on the surface itself, where it may be any number.
  double at(const Vector& placeMm) const;
  bool isInside(const Vector& placeMm) const;

  /// Around the triangles.
  const Box& box() const { return box_; }

 private:
  using Corners = std::array<Vector, 3>;
  struct Node {
    Vector middleMm{};
    Vector vectorAreaMm2{};
    double radiusMm = 0;  ///< nothing of it lies further from the middle
    std::uint32_t first = 0;
    std::uint32_t end = 0;   ///< triangles
    std::uint32_t next = 0;  ///< the node after all that are below it
  };

  void add(std::uint32_t first, std::uint32_t end);
  Node nodeOf(std::uint32_t first, std::uint32_t end) const;

  std::vector<Corners> triangles_;
  std::vector<Node> nodes_;  ///< depth first
  Box box_;
};

}  // namespace opaline::surfels
