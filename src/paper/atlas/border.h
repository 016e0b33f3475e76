#pragma once

#include <vector>

#include "paper/atlas/chart_mesh.h"

namespace opaline::atlas {

/// Whether a map that mirrors no triangle is one-to-one: no two border edges meet except at a
/// vertex they share, and only one loop runs counter-clockwise. The plane is then covered as often
/// as the loops wind around it: once or not at all.
bool isOneToOne(const ChartMesh& mesh, const std::vector<Point2>& places);

}  // namespace opaline::atlas
