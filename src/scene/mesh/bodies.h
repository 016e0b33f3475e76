#pragma once

#include <cstdint>
#include <vector>

#include "opaline/scene.h"

namespace opaline::scene {

/// The body that each object is of, numbered in the order of their first objects. Translucent
/// objects whose borders lie upon each other at rest are one body, whose surface has several
/// materials: light goes through it as a whole. Every other object is a body of its own.
std::vector<std::uint32_t> bodyOfObjects(const Scene& scene);

/// The surface of each of these bodies: positions and triangles of its objects, one after the
/// other.
std::vector<Mesh> meshesOfBodies(const Scene& scene,
                                 const std::vector<std::uint32_t>& bodyOfObject);

}  // namespace opaline::scene
