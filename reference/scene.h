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

/// One body at the moment shown.
struct Body {
  std::vector<Vector> positionsMm;
  std::vector<Vector> normals;      ///< unit, one per position
  std::vector<Triangle> triangles;  ///< counter-clockwise seen from outside
  Medium medium;
  std::optional<Paint> paint{};                 ///< path tracing knows it, the integral does not
  std::optional<TranslucentSurface> surface{};  ///< path tracing knows it, the integral does not
  std::optional<OpaqueMaterial> opaque{};  ///< if set, light does not enter and `medium` is unused
  bool isGround = false;                   ///< does not count towards the scene's size
  // Vertex attributes for textures, as in opaline::Mesh.
  std::array<std::vector<Vec2>, 2> textureCoordinates{};
  std::vector<std::array<float, 4>> colors{};
  std::vector<scene::TriangleTangents> tangents{};  ///< if the material has a normal texture
};

/// Everything on which a picture depends. Nothing refers to the scene it was made from.
struct Scene {
  std::vector<Body> bodies;  ///< in the order of the objects
  /// Bodies with the same number are parts of one body; empty: each is a body by itself.
  std::vector<std::uint32_t> wholeOfBody;
  Lighting lighting;
  Camera camera;
};

/// The smallest box around all vertices. A ground counts only if there is nothing else.
struct Box {
  Vector minMm{};
  Vector maxMm{};

  Vector centre() const { return 0.5 * (minMm + maxMm); }
  double diagonalMm() const { return length(maxMm - minMm); }
};
Box boxOf(const Scene& scene);
/// The same for bodies of media alone.
Box boxOfMedia(const Scene& scene);

/// Whether light enters any body.
bool hasMedia(const Scene& scene);

/// The number of the body to which this one belongs.
inline std::uint32_t wholeOf(const Scene& scene, std::uint32_t body) {
  return scene.wholeOfBody.empty() ? body : scene.wholeOfBody[body];
}

/// Throws Error for invalid scenes: without surface, with more than 100 million triangles, with a
/// place, light or coefficient that is not finite or out of range, or with an index without vertex.
void requireSound(const Scene& scene);

}  // namespace opaline::reference
