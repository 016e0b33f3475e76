#pragma once

#include <array>
#include <optional>
#include <vector>

#include "opaline/medium.h"
#include "opaline/scene.h"
#include "reference/vector.h"

namespace opaline::reference {

/// One body as it is at the moment that is shown.
struct Body {
  std::vector<Vector> positionsMm;
  std::vector<Vector> normals;      ///< unit, one per position
  std::vector<Triangle> triangles;  ///< counter-clockwise seen from outside
  Medium medium;
  /// Paint, and what it reads of the vertices, as opaline::Mesh has it. Path tracing knows it, the
  /// integral does not.
  struct Painted {
    Paint paint;
    std::array<std::vector<Vec2>, 2> textureCoordinates;
    std::vector<std::array<float, 4>> colors;
  };
  std::optional<Painted> painted{};
};

/// All that a picture depends on. Nothing refers to the scene it was made from.
struct Scene {
  std::vector<Body> bodies;  ///< in the order of the objects
  Lighting lighting;
  Camera camera;
};

/// The smallest box around all vertices.
struct Box {
  Vector minMm{};
  Vector maxMm{};

  Vector centre() const { return 0.5 * (minMm + maxMm); }
  double diagonalMm() const { return length(maxMm - minMm); }
};
Box boxOf(const Scene& scene);

/// Throws Error for what makes no sense: no surface, more than 100 million triangles, a place, a
/// light or a coefficient that is not finite or out of range, an index without its vertex.
void requireSound(const Scene& scene);

}  // namespace opaline::reference
