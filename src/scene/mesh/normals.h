#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "scene/raw_scene.h"
#include "scene/vector_math.h"

namespace opaline::scene {

/// Smooth unit normals: the mean of the triangles' normals, weighted by their angles at the vertex
/// (Thürmer and Wüthrich 1998). +z where no triangle of a vertex has an area.
std::vector<Double3> smoothNormals(std::span<const Double3> positions,
                                   std::span<const Triangle> triangles);
std::vector<Vec3> smoothNormals(const RawMesh& mesh);

/// Gives every vertex one unit normal. Given normals are normalised and turned with their triangles
/// (`turned`, per triangle). Those that are zero or not finite are replaced, and counted; missing
/// ones become smooth. The provenance tells what became of each.
std::size_t finishNormals(RawMesh& mesh, const std::vector<bool>& turned);

}  // namespace opaline::scene
