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
#include "shaders/boundary/reentry.comp.h"
#include "shaders/boundary/second_collisions.comp.h"
#include "shaders/boundary/single.comp.h"
#include "shaders/boundary/single_coefficients.comp.h"
#include "shaders/boundary/source.comp.h"
#include "shaders/boundary/source_coefficients.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Light that enters, followed to its collisions in the body, and what these give to every cluster
/// before any diffusion: fluence as in a medium without end, and light that leaves at once.
class BeamPass {
 public:
  explicit BeamPass(gpu::Device& device);

  /// Room for what is kept of light that comes from everywhere. For set-up.
  static void makeCoefficients(gpu::Device& device, Clusters& clusters);

  struct Inputs {
    FrameView& frame;
    SceneTables& tables;
    Surfels& surfels;
    RayHierarchy& rays;
    float openingAngle;  ///< of nodes: taken from further than their radius over this
    float openingAngleOfEverywhere;
    bool keepsCoefficients;  ///< of what comes from everywhere, until the shape changes
  };
  struct Wanted {
    bool sky;      ///< light from everywhere is not dark
    bool bounces;  ///< recordReentry follows
    bool isNew;    ///< the shape: what is kept of it is found
  };
  /// All lights and what comes from everywhere.
  void recordLights(gpu::CommandList& commands, const Inputs& inputs, const Wanted& wanted,
                    Clusters& clusters) const;
  struct Reentry {
    bool isFirst;
    bool isNew;  ///< the shape, and no light has come from everywhere before
  };
  /// Light that just left, `latest`, where it enters again.
  void recordReentry(gpu::CommandList& commands, const Inputs& inputs, const Reentry& reentry,
                     Clusters& clusters) const;

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
  /// Of light that scattered once, what was mirrored inside: none yet; of the last lights or of
  /// what comes from everywhere, added up where it leaves; and both sums, to `latest`.
  static void clearGuided(gpu::CommandList& commands, const SceneTables& tables,
                          Clusters& clusters);
  void addGuided(gpu::CommandList& commands, const SceneTables& tables, bool ofEverywhere,
                 Clusters& clusters) const;
  void takeGuided(gpu::CommandList& commands, const SceneTables& tables, Clusters& clusters) const;
  static void bringGuided(gpu::CommandList& commands,
                          const gpu::Compute<shaders::BoundaryGuided>& pipeline, bool ofEverywhere,
                          Clusters& clusters);
  void spreadLights(gpu::CommandList& commands, const Inputs& inputs, Clusters& clusters,
                    bool adds) const;
  void spreadEverywhere(gpu::CommandList& commands, const Inputs& inputs, Clusters& clusters,
                        bool adds, bool isNew) const;
  struct Spreading;  // of what, and by which trees
  struct Part {
    bool isFirst;  ///< for these lights
    bool adds;     ///< to what other light and other parts gave
  };
  void sumUp(gpu::CommandList& commands, const Part& part, const Spreading& of) const;
  template <typename Shader>
  void sum(gpu::CommandList& commands, const gpu::Compute<Shader>& pipeline, gpu::Buffer& sums,
           const Part& part, const Spreading& of) const;
  void findCoefficients(gpu::CommandList& commands, const Spreading& of) const;
  template <typename Shader>
  void findCoefficients(gpu::CommandList& commands, const gpu::Compute<Shader>& pipeline,
                        const Spreading& of) const;
  struct Trees {  // that follow each other
    std::uint32_t first;
    std::uint32_t count;
  };
  void listActing(gpu::CommandList& commands, std::uint32_t firstNode, const Trees& trees,
                  const Spreading& of) const;
  void fitNodes(gpu::CommandList& commands, const Trees& trees, const Spreading& of) const;

  /// Where nothing is painted, or no body has a lining, the shader has no code for it.
  static Variants<shaders::BoundaryBeams> makeTrace(gpu::Device& device, bool withPaint);

  VariantsOfTwo<shaders::BoundaryBeams> trace_;  ///< by paint, then linings
  std::uint32_t sharers_;  ///< invocations among which the paths of a beam are divided
  Variants<shaders::BoundarySecondCollisions> followOn_;  ///< by linings
  gpu::Compute<shaders::BoundaryMirrored> addMirrored_;
  gpu::Compute<shaders::BoundaryMirrored> takeMirrored_;
  gpu::Compute<shaders::BoundaryGuided> addGuided_;
  gpu::Compute<shaders::BoundaryGuided> takeGuided_;
  gpu::Compute<shaders::BoundaryBeamNodes> leaves_;
  gpu::Compute<shaders::BoundaryBeamNodes> nodes_;
  gpu::Compute<shaders::BoundaryBeamGroups> acting_;
  Variants<shaders::BoundarySource> source_;         ///< by bodies of several media, as the next
  Variants<shaders::BoundarySingle> singleForward_;  ///< where a medium does not scatter evenly
  gpu::Compute<shaders::BoundarySingle> singleEven_;
  Variants<shaders::BoundarySourceCoefficients> sourceCoefficients_;
  Variants<shaders::BoundarySingleCoefficients> singleForwardCoefficients_;
  gpu::Compute<shaders::BoundarySingleCoefficients> singleEvenCoefficients_;
  Variants<shaders::BoundaryReentry> reentry_;
};

}  // namespace opaline::passes
