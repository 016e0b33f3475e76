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

/// The camera in a scene that has been moved to that origin. Throws UsageError for matrices that
/// are not a projection or not finite.
GivenCamera makeGivenCamera(const CameraMatrices& matrices, const Vec3& originMm, int width,
                            int height);

}  // namespace opaline
