#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "scene/raw_scene.h"

namespace opaline::scene {

/// Cuts edges with more than two triangles, and edges whose two triangles cannot agree, by giving
/// the surfaces that meet there vertices of their own; positions stay. `points` names the vertices
/// that are one point of the surface. Returns how many edges were cut.
std::size_t cutNonManifoldEdges(RawMesh& mesh, std::span<const std::uint32_t> points);

}  // namespace opaline::scene
