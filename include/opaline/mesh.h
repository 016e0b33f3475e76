#pragma once

#include <vector>

#include "opaline/export.h"
#include "opaline/scene.h"

namespace opaline {

/// A mesh of your own: positions, mm, and triangles that are counter-clockwise seen from outside.
/// All stays as it is, so that positions given later fit (Renderer::replacePositions). Normals are
/// smooth: the mean of the triangles', weighted by their angles. Throws UsageError for positions
/// that are not finite or beyond 1e18 mm, and for triangles that name vertices that do not exist.
OPALINE_API Mesh makeMesh(std::vector<Vec3> positionsMm, std::vector<Triangle> triangles);

}  // namespace opaline
