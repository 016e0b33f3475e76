#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/mesh/ears.h"
#include "scene/raw_scene.h"
#include "scene/vector_math.h"

namespace opaline::scene {

/// Cuts polygons into triangles: fans where they are convex, ears where they are not. One object
/// serves one file and limits the work that a hostile file can cause.
class Triangulator {
 public:
  /// Appends to mesh.triangles, or counts a bad polygon. The corners must be valid indices of
  /// positions.
  void add(RawMesh& mesh, std::span<const std::uint32_t> corners);

 private:
  bool clipEars(RawMesh& mesh, std::span<const std::uint32_t> corners);

  std::size_t steps_ = 0;
  std::vector<Double2> flat_;
  Ears ears_;
};

}  // namespace opaline::scene
