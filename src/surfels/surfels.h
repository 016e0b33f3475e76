#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "surfels/linings.h"
#include "surfels/overlaps.h"
#include "surfels/subdivision.h"
#include "surfels/tree.h"

namespace opaline::surfels {

/// A surface cut into surfels, the sources of scattered light, object after object. It depends on
/// the rest pose alone and does not change when the surface deforms.
struct SurfelDivision {
  /// Each surfel consists of that many consecutive pieces: one, unless the mesh has more triangles
  /// than there may be surfels. Pieces of fraction 0 fill up the last surfel of an object.
  std::uint32_t piecesPerSurfel = 1;
  std::vector<Piece> pieces;
  std::vector<std::uint32_t> firstOfObject;  ///< first surfel; one more entry than there are
                                             ///< objects
  /// The first surfel of an object's lining, which follows its other surfels; without a lining, the
  /// first of the next object. Likewise the root of the lining's tree, which follows that of the
  /// others.
  std::vector<std::uint32_t> firstLiningOfObject;
  std::vector<std::uint32_t> liningRootOfObject;
  std::vector<double> spacingOfObjectMm;  ///< that was reached, without linings, which have their
                                          ///< own
  Tree tree;
  std::vector<std::uint32_t> vertexOrder;  ///< all vertices, neighbours in space together

  std::uint32_t count() const { return firstOfObject.back(); }
};

/// Divides the surface as finely as wanted, by a spacing for each object, mm (spacingOfMm), or as
/// `maxSurfels` allows. Objects that want the fewest surfels get all of them; the rest is shared
/// evenly. The surface contains the linings, whose pieces are not divided further. What lies within
/// overlaps has no surfels.
SurfelDivision makeSurfels(const core::RestSurface& surface,
                           std::span<const double> wantedSpacingMm, std::size_t maxSurfels,
                           const Linings& linings = {}, const Overlaps& overlaps = {});

}  // namespace opaline::surfels
