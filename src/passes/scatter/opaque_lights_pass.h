#pragma once

#include <cstdint>

#include "gpu/command_list.h"
#include "passes/light_through.h"
#include "passes/products.h"
#include "shaders/scatter/opaque_area_lights.comp.h"
#include "shaders/scatter/opaque_area_vertices.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Light of area lights on opaque bodies, with soft shadows by rays. It is added to the light that
/// OpaquePass found.
class OpaqueLightsPass {
 public:
  explicit OpaqueLightsPass(gpu::Device& device);

  struct Inputs {
    FrameView& frame;
    SceneTables& tables;
    BodiesBetween between;
    std::uint32_t areaLights;  ///< how many
  };

  /// Sums at vertices, for objects whose site they are.
  void overVertices(gpu::CommandList& commands, const Inputs& inputs, ScatterSite site,
                    const Places& vertices) const;
  /// The side of surfaces that pixels see, or the other side of those that let light through.
  enum class Side { Seen, Other };
  /// Sums at fragments, for objects whose site they are. Light on the other side goes to
  /// SeenMaterial::behind.
  void overFragments(gpu::CommandList& commands, const Inputs& inputs, ScatterSite site, Side side,
                     std::uint32_t firstRow, const SeenSurfaces& seen) const;

 private:
  gpu::Sampler nearest_;
  ThroughVariants<shaders::ScatterOpaqueAreaVertices> vertices_;
  ThroughVariants<shaders::ScatterOpaqueAreaLights> fragments_;
};

}  // namespace opaline::passes
