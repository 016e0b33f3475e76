#pragma once

#include "opaline/view.h"
#include "passes/shade/compose_pass.h"
#include "renderer/frame/camera_view.h"

namespace opaline {

/// A camera that is given by matrices.
struct GivenCamera {
  CameraView view;
  passes::ComposePass::Depth depth;
};

/// Throws UsageError for matrices that are no perspective, or not finite.
GivenCamera makeGivenCamera(const CameraMatrices& matrices, int width, int height);

}  // namespace opaline
