#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "gpu/command_list.h"
#include "gpu/transfer.h"
#include "opaline/renderer.h"
#include "paper/technique.h"
#include "passes/boundary/beam_pass.h"
#include "passes/boundary/carry_pass.h"
#include "passes/boundary/cluster_pass.h"
#include "passes/boundary/occluded_sky_pass.h"
#include "passes/boundary/ray_pass.h"
#include "passes/boundary/solver_pass.h"
#include "passes/deform/deform_pass.h"
#include "passes/gather/area_light_pass.h"
#include "passes/gather/fit_pass.h"
#include "passes/gather/shadow_pass.h"
#include "passes/gather/surfel_pass.h"
#include "passes/scatter/interpolation_pass.h"
#include "passes/scatter/nearby_pass.h"
#include "passes/scatter/opaque_lights_pass.h"
#include "passes/scatter/opaque_pass.h"
#include "passes/scatter/paint_pass.h"
#include "passes/scatter/surface_pass.h"
#include "passes/scatter/surfel_sum_pass.h"
#include "passes/shade/backdrop_pass.h"
#include "passes/shade/centres_pass.h"
#include "passes/shade/mirrored_scene_pass.h"
#include "passes/shade/own_surface_pass.h"
#include "passes/shade/reflected_lights_pass.h"
#include "passes/shade/reflected_sky_pass.h"
#include "passes/shade/seen_irradiance_pass.h"
#include "passes/shade/seen_surfels_pass.h"
#include "passes/shade/shade_pass.h"
#include "passes/sky/sky_pass.h"
#include "renderer/frame/frame_plan.h"
#include "renderer/frame/frame_resources.h"
#include "renderer/motion/scene_motion.h"
#include "renderer/scene/scene_resources.h"

namespace opaline {

/// The passes' pipelines, made once for a device.
struct Passes {
  explicit Passes(gpu::Device& device);

  passes::DeformPass deform;
  passes::FitPass fit;
  passes::ShadowPass shadow;
  passes::SurfelPass surfels;
  passes::AreaLightPass areaLights;
  passes::SurfacePass surface;
  passes::SurfelSumPass sum;
  passes::InterpolationPass interpolation;
  passes::NearbyPass nearby;
  passes::OpaquePass opaque;
  passes::OpaqueLightsPass opaqueLights;
  passes::PaintPass paint;
  passes::RayPass rays;
  passes::ClusterPass clusters;
  passes::OccludedSkyPass occludedSky;
  passes::BeamPass beams;
  passes::SolverPass solver;
  passes::CarryPass carry;
  passes::SkyPass sky;
  passes::OwnSurfacePass ownSurfaces;
  passes::MirroredScenePass mirroredScene;
  passes::ReflectedSkyPass reflectedSky;
  passes::ReflectedLightsPass reflectedLights;
  passes::ShadePass shade;
  passes::BackdropPass backdrop;
  passes::CentresPass centres;
  passes::SeenSurfelsPass seenSurfels;
  passes::SeenIrradiancePass seenIrradiance;
  std::unique_ptr<const paper::Technique> paper;  ///< none until a frame needs it
};

/// What the host sets for a frame, in memory that the device reads.
struct FrameUpload {
  gpu::Buffer& buffer;
  std::size_t offset;  ///< of a shared::FrameData, see passes::FitPass
};

/// Records one frame: the surface where it is at that time, shadows, gathering, scattering at
/// vertices, all of which a plan without `light` leaves out, then the surfaces that pixels see,
/// scattering at fragments and shading, for one band of the picture after the other. A plan that
/// does not `scatter` leaves the exitance as it was.
void recordFrame(gpu::CommandList& commands, const Passes& passes, const FramePlan& plan,
                 const FrameUpload& upload, SceneMotion& motion, SceneResources& scene,
                 FrameResources& resources);

}  // namespace opaline
