#pragma once

#include <vector>

#include "atlas/chart_mesh.h"

namespace opaline::atlas {

/// Whether any two border edges that share no vertex meet. A map that mirrors no triangle and
/// whose borders do not cross is one-to-one.
bool bordersCross(const ChartMesh& mesh, const std::vector<Point2>& places);

}  // namespace opaline::atlas
