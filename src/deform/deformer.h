#pragma once

#include "opaline/scene.h"
#include "scene/vector_math.h"

namespace opaline::deform {

/// A point of a surface.
struct SurfacePoint {
  scene::Double3 position{};
  scene::Double3 normal{};  ///< unit
};

/// How strong a deformer is at a time: amount · sin 2πt/period, or the amount if the period is 0.
/// The amount of a wobble is constant; its wave travels.
double amountAt(const Deformer& deformer, double seconds);

/// How far the wave of a wobble has travelled, in periods, in [0, 1); a period of 0 is 1 s.
double wavePhaseAt(const Deformer& deformer, double seconds);

/// Where one deformer moves a point; `restBox` is the box around the scene's rest pose, mm. The
/// normal is transformed by the cofactors of the Jacobian, as the triangles' own normals are. So
/// both flip where a bend folds what lies beyond its centre. In a box without height nothing moves.
SurfacePoint deformed(const Deformer& deformer, const Bounds& restBox, double seconds,
                      const SurfacePoint& point);

}  // namespace opaline::deform
