#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/rest_surface.h"
#include "surfels/subdivision.h"
#include "surfels/tree.h"

namespace opaline::surfels {

/// Parts of a surface that do not hang together, though they may belong to one object: the clothes
/// on a body, a label on a box. Where such parts lie upon each other, what one of them gets of the
/// light says nothing about the other.
class Layers {
 public:
  explicit Layers(const core::RestSurface& surface);

  /// A number for each item, so that parts which come closer than about `closeMm` and face the same
  /// way there have different ones, from 0 to mostLayers - 1. Parts of less than a few closeMm²,
  /// and those for which no number is left, have 0. The items are of one object.
  std::vector<std::uint8_t> ofItems(std::span<const Piece> pieces, std::span<const TreeItem> items,
                                    double closeMm) const;

  static constexpr std::uint8_t mostLayers = 8;

 private:
  std::uint32_t partOf(const Piece& piece) const { return partOfTriangle_[piece.triangle]; }
  /// Parts of which the items have at least that area.
  std::vector<std::uint32_t> largestFirst(std::span<const Piece> pieces,
                                          std::span<const TreeItem> items, double leastMm2) const;

  const core::RestSurface& surface_;
  std::vector<std::uint32_t> partOfTriangle_;
};

}  // namespace opaline::surfels
