#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "opaline/export.h"
#include "opaline/scene.h"
#include "opaline/types.h"

namespace opaline {

/// A mesh of your own: positions, mm, and triangles that are counter-clockwise seen from outside.
/// Order and number of both stay as they are, so that later positions fit
/// (Renderer::replacePositions). Normals are smooth: means of the triangles' normals, weighted by
/// angle. Throws UsageError for positions that are not finite or beyond 1e18 mm, and for triangles
/// that name vertices that do not exist.
OPALINE_API Mesh makeMesh(std::vector<Vec3> positionsMm, std::vector<Triangle> triangles);

/// Facts about a mesh as a surface. Open edges that coincide count as sewn together.
struct MeshFacts {
  bool closed = false;            ///< every edge has a triangle on both sides
  std::size_t boundaryLoops = 0;  ///< borders of its holes
  std::size_t components = 0;     ///< parts that share no vertex with each other
  /// Triangles of parts that have no inside because they are open; holes of up to a twentieth of a
  /// part's surface do not count. Transport::Boundary treats the medium there as a half-space.
  std::size_t trianglesWithoutInside = 0;
};

/// The facts about a mesh. Throws UsageError as makeMesh() does.
OPALINE_API MeshFacts factsOf(std::span<const Vec3> positionsMm,
                              std::span<const Triangle> triangles);

/// A body of a scene: an object, or several translucent ones whose open edges coincide in the rest
/// pose. Light travels through them as through one.
struct BodyFacts {
  std::vector<std::size_t> objects;  ///< their indices
  MeshFacts surface;                 ///< of all of them together
  /// For each of `objects`.
  std::vector<std::size_t> trianglesWithoutInside;
};

/// All bodies, in the order of their first objects. Throws as factsOf() does.
OPALINE_API std::vector<BodyFacts> bodiesOf(const Scene& scene);

}  // namespace opaline
