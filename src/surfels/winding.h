#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/rest_surface.h"
#include "surfels/box.h"
#include "surfels/vector.h"

namespace opaline::surfels {

/// How often a surface winds round a place: 1 inside, 0 outside, and in between near holes. It sums
/// the solid angles of triangles, or from afar uses the vector areas of many (Barill, Dickson,
/// Schmidt, Levin, Jacobson 2018).
class WindingNumber {
 public:
  /// For these triangles of the surface, which it copies.
  WindingNumber(const core::RestSurface& surface, std::span<const std::uint32_t> triangles);

  /// The error is at most .02, except on the surface itself, where the result may be any number.
  double at(const Vector& placeMm) const;
  bool isInside(const Vector& placeMm) const;

  /// The box around the triangles.
  const Box& box() const { return box_; }

 private:
  using Corners = std::array<Vector, 3>;
  struct Node {
    Vector middleMm{};
    Vector vectorAreaMm2{};
    double radiusMm = 0;  ///< no part of the node is further from its middle
    std::uint32_t first = 0;
    std::uint32_t end = 0;   ///< triangles
    std::uint32_t next = 0;  ///< the node after all those below it
  };

  void add(std::uint32_t first, std::uint32_t end);
  Node nodeOf(std::uint32_t first, std::uint32_t end) const;

  std::vector<Corners> triangles_;
  std::vector<Node> nodes_;  ///< depth first
  Box box_;
};

}  // namespace opaline::surfels
