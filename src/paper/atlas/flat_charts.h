#pragma once

#include <vector>

#include "paper/atlas/chart_mesh.h"
#include "paper/atlas/charts.h"
#include "paper/atlas/flatten.h"

namespace opaline::atlas {

/// A chart on the surface and in the plane.
struct SurfaceChart {
  Chart triangles;
  ChartMesh mesh;
  FlatChart flat;
};

/// Flattens charts, divides those that do not lie flat well, and joins neighbours that do so as
/// one.
std::vector<SurfaceChart> flattenCharts(const Topology& topology, std::vector<Chart> charts);

}  // namespace opaline::atlas
