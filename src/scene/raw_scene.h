#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "opaline/scene.h"

namespace opaline::scene {

/// A mesh as a file gives it: in range, but neither repaired nor scaled nor oriented.
struct RawMesh {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;  ///< empty, or one per position, any length
  /// Vertices whose tags differ are different even where position and normal agree; empty: all
  /// alike.
  std::vector<std::uint64_t> tags;
  std::vector<Triangle> triangles;
  std::size_t badPolygons = 0;  ///< faces that never became a triangle: fewer than three corners
};

struct RawObject {
  std::string name;
  RawMesh mesh;
  Medium medium;
};

/// What a file holds, in the file's unit, before repair, scale and defaults.
struct RawScene {
  std::vector<RawObject> objects;
  Lighting lighting;
  bool hasLights = false;
  std::optional<Camera> camera;
  std::optional<double> mmPerUnit;  ///< unknown for formats without a unit
};

}  // namespace opaline::scene
