#pragma once

#include <cstddef>
#include <vector>

#include "deform/deformed_vertices.h"
#include "opaline/positions.h"
#include "opaline/scene.h"
#include "reference/scene.h"
#include "scene/pose.h"

namespace opaline::reference {

/// An object in that pose and at that time, with the scene's deformers.
deform::DeformedVertices meshAt(const opaline::Scene& scene, std::size_t object,
                                const scene::Pose& pose, double seconds,
                                const PositionsByObject& positionsMm);

/// The scene at that time of a clip (-1: none). The scene's deformers also apply to given
/// positions. Throws UsageError unless positions fit their object.
Scene posedScene(const opaline::Scene& scene, const SceneTime& time,
                 const PositionsByObject& positionsMm = {});

}  // namespace opaline::reference
