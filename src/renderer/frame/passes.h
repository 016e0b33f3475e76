#pragma once

#include <memory>

#include "paper/technique.h"
#include "passes/boundary/beam_pass.h"
#include "passes/boundary/carry_pass.h"
#include "passes/boundary/cluster_pass.h"
#include "passes/boundary/occluded_sky_pass.h"
#include "passes/boundary/ray_pass.h"
#include "passes/boundary/reentry_pass.h"
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
#include "passes/shade/seen_through_pass.h"
#include "passes/shade/shade_pass.h"
#include "passes/sky/sky_pass.h"

namespace opaline::gpu {
class Device;
}

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
  passes::ReentryPass reentry;
  passes::SolverPass solver;
  passes::CarryPass carry;
  passes::SkyPass sky;
  passes::OwnSurfacePass ownSurfaces;
  passes::MirroredScenePass mirroredScene;
  passes::ReflectedSkyPass reflectedSky;
  passes::ReflectedLightsPass reflectedLights;
  passes::SeenThroughPass seenThrough;
  passes::ShadePass shade;
  passes::BackdropPass backdrop;
  passes::CentresPass centres;
  passes::SeenSurfelsPass seenSurfels;
  passes::SeenIrradiancePass seenIrradiance;
  std::unique_ptr<const paper::Technique> paper;  ///< null until a frame needs it
};

}  // namespace opaline
