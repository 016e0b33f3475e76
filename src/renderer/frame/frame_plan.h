#pragma once

#include <cstdint>
#include <vector>

#include "opaline/renderer.h"
#include "opaline/scene.h"
#include "renderer/scene/scene_resources.h"

namespace opaline {

/// What a frame is to do.
struct FramePlan {
  Transport transport = Transport::Dipole;
  Sum sum = Sum::Tree;
  Site site = Site::Fragment;   ///< Auto: as each object has it, not for Sum::Pattern
  bool sumsAtVertices = false;  ///< all of them; opaque bodies have no sums
  float tolerance = 0.01F;      ///< of Sum::Tree, and of the solver of Transport::Boundary
  int bounces = 2;              ///< of Transport::Boundary
  bool skyIsDark = false;       ///< no light but that of lights
  bool ambientOcclusion = false;
  bool occludesSky = false;      ///< by what stands in the way; needs clusters
  std::uint32_t lights = 0;      ///< of all kinds; those with an extent come last
  std::uint32_t areaLights = 0;  ///< with an extent; none for Sum::Pattern
  bool scatter = true;           ///< find the exitance; what is seen without light needs none
  bool map = false;              ///< draw the diffusion source map, whoever wants it
  int samples = 4;               ///< of radiance, 0 for none
  bool centre = false;           ///< leave the visible surface and exitance of the pixels' centres
  bool seenSurfels = false;      ///< find the surfels at the pixels' centres, not for Sum::Pattern
  bool opaque = false;           ///< some bodies are; the view says so
  bool letsThrough = false;      ///< some opaque bodies let light through
  bool painted = false;          ///< some bodies are; the view says so
  bool ownSurfaces = false;      ///< some translucent bodies have a roughness or normals of their
                                 ///< own; the view says so
  bool irradiance = false;       ///< leave that of the pixels' centres; wants seenSurfels but for
                                 ///< Sum::Pattern
  int treeLevel = 0;             ///< of the nodes that hold them
  bool specular = true;
  float roughness = 0.25F;
  SceneTime time;
  bool environmentBehind = false;  ///< what no surface covers shows the sky
  Rgb ambient{};                   ///< of that sky, on top of the environment
  bool visibleLights = false;      ///< the picture itself shows some
  bool backdrop = false;           ///< one of these
  bool mirrorsSky = false;  ///< in the reflection, where the scene leaves it free; else all of it
  bool mirrorsBodies = false;  ///< in that of translucent surfaces, by their own light
  bool light = true;  ///< else the resources hold what this frame's light does, from before
  bool shape = true;  ///< else they hold where everything lies; not without light
  bool sight = true;  ///< else they hold what pixels see, and how much of the sky that mirrors; not
                      ///< without their centres
  passes::ShadowViews shadows;  ///< maps to draw; of the others they hold what this frame needs
};

/// Whether light is found on surfels, what of it needs clusters, and whether it sends rays.
bool onSurfels(const FramePlan& plan);
bool usesClusters(const FramePlan& plan);
bool sendsRays(const FramePlan& plan);

/// Whether light, where it is found, needs shadow maps.
bool drawsShadows(const FramePlan& plan);

/// Whether light in bodies is found by the boundary's equation.
bool solves(const FramePlan& plan);

/// Whether light comes from everywhere to bodies where that is so.
bool entersFromEverywhere(const FramePlan& plan);

/// Whether opaque bodies take light from others and give it back.
bool carriesOpaque(const FramePlan& plan);

/// Whether clusters ask what they see of each other and of the sky.
bool looksAround(const FramePlan& plan);

/// What follows from what is asked for alone. `picture`: the radiance is wanted, whether or not it
/// is among the variables; `exitance`: that of vertices is.
FramePlan planFor(const RenderOptions& options, const FrameOrder& order, bool picture,
                  bool exitance);

/// Whether what the plan makes needs clusters to tell how much of the sky is hidden.
bool occludesSky(const FramePlan& plan, const Lighting& lighting);

/// Whether what the plan makes reflects the sky where the scene leaves it free. The method of 2008
/// knows no surfels that rays could meet, and reflects all of it.
bool mirrorsSky(const FramePlan& plan, const Lighting& lighting);

/// Whether light leaves bodies in directions that depend on where it comes from.
bool leavesByOrigin(const FramePlan& plan);

/// Whether translucent surfaces mirror the light of bodies beside them. A body alone mirrors its
/// own.
bool mirrorsBodies(const FramePlan& plan, const Scene& scene);

/// Whether the picture itself shows some of the lights; or anything where no surface is.
bool showsLights(const FramePlan& plan, const Lighting& lighting);
bool showsBackdrop(const FramePlan& plan, const Lighting& lighting);

/// What depends on the scene as well: the site, and the transport that its objects allow.
void fitToScene(const SceneResources& scene, const Lighting& lighting, FramePlan& plan);

}  // namespace opaline
