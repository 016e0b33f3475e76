#pragma once

#include <cstddef>
#include <vector>

#include "opaline/positions.h"
#include "opaline/scene.h"
#include "scene/pose.h"
#include "scene/vector_math.h"

namespace opaline::deform {

/// The vertices of one object at one time, in double precision; its triangles stay.
struct DeformedVertices {
  std::vector<scene::Double3> positionsMm;
  std::vector<scene::Double3> normals;  ///< unit
};

/// Throws UsageError for a time out of range, and for a clip that the scene does not have.
void requireTime(const Scene& scene, const SceneTime& time);

/// Throws UsageError unless every entry's object exists and every vertex of it has a position that
/// is finite and within 1e18 mm.
void requireFit(const Scene& scene, const PositionsByObject& positionsMm);

/// Whether an object's normals have to be computed from its moved triangles: if it is facetted, or
/// if a morph target moves positions but has no normals.
bool normalsFromTriangles(const Object& object);

/// The same for positions alone, which is less work.
std::vector<scene::Double3> deformedPositions(const Scene& scene, std::size_t object,
                                              const scene::Pose& pose, const Bounds& restBox,
                                              double seconds);

/// The same for a body with given positions, to which only the deformers are applied.
std::vector<scene::Double3> deformedPositions(const std::vector<Deformer>& deformers,
                                              const std::vector<Vec3>& positionsMm,
                                              const Bounds& restBox, double seconds);

/// Morphs, skins, then applies the scene's deformers. Normals are transformed by cofactors. Where
/// that is impossible, they are computed from the moved triangles: each triangle's own for a
/// facetted mesh, otherwise smooth, weighted by angle.
DeformedVertices deformedVertices(const Scene& scene, std::size_t object, const scene::Pose& pose,
                                  const Bounds& restBox, double seconds);

/// The same at a time of a clip (-1: none).
DeformedVertices deformedVertices(const Scene& scene, std::size_t object, int clip, double seconds);

}  // namespace opaline::deform
