#pragma once

#include <cstdint>
#include <vector>

#include "opaline/scene.h"

namespace opaline::scene {

/// The body of each object, numbered in the order of their first objects. Translucent objects whose
/// borders coincide at rest are one body, whose surface has several materials: light passes through
/// it as a whole. Every other object is a body of its own.
std::vector<std::uint32_t> bodyOfObjects(const Scene& scene);

/// Appends a mesh's surface to others.
void append(const Mesh& mesh, std::vector<Vec3>& positionsMm, std::vector<Triangle>& triangles);

/// The surface of each body: its objects' positions and triangles, one after the other.
std::vector<Mesh> meshesOfBodies(const Scene& scene,
                                 const std::vector<std::uint32_t>& bodyOfObject);

/// Per object and triangle, whether the connected part of the body around it has an inside; see
/// trianglesWithInside().
std::vector<std::vector<bool>> insideOfObjects(const Scene& scene,
                                               const std::vector<std::uint32_t>& bodyOfObject);

}  // namespace opaline::scene
