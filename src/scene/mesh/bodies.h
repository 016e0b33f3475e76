#pragma once

#include <cstdint>
#include <vector>

#include "opaline/scene.h"

namespace opaline::scene {

/// The body that each object is of, numbered in the order of their first objects. Translucent
/// objects whose borders lie upon each other at rest are one body, whose surface has several
/// materials: light goes through it as a whole. Every other object is a body of its own.
std::vector<std::uint32_t> bodyOfObjects(const Scene& scene);

/// Puts a mesh's surface behind others, end to end.
void append(const Mesh& mesh, std::vector<Vec3>& positionsMm, std::vector<Triangle>& triangles);

/// The surface of each of these bodies: positions and triangles of its objects, one after the
/// other.
std::vector<Mesh> meshesOfBodies(const Scene& scene,
                                 const std::vector<std::uint32_t>& bodyOfObject);

/// For every object's triangles whether the part of its body that they are of has an inside; see
/// trianglesWithInside().
std::vector<std::vector<bool>> insideOfObjects(const Scene& scene,
                                               const std::vector<std::uint32_t>& bodyOfObject);

}  // namespace opaline::scene
