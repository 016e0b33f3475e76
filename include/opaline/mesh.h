#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "opaline/export.h"
#include "opaline/scene.h"
#include "opaline/types.h"

namespace opaline {

/// A mesh of your own: positions, mm, and triangles that are counter-clockwise seen from outside.
/// All stays as it is, so that positions given later fit (Renderer::replacePositions). Normals are
/// smooth: the mean of the triangles', weighted by their angles. Throws UsageError for positions
/// that are not finite or beyond 1e18 mm, and for triangles that name vertices that do not exist.
OPALINE_API Mesh makeMesh(std::vector<Vec3> positionsMm, std::vector<Triangle> triangles);

/// What a mesh is like as a surface. Open edges that lie upon each other count as sewn together.
struct MeshFacts {
  bool closed = false;            ///< every edge has a triangle on both sides
  std::size_t boundaryLoops = 0;  ///< borders of its holes
  std::size_t components = 0;     ///< parts whose triangles do not share a vertex
  /// Of parts that have no inside: open but for holes of at most a twentieth of their surface.
  /// Transport::Boundary lets light scatter there as in a half-space.
  std::size_t trianglesWithoutInside = 0;
};

/// Throws UsageError for triangles that name vertices that do not exist, and for positions that are
/// not finite or beyond 1e18 mm.
OPALINE_API MeshFacts factsOf(std::span<const Vec3> positionsMm,
                              std::span<const Triangle> triangles);

/// A body of a scene: an object, or several translucent ones whose open edges lie upon each other
/// in the rest pose. Light goes through them as through one.
struct BodyFacts {
  std::vector<std::size_t> objects;  ///< their indices
  MeshFacts surface;                 ///< of all of them together
  /// Of each of these objects.
  std::vector<std::size_t> trianglesWithoutInside;
};

/// In the order of their first objects. Throws as factsOf() does.
OPALINE_API std::vector<BodyFacts> bodiesOf(const Scene& scene);

}  // namespace opaline
