#pragma once

#include <optional>
#include <vector>

#include "paper/atlas/chart_mesh.h"

namespace opaline::atlas {

/// A chart in the plane, mm, with one place for each vertex of its mesh and the area of the
/// surface.
struct FlatChart {
  std::vector<Point2> places;
  double areaDistortionRms = 0;  ///< of ln(flat area : surface area), area-weighted
  double stretch = 1;            ///< area-weighted mean ratio of the longer to the shorter axis
};

/// Flattens a disc, with or without holes, with free borders: nearly true in area, then in angle.
/// No triangle is mirrored and no border crosses another. Returns nothing where that is not
/// reached.
std::optional<FlatChart> flatten(const ChartMesh& mesh);

}  // namespace opaline::atlas
