#pragma once

#include <span>

#include "gpu/command_list.h"
#include "gpu/pipeline.h"
#include "passes/products.h"
#include "passes/variants.h"
#include "shaders/gather/surfels.comp.h"
#include "shaders/gather/tree_leaves.comp.h"
#include "shaders/gather/tree_nodes.comp.h"
#include "surfels/surfels.h"

namespace opaline::gpu {
class Device;
}

namespace opaline::passes {

/// Gathers irradiance on surfels as they lie in this frame, and fits their tree to it. Topology and
/// order stay those of the rest pose.
class SurfelPass {
 public:
  explicit SurfelPass(gpu::Device& device);

  /// `keepsTriangles`: Surfels::triangleOfPiece. For set-up, not for frames.
  static Surfels makeSurfels(gpu::Device& device, const surfels::SurfelDivision& made,
                             const core::RestSurface& surface, bool keepsTriangles = false,
                             const surfels::Linings& linings = {});

  /// Makes room for the visibility of that many lights. For set-up, not for frames.
  static void makeRoomForLights(gpu::Device& device, std::uint32_t lights, Surfels& surfels);

  struct Inputs {
    FrameView& frame;
    DeformedMesh& mesh;
    SceneTables& tables;
    ShadowMaps& shadows;
    Sky& sky;
    bool keepsVisibility;  ///< keeps that of lights, for which there is room
    bool takesSky;         ///< takes all of the sky; else OccludedSkyPass adds the visible part
  };
  void gather(gpu::CommandList& commands, const Inputs& inputs, Surfels& surfels) const;
  /// Fits the tree, leaves first. Has to come after all irradiance has been gathered.
  void fitTree(gpu::CommandList& commands, Surfels& surfels) const;

 private:
  gpu::Sampler nearest_;
  gpu::Sampler linear_;
  Variants<shaders::GatherSurfels> gather_;
  gpu::Compute<shaders::GatherTreeLeaves> leaves_;
  gpu::Compute<shaders::GatherTreeNodes> nodes_;
};

}  // namespace opaline::passes
