#pragma once

#include <optional>
#include <vector>

#include "opaline/scene.h"
#include "reference/scene.h"

namespace opaline::app {

/// The scene as it is at that time of a clip (-1: none). `positionsMm`, one per vertex of the first
/// object, stand for where its mesh or rig puts them; the scene's deformers still apply.
reference::Scene referenceScene(const Scene& scene, int clip, double seconds,
                                const std::optional<std::vector<Vec3>>& positionsMm = {});

}  // namespace opaline::app
