#pragma once

#include <cstddef>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "shaders/scatter/surface.frag.h"
#include "shaders/scatter/surface.vert.h"
#include "shaders/shared/frame.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Draws what the camera sees, so that sums are spent on visible fragments alone, and interpolates
/// the exitance of the vertices.
class SurfacePass {
 public:
  explicit SurfacePass(gpu::Device& device);

  static VisibleSurface makeSurface(gpu::Device& device, std::uint32_t width, std::uint32_t height);
  static Exitance makeExitance(gpu::Device& device, std::uint32_t width, std::uint32_t height,
                               std::uint32_t vertices);

  struct Inputs {
    FrameView& frame;
    DeformedMesh& mesh;
    shared::vec2 jitter;  ///< of the picture, in clip space
    gpu::Buffer& vertexExitance;
  };
  void record(gpu::CommandList& commands, const Inputs& inputs, VisibleSurface& surface) const;

 private:
  gpu::Graphics<shaders::ScatterSurfaceVert, shaders::ScatterSurfaceFrag> pipeline_;
};

}  // namespace opaline::passes
