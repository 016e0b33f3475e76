#pragma once

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "passes/variants.h"
#include "shaders/shade/reflected_lights.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Number of SceneTables::reflectionLobes; the shader has the same constant.
constexpr int reflectionLobeEntries = 16;

/// Adds reflections of area lights, with their shape, to the radiance of all surfaces that pixels
/// see.
class ReflectedLightsPass {
 public:
  explicit ReflectedLightsPass(gpu::Device& device);

  struct Inputs {
    SceneTables& tables;
    Surfels& surfels;
    RayHierarchy& rays;
    OpaqueTables& opaque;
  };
  /// After VisibleSurfaces::light has the radiance.
  void record(gpu::CommandList& commands, const Inputs& inputs, const SeenSurfaces& seen) const;

 private:
  gpu::Sampler nearest_;
  gpu::Compute<shaders::ShadeReflectedLights> bare_;  // if no surface has a material of its own
  Variants<shaders::ShadeReflectedLights> withMaterials_;
};

}  // namespace opaline::passes
