#pragma once

#include <cstdint>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "paper/products.h"
#include "passes/products.h"
#include "shaders/shared/frame.h"
#include "shaders/surface.frag.h"
#include "shaders/surface.vert.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::paper {

/// Draws what the camera sees as passes::SurfacePass does, less the facets, and where in the map it
/// lies.
class MappedSurfacePass {
 public:
  explicit MappedSurfacePass(gpu::Device& device);

  /// Room for Map::place.
  static gpu::GpuImage makePlace(gpu::Device& device, std::uint32_t width, std::uint32_t height);

  struct Inputs {
    passes::FrameView& frame;
    passes::DeformedMesh& mesh;
    FlatScene& flat;
    gpu::Buffer& charts;
    shared::vec2 jitter;  ///< of the picture, in clip space
    gpu::Buffer& vertexExitance;
  };
  void record(gpu::CommandList& commands, const Inputs& inputs, passes::VisibleSurface& surface,
              gpu::GpuImage& place) const;

 private:
  gpu::Graphics<shaders::SurfaceVert, shaders::SurfaceFrag> pipeline_;
};

}  // namespace opaline::paper
