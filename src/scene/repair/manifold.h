#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "scene/raw_scene.h"

namespace opaline::scene {

/// Cuts edges with more than two triangles, and edges whose two triangles cannot agree: the
/// surfaces that meet there get their own vertices at the same positions. `points` tells which
/// vertices are one point of the surface. Returns how many edges were cut.
std::size_t cutNonManifoldEdges(RawMesh& mesh, std::span<const std::uint32_t> points);

}  // namespace opaline::scene
