#pragma once

#include <vector>

#include "surfels/subdivision.h"
#include "surfels/surfels.h"

namespace opaline::surfels {

/// How thick the body is under each surfel in the rest pose, mm: from the middle of its first piece
/// along the facet's normal, inwards, to the first surface of the same object; infinite if there is
/// none. Surfels of a leaf share the value of its first. The work of a ray is bounded, so a surface
/// may be missed among thousands of parts that lie upon each other.
std::vector<double> thicknessMm(const core::RestSurface& surface, const SurfelDivision& surfels);

}  // namespace opaline::surfels
