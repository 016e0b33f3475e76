#pragma once

#include <cstdint>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "shaders/shade/seen_surfels.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Finds the surfels that the camera sees: for every visible place, the nearest piece of its
/// object.
class SeenSurfelsPass {
 public:
  explicit SeenSurfelsPass(gpu::Device& device);

  /// For set-up, not for frames.
  static SeenSurfels makeSeen(gpu::Device& device, VkExtent2D extent);

  struct Inputs {
    SceneTables& tables;
    SeenCentres& centres;
    Surfels& surfels;
    RayHierarchy& rays;           ///< of this frame
    Clusters* clusters;           ///< null if light is not carried by them
    std::uint32_t treeLevel = 0;  ///< of the nodes
  };
  void record(gpu::CommandList& commands, const Inputs& inputs, SeenSurfels& seen) const;

 private:
  gpu::Sampler nearest_;
  gpu::Compute<shaders::ShadeSeenSurfels> pipeline_;
};

}  // namespace opaline::passes
