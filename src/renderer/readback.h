#pragma once

#include "opaline/renderer.h"
#include "renderer/camera_view.h"
#include "renderer/frame.h"

namespace opaline::gpu {
class Device;
}

namespace opaline {

/// The image of one output variable, from what a finished frame left on the device. Blocks.
Image readAov(gpu::Device& device, Aov aov, FrameResources& resources, const CameraView& camera);

/// Whether a variable is read off the pixels' centres, or needs places among the neighbourhoods there.
bool needsCentre(Aov aov);
bool needsPlaces(Aov aov);

}  // namespace opaline
