#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "scene/raw_scene.h"

namespace opaline::scene {

/// Moves vertices on open edges that lie within a millionth of the mesh's extent of each other to
/// one place: a round body whose texture begins and ends at a seam is closed, although the program
/// that made it rounded 0 and 2π otherwise. `points`: as sewn() has them. Returns how many were
/// moved.
std::size_t closeSeams(RawMesh& mesh, std::span<const std::uint32_t> points);

}  // namespace opaline::scene
