#pragma once

#include <vector>

#include "opaline/renderer.h"
#include "paper/diffusion_source_pass.h"
#include "paper/pattern_mask.h"
#include "renderer/scene/scene_resources.h"

namespace opaline {

/// The pattern of every medium of the scene, and the neighbourhoods that hold them all.
struct PatternLayout {
  paper::AtlasMaps maps;
  std::vector<paper::PatternExtent> extentOfMedium;
};

/// For set-up, not for frames.
PatternLayout layOutPattern(const SceneResources& resources, const RenderOptions& options);

/// Edge of a texel of the diffusion source map on the rest pose, mm.
double texelEdgeMm(const SceneResources& resources, const RenderOptions& options);

}  // namespace opaline
