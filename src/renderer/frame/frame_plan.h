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
  Site site = Site::Fragment;   ///< Auto: each object has its own; not for Sum::Pattern
  bool sumsAtVertices = false;  ///< for all objects; opaque bodies have no sums
  float tolerance = 0.01F;      ///< of Sum::Tree, and of the solver of Transport::Boundary
  int bounces = 2;              ///< of Transport::Boundary
  bool skyIsDark = false;       ///< neither environment nor ambient light
  bool ambientOcclusion = false;
  bool occludesSky = false;      ///< whether bodies hide it; needs clusters
  std::uint32_t lights = 0;      ///< of all kinds; those with an extent come last
  std::uint32_t areaLights = 0;  ///< with an extent; none for Sum::Pattern
  bool scatter = true;           ///< find the exitance; what is seen without light needs none
  bool map = false;              ///< draw the diffusion source map
  int samples = 4;               ///< of radiance, 0 for none
  bool centre = false;           ///< leave the visible surface and exitance of the pixels' centres
  bool seenSurfels = false;      ///< find the surfels at the pixels' centres, not for Sum::Pattern
  bool opaque = false;           ///< some bodies are; set by the view
  bool letsThrough = false;      ///< some opaque bodies let light through
  bool painted = false;          ///< some bodies are; set by the view
  bool ownSurfaces = false;  ///< some translucent bodies have a roughness or normals of their own;
                             ///< set by the view
  bool irradiance = false;   ///< leave that of the pixels' centres; needs seenSurfels except for
                             ///< Sum::Pattern
  int treeLevel = 0;         ///< of the nodes that hold the seen surfels
  bool specular = true;
  float roughness = 0.25F;
  SceneTime time;
  bool environmentBehind = false;  ///< pixels that no surface covers show the sky
  Rgb ambient{};                   ///< of that sky, in addition to the environment
  bool visibleLights = false;      ///< the picture itself shows some lights
  bool backdrop = false;           ///< environmentBehind or visibleLights
  bool mirrorsSky = false;  ///< reflections show the sky only where the scene leaves it free; else
                            ///< all of it
  bool mirrorsBodies = false;  ///< reflections of translucent surfaces show bodies, by the light
                               ///< that these emit
  bool light = true;           ///< find it; else the resources still hold this frame's light
  bool shape = true;           ///< find it; else the resources still hold it; only with `light`
  bool sight = true;  ///< find what pixels see; else the resources still hold that and the shares
                      ///< of mirrored sky
  passes::ShadowViews shadows;  ///< maps to draw; the resources still hold the others that this
                                ///< frame needs
};

/// Whether light is found on surfels, whether it needs clusters, and whether it sends rays.
bool onSurfels(const FramePlan& plan);
bool usesClusters(const FramePlan& plan);
bool sendsRays(const FramePlan& plan);

/// Whether clusters find their means of half-spaces: boundary transport carries what differs from
/// them, without it opaque surfaces mirror them.
bool findsMeans(const FramePlan& plan);

/// Whether finding light needs shadow maps.
bool drawsShadows(const FramePlan& plan);

/// Whether the boundary's equation is solved for light in bodies.
bool solves(const FramePlan& plan);

/// Whether bodies also get light from everywhere: the sky's, or light that enters again.
bool entersFromEverywhere(const FramePlan& plan);

/// Whether opaque bodies receive light from others and reflect it.
bool carriesOpaque(const FramePlan& plan);

/// Whether clusters find out what they see of each other and of the sky.
bool looksAround(const FramePlan& plan);
/// Whether light that has gone through a body unscattered may enter another.
bool looksThrough(const FramePlan& plan);

/// What follows from options and order alone. `picture`: the radiance is wanted, whether or not it
/// is among the variables; `exitance`: that of vertices is.
FramePlan planFor(const RenderOptions& options, const FrameOrder& order, bool picture,
                  bool exitance);

/// Whether the plan needs clusters to find how much of the sky is hidden.
bool occludesSky(const FramePlan& plan, const Lighting& lighting);

/// Whether reflections show the sky only where the scene leaves it free. The method of 2008 has no
/// surfels that rays could meet, and reflects all of the sky.
bool mirrorsSky(const FramePlan& plan);

/// Whether light leaves bodies in directions that depend on where it comes from.
bool leavesByOrigin(const FramePlan& plan);

/// Whether surfaces mirror the light of bodies beside them. A single body could only mirror itself,
/// which is left out.
bool mirrorsBodies(const FramePlan& plan, const Scene& scene);

/// Whether the picture shows what is seen through thin parts of bodies.
bool seesThrough(const FramePlan& plan, const passes::SceneTables& tables);

/// Whether the picture itself shows lights, or anything where there is no surface.
bool showsLights(const FramePlan& plan, const Lighting& lighting);
bool showsBackdrop(const FramePlan& plan, const Lighting& lighting);

/// What depends on the scene as well: the site, and the transport that its objects allow.
void fitToScene(const SceneResources& scene, const Lighting& lighting, FramePlan& plan);

}  // namespace opaline
