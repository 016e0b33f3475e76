#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "opaline/medium.h"
#include "opaline/scene.h"
#include "reference/vector.h"
#include "scene/mesh/tangents.h"

namespace opaline::reference {

/// One body as it is at the moment that is shown.
struct Body {
  std::vector<Vector> positionsMm;
  std::vector<Vector> normals;      ///< unit, one per position
  std::vector<Triangle> triangles;  ///< counter-clockwise seen from outside
  Medium medium;
  std::optional<Paint> paint{};                 ///< path tracing knows it, the integral does not
  std::optional<TranslucentSurface> surface{};  ///< path tracing knows it, the integral does not
  std::optional<OpaqueMaterial> opaque{};  ///< if set, light does not enter: `medium` is not used
  bool isGround = false;                   ///< counts for no size
  // What textures read of the vertices, as opaline::Mesh has it.
  std::array<std::vector<Vec2>, 2> textureCoordinates{};
  std::vector<std::array<float, 4>> colors{};
  std::vector<scene::TriangleTangents> tangents{};  ///< where the material has a normal texture
};

/// All that a picture depends on. Nothing refers to the scene it was made from.
struct Scene {
  std::vector<Body> bodies;  ///< in the order of the objects
  /// Bodies with the same number are one, of several materials; empty: each is one by itself.
  std::vector<std::uint32_t> wholeOfBody;
  Lighting lighting;
  Camera camera;
};

/// The smallest box around all vertices but those of a ground, unless that is all there is.
struct Box {
  Vector minMm{};
  Vector maxMm{};

  Vector centre() const { return 0.5 * (minMm + maxMm); }
  double diagonalMm() const { return length(maxMm - minMm); }
};
Box boxOf(const Scene& scene);

/// Whether light enters any body.
bool hasMedia(const Scene& scene);

/// The number of the body that this one is a part of.
inline std::uint32_t wholeOf(const Scene& scene, std::uint32_t body) {
  return scene.wholeOfBody.empty() ? body : scene.wholeOfBody[body];
}

/// Throws Error for what makes no sense: no surface, more than 100 million triangles, a place, a
/// light or a coefficient that is not finite or out of range, an index without its vertex.
void requireSound(const Scene& scene);

}  // namespace opaline::reference
