#pragma once

#include <optional>
#include <vector>

#include "paper/atlas/chart_mesh.h"

namespace opaline::atlas {

/// A first map of a disc to the plane in which no triangle is mirrored: the projection along the
/// mean normal if that serves, else the least-squares conformal map, else Tutte's.
std::optional<std::vector<Point2>> initialMap(const ChartMesh& mesh);

double signedArea(const Point2& a, const Point2& b, const Point2& c);

}  // namespace opaline::atlas
