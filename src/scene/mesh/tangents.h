#pragma once

#include <array>
#include <vector>

#include "opaline/scene.h"

namespace opaline::scene {

/// Of a triangle's corners, how far the tangent goes along the edges from the first corner to the
/// second and to the third, and on which side of it the bitangent lies: 1 or -1, of normal ×
/// tangent.
struct TriangleTangents {
  std::array<Vec2, 3> corners{};
  float side = 1;
};

/// One for each triangle, in the rest pose, as Mikkelsen 2008 has them: at a vertex the directions
/// in which the first texture coordinate grows, projected on the plane of the normal and weighed by
/// the angles of the triangles that agree in handedness.
std::vector<TriangleTangents> tangentsOf(const Mesh& mesh, std::size_t coordinates);

}  // namespace opaline::scene
