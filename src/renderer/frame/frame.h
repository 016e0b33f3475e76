#pragma once

#include <cstddef>
#include <cstdint>

#include "gpu/command_list.h"
#include "gpu/transfer.h"
#include "opaline/renderer.h"
#include "renderer/frame/frame_plan.h"
#include "renderer/frame/frame_resources.h"
#include "renderer/frame/passes.h"
#include "renderer/motion/scene_motion.h"
#include "renderer/scene/scene_resources.h"

namespace opaline {

/// What the host sets for a frame, in memory that the device reads.
struct FrameUpload {
  gpu::Buffer& buffer;
  std::size_t offset;  ///< of a shared::FrameData, see passes::FitPass
};

/// Records one frame: deformation, shadows, gathering and scattering at vertices, then what the
/// picture shows. A plan without `light` has only the last. A plan that does not `scatter` leaves
/// the exitance as it was.
void recordFrame(gpu::CommandList& commands, const Passes& passes, const FramePlan& plan,
                 const FrameUpload& upload, SceneMotion& motion, SceneResources& scene,
                 FrameResources& resources);

}  // namespace opaline
