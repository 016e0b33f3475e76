#pragma once

#include <cstdint>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "passes/variants.h"
#include "shaders/boundary/beam_groups.comp.h"
#include "shaders/boundary/beam_nodes.comp.h"
#include "shaders/boundary/beams.comp.h"
#include "shaders/boundary/mirrored.comp.h"
#include "shaders/boundary/reentry.comp.h"
#include "shaders/boundary/second_collisions.comp.h"
#include "shaders/boundary/single.comp.h"
#include "shaders/boundary/source.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Light that enters, followed to its collisions in the body, and what these give to every cluster
/// before any diffusion: fluence as in a medium without end, and light that leaves at once.
class BeamPass {
 public:
  explicit BeamPass(gpu::Device& device);

  struct Inputs {
    FrameView& frame;
    SceneTables& tables;
    Surfels& surfels;
    RayHierarchy& rays;
    float openingAngle;  ///< of nodes: taken from further than their radius over this
    float openingAngleOfSky;
  };
  struct Wanted {
    bool sky;      ///< light from everywhere is not dark
    bool bounces;  ///< recordReentry follows
  };
  /// All lights and what comes from everywhere.
  void recordLights(gpu::CommandList& commands, const Inputs& inputs, const Wanted& wanted,
                    Clusters& clusters) const;
  /// Light that just left, `latest`, where it enters again.
  void recordReentry(gpu::CommandList& commands, const Inputs& inputs, Clusters& clusters,
                     bool isFirst) const;

 private:
  struct Beam {
    std::uint32_t firstLight;  ///< or the number of lights
    bool mirrors;              ///< what the surface does not let in goes on
  };
  void trace(gpu::CommandList& commands, const Inputs& inputs, const Beam& beam, Clusters& clusters,
             Beams& beams) const;
  void followOn(gpu::CommandList& commands, const Inputs& inputs, const Beam& beam,
                Clusters& clusters, Beams& beams) const;
  void bringMirrored(gpu::CommandList& commands, std::uint32_t firstLight,
                     Clusters& clusters) const;
  void spread(gpu::CommandList& commands, const Inputs& inputs, Clusters& clusters, Beams& beams,
              bool adds) const;
  struct Part {
    bool isFirst;  ///< for these lights
    bool adds;     ///< to what other light and other parts gave
  };
  template <typename Shader>
  void sum(gpu::CommandList& commands, const gpu::Compute<Shader>& pipeline, gpu::Buffer& sums,
           const Part& part, const Inputs& inputs, Clusters& clusters, Beams& beams) const;
  void listActing(gpu::CommandList& commands, std::uint32_t firstNode, const Inputs& inputs,
                  Clusters& clusters, const Beams& beams) const;
  void fitNodes(gpu::CommandList& commands, SceneTables& tables, Clusters& clusters,
                Beams& beams) const;

  /// Where nothing is painted, or no body has a lining, the shader has no code for it.
  static Variants<shaders::BoundaryBeams> makeTrace(gpu::Device& device, bool withPaint);

  VariantsOfTwo<shaders::BoundaryBeams> trace_;  ///< by paint, then linings
  std::uint32_t sharers_;  ///< invocations among which the paths of a beam are divided
  Variants<shaders::BoundarySecondCollisions> followOn_;  ///< by linings
  gpu::Compute<shaders::BoundaryMirrored> addMirrored_;
  gpu::Compute<shaders::BoundaryMirrored> takeMirrored_;
  gpu::Compute<shaders::BoundaryBeamNodes> leaves_;
  gpu::Compute<shaders::BoundaryBeamNodes> nodes_;
  gpu::Compute<shaders::BoundaryBeamGroups> acting_;
  Variants<shaders::BoundarySource> source_;         ///< by bodies of several media, as the next
  Variants<shaders::BoundarySingle> singleForward_;  ///< where a medium does not scatter evenly
  gpu::Compute<shaders::BoundarySingle> singleEven_;
  Variants<shaders::BoundaryReentry> reentry_;
};

}  // namespace opaline::passes
