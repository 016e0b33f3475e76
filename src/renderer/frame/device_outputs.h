#pragma once

#include <optional>
#include <vector>

#include "gpu/command_list.h"
#include "opaline/vulkan.h"
#include "passes/shade/compose_pass.h"
#include "passes/shade/variable_pass.h"
#include "renderer/frame/camera_view.h"
#include "renderer/frame/frame_resources.h"
#include "renderer/motion/motion_tables.h"

namespace opaline {

/// Throws UsageError for outputs that a frame with these options cannot have. `hasMatrices`: the
/// camera is given by matrices.
void validate(const DeviceOutputs& outputs, const RenderOptions& options, bool hasMatrices);

/// Where an object's exitance lies in a buffer of all objects. Throws UsageError for an object that
/// does not exist.
struct ExitanceRange {
  std::size_t offset = 0;
  std::size_t bytes = 0;
};
ExitanceRange exitanceRange(const std::vector<ObjectRange>& ranges, std::size_t object);

/// Records the outputs that a view's frames leave on the device, or in the caller's memory.
class OutputRecorder {
 public:
  explicit OutputRecorder(gpu::Device& device)
      : device_(device), variable_(device), compose_(device) {}

  struct Inputs {
    passes::DeformedMesh& mesh;
    FrameResources& resources;
    const std::vector<ObjectRange>& ranges;
    passes::ComposePass::Depth depth;
    const CameraView& camera;
    const Vec3& originMm;  ///< that the scene has been moved to
  };
  /// Records them in a part of its own at the end of a frame.
  void record(gpu::CommandList& commands, const FrameOrder& order, const DeviceOutputs& outputs,
              const Inputs& inputs);

 private:
  void leave(gpu::CommandList& commands, Aov aov, const Inputs& inputs);
  void compose(gpu::CommandList& commands, const Composition& over, const Inputs& inputs);

  gpu::Device& device_;
  passes::VariablePass variable_;
  passes::ComposePass compose_;
};

}  // namespace opaline
