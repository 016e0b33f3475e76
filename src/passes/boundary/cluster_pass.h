#pragma once

#include <cstdint>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "passes/variants.h"
#include "shaders/boundary/cluster_nodes.comp.h"
#include "shaders/boundary/clusters.comp.h"
#include "shaders/boundary/enclose.comp.h"
#include "shaders/boundary/entries.comp.h"
#include "shaders/boundary/survey.comp.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Updates the places at which boundary transport is solved for a frame: their shape, the light
/// that enters, the body's thickness and what they see of the scene.
class ClusterPass {
 public:
  explicit ClusterPass(gpu::Device& device);

  /// Makes room for what rays meet behind thin parts of bodies, once.
  static void makeRoomBehind(gpu::Device& device, Clusters& clusters);

  struct ShapeInputs {
    DeformedMesh& mesh;
    SceneTables& tables;
    Sky& sky;
    Surfels& surfels;
    RayHierarchy& rays;
    float openingAngle;  ///< of nodes: taken from further than their radius over this
    bool looksAround;    ///< else each cluster sees all of the sky and nothing else
    bool looksThrough;   ///< and the sky behind bodies that let some of its light through
  };
  /// Records where clusters lie, and which nodes act on which.
  void recordShape(gpu::CommandList& commands, const ShapeInputs& inputs, Clusters& clusters) const;
  /// Records how thick the body is, and what clusters see of the scene.
  void recordSurvey(gpu::CommandList& commands, const ShapeInputs& inputs,
                    Clusters& clusters) const;

  struct EntryInputs {
    FrameView& frame;
    DeformedMesh& mesh;
    SceneTables& tables;
    Sky& sky;
    Surfels& surfels;
    std::uint32_t lights;  ///< of all kinds
    bool areaLights;       ///< there are area lights
    bool skyIsDark;
  };
  /// Records the light that enters.
  void recordEntries(gpu::CommandList& commands, const EntryInputs& inputs,
                     Clusters& clusters) const;

 private:
  void gather(gpu::CommandList& commands, const ShapeInputs& inputs, Clusters& clusters) const;
  void fitNodes(gpu::CommandList& commands, Clusters& clusters) const;
  void enclose(gpu::CommandList& commands, const ShapeInputs& inputs, Clusters& clusters) const;
  void survey(gpu::CommandList& commands, const ShapeInputs& inputs, Clusters& clusters) const;

  gpu::Sampler linear_;
  gpu::Compute<shaders::BoundaryClusters> gather_;
  VariantsOfTwo<shaders::BoundaryEntries> entries_;  ///< indexed by area lights and normal textures
  gpu::Compute<shaders::BoundaryClusterNodes> nodes_;
  gpu::Compute<shaders::BoundaryEnclose> enclose_;
  VariantsOfTwo<shaders::BoundarySurvey> survey_;  ///< by thin parts, then paint
};

}  // namespace opaline::passes
