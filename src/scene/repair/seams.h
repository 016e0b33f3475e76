#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "scene/raw_scene.h"

namespace opaline::scene {

/// Moves vertices on open edges to one place where they lie within a millionth of the mesh's extent
/// of each other. A round body whose texture begins and ends at a seam is thus closed, although the
/// program that made it rounded 0 and 2π differently. `points` is the result of sewn(). Returns how
/// many vertices were moved.
std::size_t closeSeams(RawMesh& mesh, std::span<const std::uint32_t> points);

}  // namespace opaline::scene
