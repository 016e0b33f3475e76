#pragma once

#include <memory>
#include <vector>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "shaders/scatter/visible_lights.vert.h"
#include "shaders/shade/compose.frag.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Lays the picture over what the caller has drawn, where nothing of that is nearer.
class ComposePass {
 public:
  explicit ComposePass(gpu::Device& device);

  /// The caller's depth: the rows of the matrix from mm to clip space that give z and w.
  struct Depth {
    shared::vec4 clipDepth{0};
    shared::vec4 clipW{0, 0, 0, 1};
    bool isReversed = false;
  };
  struct Target {
    gpu::GpuImage& color;
    gpu::GpuImage* depth = nullptr;  ///< none: the picture lies over everything
    Depth how;
    float scale = 1;                                        ///< of the radiance
    VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;  ///< of both targets
  };
  /// VisibleSurfaces still holds what the picture's pixels see.
  void record(gpu::CommandList& commands, const SeenSurfaces& seen, gpu::GpuImage& radiance,
              const Target& target);

 private:
  using Pipeline = gpu::Graphics<shaders::ScatterVisibleLightsVert, shaders::ShadeComposeFrag>;
  struct Made {
    VkFormat color;
    VkFormat depth;
    bool isReversed;
    VkSampleCountFlagBits samples;
    std::unique_ptr<const Pipeline> pipeline;
  };
  const Pipeline& pipelineFor(const Target& target);

  gpu::Device& device_;
  gpu::Sampler nearest_;
  std::vector<Made> made_;
};

}  // namespace opaline::passes
