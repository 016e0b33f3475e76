#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/rest_surface.h"
#include "opaline/scene.h"

namespace opaline::scene {

/// Throws UsageError for positions that are not finite or beyond 1e18 mm, and for triangles whose
/// vertices do not exist.
void requireSound(std::span<const Vec3> positionsMm, std::span<const Triangle> triangles);

/// All objects of a scene end to end, in the rest pose, as one surface.
struct MergedMesh {
  std::vector<Vec3> positionsMm;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> objectOfTriangle;
  std::vector<std::uint32_t> bodyOfTriangle;  ///< numbered as in bodyOfObject
  std::vector<std::uint32_t> bodyOfObject;    ///< see bodyOfObjects()
  std::vector<std::uint32_t> firstObjectOfBody;
};

MergedMesh mergedMesh(const Scene& scene);

/// The result refers to the mesh, which must outlive it.
core::RestSurface surfaceOf(const MergedMesh& merged);

/// The same with each body as one object, since a body is divided as a whole.
core::RestSurface bodiesOf(const MergedMesh& merged);

}  // namespace opaline::scene
