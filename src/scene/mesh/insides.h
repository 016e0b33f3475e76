#pragma once

#include <span>
#include <vector>

#include "opaline/types.h"

namespace opaline::scene {

/// For every triangle whether the connected part of the mesh around it has an inside: it has no
/// open sides, or its holes together are at most a twentieth of its surface.
std::vector<bool> trianglesWithInside(std::span<const Vec3> positions,
                                      std::span<const Triangle> triangles);

}  // namespace opaline::scene
