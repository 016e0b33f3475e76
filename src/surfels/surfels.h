#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "surfels/linings.h"
#include "surfels/subdivision.h"
#include "surfels/tree.h"

namespace opaline::surfels {

/// A surface cut into surfels, the sources of scattered light, object after object. Only the rest
/// pose decides how; nothing of it changes when the surface deforms.
struct SurfelDivision {
  /// Each surfel is so many pieces that follow each other: one, unless the mesh has more triangles
  /// than there may be surfels. Pieces of fraction 0 fill the last surfel of an object.
  std::uint32_t piecesPerSurfel = 1;
  std::vector<Piece> pieces;
  std::vector<std::uint32_t> firstOfObject;  ///< surfel; one more than there are objects
  /// Surfel, behind the others of an object; where it has none, the first of the next object. The
  /// node where their tree begins, beside that of the others, likewise.
  std::vector<std::uint32_t> firstLiningOfObject;
  std::vector<std::uint32_t> liningRootOfObject;
  std::vector<double> spacingOfObjectMm;  ///< that was reached; of linings, as these have it
  Tree tree;
  std::vector<std::uint32_t> vertexOrder;  ///< all vertices, neighbours in space together

  std::uint32_t count() const { return firstOfObject.back(); }
};

/// Divides the surface as finely as wanted, a spacing for each object, mm (spacingOfMm), or as
/// `maxSurfels` allows: objects that want fewest get all, what is left is shared evenly. Linings
/// come as they are, with the surface that has them.
SurfelDivision makeSurfels(const core::RestSurface& surface,
                           std::span<const double> wantedSpacingMm, std::size_t maxSurfels,
                           const Linings& linings = {});

}  // namespace opaline::surfels
