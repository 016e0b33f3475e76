#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "opaline/scene.h"
#include "reference/scene.h"

namespace opaline::app {

/// By object: one position for each of its vertices, instead of where its mesh or rig puts them.
using GivenPositions = std::map<std::size_t, std::vector<Vec3>>;

/// The scene as it is at that time of a clip (-1: none). The scene's deformers apply to given
/// positions too. Throws UsageError unless they fit their object.
reference::Scene referenceScene(const Scene& scene, int clip, double seconds,
                                const GivenPositions& positionsMm = {});

}  // namespace opaline::app
