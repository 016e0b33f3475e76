#pragma once

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "shaders/shade/centres.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Stores what the pixels' centres see.
class CentresPass {
 public:
  explicit CentresPass(gpu::Device& device);

  static SeenCentres makeCentres(gpu::Device& device, VkExtent2D extent);

  /// `atFragments`: VisibleSurfaces::light has the exitance; else the vertices have it. Pixels that
  /// see nothing stay as they are.
  void record(gpu::CommandList& commands, const SeenSurfaces& seen, SceneTables& tables,
              Exitance& exitance, bool atFragments, SeenCentres& centres) const;

 private:
  gpu::Sampler nearest_;
  gpu::Compute<shaders::ShadeCentres> pipeline_;
};

}  // namespace opaline::passes
