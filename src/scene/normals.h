#pragma once

#include <cstddef>
#include <vector>

#include "scene/raw_scene.h"

namespace opaline::scene {

/// Smooth unit normals, the mean of the triangles' weighted by their angles at the vertex
/// (Thürmer and Wüthrich 1998). Requires triangles with area and no unused vertex.
std::vector<Vec3> smoothNormals(const RawMesh& mesh);

/// One unit normal per vertex: given ones are normalised, turned with their triangles (`turned`,
/// per triangle) and replaced where they are zero or not finite, which is counted; missing ones
/// are smooth.
std::size_t finishNormals(RawMesh& mesh, const std::vector<bool>& turned);

}  // namespace opaline::scene
