#pragma once

#include <span>
#include <vector>

#include "opaline/types.h"

namespace opaline::scene {

/// For every triangle whether the part of the mesh that it hangs together with has an inside: no
/// open sides, or holes so small that together they are at most a twentieth of its surface.
std::vector<bool> trianglesWithInside(std::span<const Vec3> positions,
                                      std::span<const Triangle> triangles);

}  // namespace opaline::scene
