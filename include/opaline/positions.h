#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "opaline/export.h"
#include "opaline/motion.h"
#include "opaline/scene.h"
#include "opaline/types.h"

namespace opaline {

/// By index of an object: a position, mm, for each of its vertices, instead of where its mesh or
/// rig puts them, as Renderer::replacePositions has it.
using PositionsByObject = std::map<std::size_t, std::vector<Vec3>>;

/// Where the vertices of every object are at a time, mm: the clip moves rigs, and the scene's
/// deformers move everything but a ground. That is what the renderer draws, computed on the host,
/// for boxes, cameras that follow, picking and export. Throws UsageError for a clip that does not
/// exist, and for given positions that do not fit their object, are not finite or beyond 1e18 mm.
OPALINE_API std::vector<std::vector<Vec3>> positionsAt(const Scene& scene, const SceneTime& time,
                                                       const PositionsByObject& given = {});

}  // namespace opaline
