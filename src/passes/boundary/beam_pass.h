#pragma once

#include <cstdint>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "passes/variants.h"
#include "shaders/boundary/beam_groups.comp.h"
#include "shaders/boundary/beam_nodes.comp.h"
#include "shaders/boundary/beams.comp.h"
#include "shaders/boundary/guided.comp.h"
#include "shaders/boundary/mirrored.comp.h"
#include "shaders/boundary/second_collisions.comp.h"
#include "shaders/boundary/single.comp.h"
#include "shaders/boundary/single_coefficients.comp.h"
#include "shaders/boundary/source.comp.h"
#include "shaders/boundary/source_coefficients.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Follows light that enters to its collisions in the body, and finds what these give every cluster
/// before any diffusion: fluence as in an infinite medium, and light that leaves at once.
class BeamPass {
 public:
  explicit BeamPass(gpu::Device& device);

  /// Makes room for the coefficients of light from everywhere. For set-up.
  static void makeCoefficients(gpu::Device& device, Clusters& clusters);

  struct Inputs {
    FrameView& frame;
    SceneTables& tables;
    Surfels& surfels;
    RayHierarchy& rays;
    float openingAngle;  ///< a node is taken as a whole beyond its radius divided by this
    float openingAngleOfEverywhere;
    bool keepsCoefficients;  ///< of light from everywhere, until the shape changes
  };
  struct Wanted {
    bool sky;      ///< light from everywhere is not dark
    bool bounces;  ///< recordAgain follows
    bool isNew;    ///< the shape is new, so its coefficients have to be found
  };
  /// Records the light of all lights and the light from everywhere.
  void recordLights(gpu::CommandList& commands, const Inputs& inputs, const Wanted& wanted,
                    Clusters& clusters) const;
  /// Records light that enters again, as ReentryPass found it. `isNew`: the shape is new, and no
  /// light from everywhere has been recorded for it.
  void recordAgain(gpu::CommandList& commands, const Inputs& inputs, bool isNew,
                   Clusters& clusters) const;

 private:
  struct Beam {
    std::uint32_t firstLight;  ///< or the number of lights
    bool entersAgain;          ///< what the surface mirrors and what bodies let through
  };
  void trace(gpu::CommandList& commands, const Inputs& inputs, const Beam& beam, Clusters& clusters,
             Beams& beams) const;
  void followOn(gpu::CommandList& commands, const Inputs& inputs, const Beam& beam,
                Clusters& clusters, Beams& beams) const;
  void bringMirrored(gpu::CommandList& commands, std::uint32_t firstLight, bool isLast,
                     Clusters& clusters) const;
  /// Light that scattered once and was then mirrored inside: clears its sums; adds up where it
  /// leaves and adds that to `latest`.
  static void clearGuided(gpu::CommandList& commands, const SceneTables& tables,
                          Clusters& clusters);
  struct GuidedOf {
    bool ofLights;  ///< of the last lights
    bool ofEverywhere;
  };
  void takeGuided(gpu::CommandList& commands, const SceneTables& tables, const GuidedOf& of,
                  Clusters& clusters) const;
  void spreadLights(gpu::CommandList& commands, const Inputs& inputs, Clusters& clusters,
                    bool adds) const;
  void spreadEverywhere(gpu::CommandList& commands, const Inputs& inputs, Clusters& clusters,
                        bool adds, bool isNew) const;
  struct Spreading;  // light that is spread, and the trees for it
  struct Part {
    bool isFirst;  ///< the first for these lights
    bool adds;     ///< adds to the results of other light and other parts
  };
  void sumUp(gpu::CommandList& commands, const Part& part, const Spreading& of) const;
  template <typename Shader>
  void sum(gpu::CommandList& commands, const gpu::Compute<Shader>& pipeline, gpu::Buffer& sums,
           const Part& part, const Spreading& of) const;
  void findCoefficients(gpu::CommandList& commands, const Spreading& of) const;
  template <typename Shader>
  void findCoefficients(gpu::CommandList& commands, const gpu::Compute<Shader>& pipeline,
                        const Spreading& of) const;
  struct Trees {  // consecutive trees
    std::uint32_t first;
    std::uint32_t count;
  };
  void listActing(gpu::CommandList& commands, std::uint32_t firstNode, const Trees& trees,
                  const Spreading& of) const;
  void fitNodes(gpu::CommandList& commands, const Trees& trees, const Spreading& of) const;

  /// Variants without code for paint, linings or thin parts, if the scene has none.
  static VariantsOfTwo<shaders::BoundaryBeams> makeTrace(gpu::Device& device, bool withPaint);

  VariantsOfThree<shaders::BoundaryBeams> trace_;  ///< indexed by paint, linings, thin parts
  std::uint32_t sharers_;                          ///< invocations that share the paths of a beam
  Variants<shaders::BoundarySecondCollisions> followOn_;  ///< indexed by linings
  gpu::Compute<shaders::BoundaryMirrored> addMirrored_;
  gpu::Compute<shaders::BoundaryMirrored> takeMirrored_;
  gpu::Compute<shaders::BoundaryGuided> addGuided_;
  gpu::Compute<shaders::BoundaryGuided> takeGuided_;
  gpu::Compute<shaders::BoundaryBeamNodes> leaves_;
  gpu::Compute<shaders::BoundaryBeamNodes> nodes_;
  gpu::Compute<shaders::BoundaryBeamGroups> acting_;
  Variants<shaders::BoundarySource> source_;  ///< indexed by bodies of several media, like the next
  Variants<shaders::BoundarySingle> singleForward_;  ///< for media that do not scatter
                                                     ///< isotropically
  gpu::Compute<shaders::BoundarySingle> singleEven_;
  Variants<shaders::BoundarySourceCoefficients> sourceCoefficients_;
  Variants<shaders::BoundarySingleCoefficients> singleForwardCoefficients_;
  gpu::Compute<shaders::BoundarySingleCoefficients> singleEvenCoefficients_;
};

}  // namespace opaline::passes
