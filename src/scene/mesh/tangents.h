#pragma once

#include <array>
#include <vector>

#include "opaline/scene.h"

namespace opaline::scene {

/// The tangents at a triangle's corners. Each is given by how far it goes along the edges from the
/// first corner to the second and to the third. The side tells where the bitangent lies: 1 along
/// normal × tangent, -1 against it.
struct TriangleTangents {
  std::array<Vec2, 3> corners{};
  float side = 1;
};

/// The tangents of each triangle in the rest pose, after Mikkelsen 2008. At a vertex they are the
/// directions in which the first texture coordinate grows, projected on the normal's plane and
/// weighted by the triangles' angles. Only triangles of one handedness are averaged.
std::vector<TriangleTangents> tangentsOf(const Mesh& mesh, std::size_t coordinates);

}  // namespace opaline::scene
