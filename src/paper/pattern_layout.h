#pragma once

#include <vector>

#include "opaline/renderer.h"
#include "paper/diffusion_source_pass.h"
#include "paper/pattern_mask.h"
#include "paper/products.h"

namespace opaline::paper {

/// The pattern of every medium of the scene, and the neighbourhoods that hold them all.
struct PatternLayout {
  AtlasMaps maps;
  std::vector<PatternExtent> extentOfMedium;
};

/// For set-up, not for frames.
PatternLayout layOutPattern(const RestScene& scene, const FlatScene& flat,
                            const PatternOptions& options);

}  // namespace opaline::paper
