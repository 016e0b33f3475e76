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

/// Throws UsageError unless the positions have an object each, and one for each of its vertices
/// that is finite and within 1e18 mm.
void requireFit(const Scene& scene, const PositionsByObject& positionsMm);

/// Whether an object's normals have to be taken from its moved triangles: where they are those of
/// the triangles, or a morph target moves positions and does not say what becomes of the normals.
bool normalsFromTriangles(const Object& object);

/// The positions alone, which is less work.
std::vector<scene::Double3> deformedPositions(const Scene& scene, std::size_t object,
                                              const scene::Pose& pose, const Bounds& restBox,
                                              double seconds);

/// Of a body whose vertices somebody put there before the deformers act.
std::vector<scene::Double3> deformedPositions(const std::vector<Deformer>& deformers,
                                              const std::vector<Vec3>& positionsMm,
                                              const Bounds& restBox, double seconds);

/// Morphs, skins, then applies the scene's deformers. Normals follow by cofactors; where they
/// cannot, they are those of the triangles at their final places: each triangle's own for a
/// facetted mesh, otherwise smooth, weighted by angle.
DeformedVertices deformedVertices(const Scene& scene, std::size_t object, const scene::Pose& pose,
                                  const Bounds& restBox, double seconds);

/// The same at a time of a clip (-1: none).
DeformedVertices deformedVertices(const Scene& scene, std::size_t object, int clip, double seconds);

}  // namespace opaline::deform
