#pragma once

#include "gpu/command_list.h"
#include "paper/technique.h"
#include "passes/products.h"
#include "passes/scatter/nearby_pass.h"
#include "passes/scatter/opaque_lights_pass.h"
#include "passes/scatter/opaque_pass.h"
#include "passes/scatter/surfel_sum_pass.h"
#include "renderer/frame/frame_plan.h"
#include "renderer/frame/frame_resources.h"
#include "renderer/frame/passes.h"
#include "renderer/scene/scene_resources.h"

namespace opaline {

/// What every step of a frame needs, and arguments that several steps pass on.
struct FrameContext {
  gpu::CommandList& commands;
  const Passes& passes;
  const FramePlan& plan;
  SceneResources& scene;
  FrameResources& resources;

  passes::CutOuts cutOuts() const;
  passes::SeenSurfaces seen() const;
  passes::BodiesBetween bodiesBetween() const;
  passes::OpaquePass::Inputs ofOpaque() const;
  passes::OpaqueLightsPass::Inputs onOpaque() const;
  passes::NearbyPass::Inputs nearbyInputs() const;
  paper::Technique::Frame onPaper() const;

  bool boundary() const;
  bool carries() const;  ///< whether light is carried from clusters to where it is seen
  passes::ScatterSite site() const;
  passes::ScatterTransport transport() const;
  passes::SurfelSumPass::Order order() const;

 private:
  bool wantsEstimate() const;
};

}  // namespace opaline
