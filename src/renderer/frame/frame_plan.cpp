#include "renderer/frame/frame_plan.h"

#include <algorithm>

#include "environment/sky.h"
#include "lights/area.h"
#include "renderer/frame/light_views.h"
#include "renderer/frame/readback.h"

namespace opaline {

namespace {

// Whether light in translucent bodies is summed at vertices alone.
bool sumsAtVertices(const FramePlan& plan, const SceneResources& scene) {
  if (plan.site != Site::Auto) return plan.site == Site::Vertex;
  for (std::size_t i = 0; i < scene.objects; ++i)
    if (!scene.isOpaque(i) && !wantsVertices(scene, i)) return false;
  return true;
}

// The requested site; for Auto, the one that all objects agree on, or Auto if they differ.
Site chooseSite(const FramePlan& plan, const SceneResources& scene) {
  // Detail of paint shows only at fragments.
  const bool vertices = plan.site == Site::Vertex;
  if (plan.site != Site::Auto && !(vertices && plan.painted)) return plan.site;
  std::size_t atVertices = 0;
  for (std::size_t i = 0; i < scene.objects; ++i)
    if (wantsVertices(scene, i)) ++atVertices;
  if (atVertices == scene.objects) return Site::Vertex;
  return atVertices == 0 || plan.sum == Sum::Pattern ? Site::Fragment : Site::Auto;
}

}  // namespace

FramePlan planFor(const RenderOptions& options, const FrameOrder& order, bool picture,
                  bool exitance) {
  const auto any = [&](const auto& is) {
    return std::any_of(order.aovs.begin(), order.aovs.end(), is) ||
           std::any_of(order.aovsOnDevice.begin(), order.aovsOnDevice.end(), is);
  };
  const auto asked = [&](Aov aov) { return any([&](Aov other) { return other == aov; }); };
  return {
      .transport = options.transport,
      .sum = options.sum,
      .site = options.site,
      .tolerance = options.tolerance,
      .bounces = options.bounces,
      .ambientOcclusion = options.ambientOcclusion,
      .scatter = picture || exitance || any(needsScattering),
      .map = options.sum == Sum::Pattern || any(showsMap),
      .samples = picture || asked(Aov::Radiance) ? options.antialias : 0,
      .centre = any(needsCentre),
      .seenSurfels = asked(Aov::Surfels) || (asked(Aov::Irradiance) && options.sum != Sum::Pattern),
      .irradiance = asked(Aov::Irradiance),
      .treeLevel = options.treeLevel,
      .specular = options.specular,
      .roughness = options.roughness,
      .environmentBehind = options.environmentBehind};
}

bool onSurfels(const FramePlan& plan) {
  return plan.sum != Sum::Pattern && (plan.scatter || plan.irradiance);
}

bool drawsShadows(const FramePlan& plan) {
  return onSurfels(plan) || plan.map;
}

bool carriesOpaque(const FramePlan& plan) {
  return plan.opaque && plan.sum != Sum::Pattern && plan.scatter;
}

bool solves(const FramePlan& plan) {
  return plan.transport == Transport::Boundary && plan.scatter;
}

bool entersFromEverywhere(const FramePlan& plan) {
  return solves(plan) && (!plan.skyIsDark || plan.bounces > 0);
}

bool usesClusters(const FramePlan& plan) {
  return solves(plan) || carriesOpaque(plan) ||
         (plan.occludesSky && (onSurfels(plan) || plan.ambientOcclusion));
}

bool sendsRays(const FramePlan& plan) {
  return usesClusters(plan) || (onSurfels(plan) && plan.areaLights > 0) ||
         (plan.scatter && plan.mirrorsSky);
}

bool findsMeans(const FramePlan& plan) {
  return solves(plan) || (carriesOpaque(plan) && plan.mirrorsSky);
}

bool looksAround(const FramePlan& plan) {
  return usesClusters(plan) && (plan.bounces > 0 || plan.occludesSky || carriesOpaque(plan));
}

bool looksThrough(const FramePlan& plan) {
  return looksAround(plan) && plan.bounces > 0;
}

bool occludesSky(const FramePlan& plan, const Lighting& lighting) {
  return !skyIsDark(lighting) && (plan.transport == Transport::Boundary || plan.ambientOcclusion);
}

// Where it is no sky that surfaces mirror, it is themselves, whatever the sky is.
bool mirrorsSky(const FramePlan& plan) {
  return plan.samples > 0 && plan.specular && plan.sum != Sum::Pattern;
}

bool leavesByOrigin(const FramePlan& plan) {
  return plan.transport == Transport::Boundary && plan.samples > 0;
}

bool mirrorsBodies(const FramePlan& plan, const Scene& scene) {
  return mirrorsSky(plan) && scene.objects.size() > 1 &&
         (plan.opaque || plan.transport == Transport::Boundary);
}

bool seesThrough(const FramePlan& plan, const passes::SceneTables& tables) {
  return solves(plan) && plan.samples > 0 && tables.haveThinParts;
}

bool showsLights(const FramePlan& plan, const Lighting& lighting) {
  return plan.samples > 0 && std::any_of(lighting.areas.begin(), lighting.areas.end(), isVisible);
}

bool showsBackdrop(const FramePlan& plan, const Lighting& lighting) {
  return plan.samples > 0 && (plan.environmentBehind || showsLights(plan, lighting));
}

void fitToScene(const SceneResources& scene, const Lighting& lighting, FramePlan& plan) {
  plan.site = chooseSite(plan, scene);
  plan.sumsAtVertices = sumsAtVertices(plan, scene);
  plan.letsThrough = scene.anyLetsLightThrough();
  plan.skyIsDark = skyIsDark(lighting);
  plan.occludesSky = occludesSky(plan, lighting);
  plan.lights = lightCount(lighting);
  plan.areaLights = static_cast<std::uint32_t>(lighting.areas.size());
  plan.ambient = lighting.ambient;
  plan.visibleLights = showsLights(plan, lighting);
  plan.backdrop = showsBackdrop(plan, lighting);
  // Without any inside, boundary transport is the better dipole, unless opaque bodies need its
  // bounces.
  if (plan.transport == Transport::Boundary && !scene.hasInside() && !plan.opaque)
    plan.transport = Transport::BetterDipole;
  plan.mirrorsBodies = plan.mirrorsBodies && (plan.opaque || plan.transport == Transport::Boundary);
  plan.mirrorsSky = mirrorsSky(plan);
}

}  // namespace opaline
