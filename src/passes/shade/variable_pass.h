#pragma once

#include <cstdint>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "shaders/shade/variable.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Leaves a variable of the pixels' centres on the device for the caller.
class VariablePass {
 public:
  explicit VariablePass(gpu::Device& device);

  /// For set-up, not for frames: one texel per pixel.
  static gpu::GpuImage makeImage(gpu::Device& device, VkExtent2D extent);

  struct Inputs {
    SeenCentres& centres;
    gpu::GpuImage& values;   ///< whether they are read depends on the kind
    std::uint32_t kind = 0;  ///< shared::variableValues and so on
    glm::vec4 depth{0};      ///< xyz: the camera's axis; w: minus the camera's place along it
    glm::vec3 origin{0};     ///< to which the scene has been moved, mm
  };
  void record(gpu::CommandList& commands, const Inputs& inputs, gpu::GpuImage& variable) const;

 private:
  gpu::Sampler nearest_;
  gpu::Compute<shaders::ShadeVariable> pipeline_;
};

}  // namespace opaline::passes
