#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/raw_scene.h"

namespace opaline::scene {

struct OrientationResult {
  std::size_t inconsistent = 0;  ///< triangles turned because they disagreed with their component
  std::size_t inward = 0;        ///< triangles of components that were turned as a whole
  std::vector<bool> turned;      ///< per triangle
};

/// Turns triangles so that neighbours agree and surfaces face outwards. `points` tells which
/// vertices are one point of the surface. Closed components enclose a positive volume afterwards,
/// unless they are a cavity inside another. Open ones are closed by fans first, and turned only
/// where the fans contribute little of the volume. Where nothing can be told, the majority keeps
/// its turn.
OrientationResult orientOutward(RawMesh& mesh, std::span<const std::uint32_t> points);

}  // namespace opaline::scene
