#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "opaline/export.h"
#include "opaline/motion.h"
#include "opaline/scene.h"
#include "opaline/types.h"

namespace opaline {

/// By index of an object: a position for each of its vertices, mm, that replaces that of its mesh
/// or rig, as in Renderer::replacePositions.
using PositionsByObject = std::map<std::size_t, std::vector<Vec3>>;

/// The positions of every object's vertices at a time, mm. The clip moves rigs, and the scene's
/// deformers move everything except a ground. They are those that the renderer draws, but computed
/// on the host: for bounds, cameras that follow, picking and export. The scene must be one that
/// Renderer::setScene accepts. Throws UsageError for a clip that does not exist, and for given
/// positions that do not fit their object, are not finite or beyond 1e18 mm.
OPALINE_API std::vector<std::vector<Vec3>> positionsAt(const Scene& scene, const SceneTime& time,
                                                       const PositionsByObject& given = {});

}  // namespace opaline
