#pragma once

#include "opaline/renderer.h"
#include "renderer/camera_view.h"
#include "renderer/frame.h"

namespace opaline::gpu {
class Device;
}

namespace opaline {

/// The image of one output variable, from what a finished frame left on the device. Blocks.
Image readAov(gpu::Device& device, Aov aov, Site site, FrameResources& resources,
              const CameraView& camera);

/// Whether a variable is read off the pixels' centres.
bool needsCentre(Aov aov);

}  // namespace opaline
