#include "renderer/frame/frame_picture.h"

#include <cstdint>
#include <glm/gtc/type_ptr.hpp>

#include "renderer/frame/camera_view.h"

namespace opaline {

namespace {

struct PictureOfFrame : FrameContext {
  // Sums the half-space at the surfaces in question.
  void sumWhereAsked(passes::Asked asked) const {
    const passes::SurfelSumPass::Fragments over{resources.tables, scene.surfels, seen(),
                                                resources.exitance, asked};
    if (plan.sum == Sum::Tree)
      passes.sum.treeOverFragments(commands, order(), over);
    else
      passes.sum.allOverFragments(commands, order(), over);
  }

  passes::InterpolationPass::Inputs between(std::uint32_t firstRow) const {
    return {resources.tables, scene.surfels, resources.exitance, firstRow, site(), plan.tolerance};
  }

  void scatterAtFragments() const {
    passes::Surfels& surfels = scene.surfels;
    sumWhereAsked(passes::Asked::Knots);
    if (surfels.coarse)
      passes.nearby.overFragments(commands, transport(), site(), nearbyInputs(), seen());
  }

  void findSurfels() const {
    // Clusters have already recorded rays, here or in the frame whose light is reused.
    if (!usesClusters(plan)) passes.rays.record(commands, scene.mesh, scene.surfels, scene.rays);
    passes.rays.recordBoxes(commands, scene.surfels, scene.rays);
    passes.seenSurfels.record(
        commands,
        {resources.tables, resources.centres, scene.surfels, scene.rays,
         boundary() ? &scene.clusters : nullptr, static_cast<std::uint32_t>(plan.treeLevel)},
        resources.seenSurfels);
  }

  void showIrradiance() const {
    if (plan.sum == Sum::Pattern)
      passes.paper->showIrradiance(commands, onPaper(), resources.seenIrradiance);
    else
      passes.seenIrradiance.record(commands, resources.seenSurfels, scene.surfels,
                                   resources.seenIrradiance);
  }

  bool atFragments() const { return plan.scatter && plan.site != Site::Vertex; }

  bool onSurfelsAtFragments() const { return atFragments() && plan.sum != Sum::Pattern; }

  void carryWhereAsked(passes::Asked asked) const {
    passes.carry.overFragments(commands, resources.tables, scene.clusters, asked, seen());
  }

  // Finds the surfaces of a band of the picture and sums light there.
  void findSurfaces(std::uint32_t firstRow, int samples) const {
    if (plan.sight)
      passes.surface.list(commands, seen(), firstRow, static_cast<std::uint32_t>(samples));
    else if (onSurfelsAtFragments())
      passes::SurfacePass::askAnew(commands, resources.surfaces);
    const bool interpolates = plan.sum == Sum::Tree;
    if (onSurfelsAtFragments()) {
      passes.interpolation.listKnots(commands, between(firstRow),
                                     static_cast<std::uint32_t>(samples), interpolates, seen());
      scatterAtFragments();
    } else if (atFragments()) {
      passes.paper->scatterAtFragments(commands, transport(), onPaper());
    }
    if (carriesOpaque(plan)) {
      passes.opaque.overFragments(commands, ofOpaque(), scene.opaque, site(), seen());
      using Side = passes::OpaqueLightsPass::Side;
      if (plan.areaLights > 0 && atFragments())
        passes.opaqueLights.overFragments(commands, onOpaque(), site(), Side::Seen, firstRow,
                                          seen());
      if (plan.letsThrough && atFragments()) {
        passes.opaque.behindFragments(commands, ofOpaque(), seen());
        if (plan.areaLights > 0)
          passes.opaqueLights.overFragments(commands, onOpaque(), site(), Side::Other, firstRow,
                                            seen());
      }
    }
    if (!onSurfelsAtFragments()) return;
    if (carries()) carryWhereAsked(passes::Asked::Knots);
    using Blocks = passes::InterpolationPass::Blocks;
    for (const Blocks blocks : {Blocks::Wide, Blocks::Narrow}) {
      if (!interpolates) break;
      passes.interpolation.interpolate(commands, between(firstRow), blocks, seen());
      const passes::Asked asked =
          blocks == Blocks::Wide ? passes::Asked::InWideBlocks : passes::Asked::InNarrowBlocks;
      sumWhereAsked(asked);
      if (carries()) carryWhereAsked(asked);
    }
    if (plan.painted)
      passes.paint.overFragments(commands, resources.tables, scene.opaque, carries(), seen());
  }

  void shade(std::uint32_t firstRow) const {
    if (plan.ownSurfaces)
      passes.ownSurfaces.record(commands, resources.tables, scene.opaque, plan.roughness, seen());
    if (plan.mirrorsSky && plan.sight)
      passes.reflectedSky.record(commands,
                                 {resources.tables, scene.surfels, scene.rays,
                                  static_cast<std::uint32_t>(plan.samples), plan.roughness},
                                 firstRow, seen());
    const passes::ShadePass::Inputs inputs{
        resources.tables, resources.shadows, resources.exitance, resources.sky, plan.roughness,
        atFragments(), plan.specular, plan.mirrorsSky, plan.mirrorsBodies,
        // Jensen et al. 2001, Eq. 5.
        plan.transport == Transport::Dipole, leavesByOrigin(plan),
        seesThrough(plan, resources.tables)};
    if (plan.specular && (carriesOpaque(plan) || plan.mirrorsBodies))
      passes.mirroredScene.record(commands,
                                  {resources.tables, scene.surfels, scene.rays, scene.clusters,
                                   plan.mirrorsBodies, boundary(), plan.roughness},
                                  firstRow, seen());
    if (inputs.seesThrough)
      passes.seenThrough.record(commands,
                                {resources.tables, scene.surfels, scene.rays, scene.clusters,
                                 resources.backdrop, glm::make_vec3(plan.ambient.data())},
                                firstRow, seen());
    passes.shade.record(commands, inputs, seen());
    if (carriesOpaque(plan)) passes.shade.recordOpaque(commands, inputs, scene.opaque, seen());
    if (plan.specular && plan.areaLights > 0)
      passes.reflectedLights.record(
          commands, {resources.tables, scene.surfels, scene.rays, scene.opaque}, seen());
    passes.shade.sumUp(commands, seen(), resources.radiance);
  }

  void beginPicture() const {
    if (plan.backdrop)
      passes.backdrop.record(commands,
                             {resources.backdrop, plan.ambient,
                              static_cast<std::uint32_t>(plan.samples), plan.environmentBehind},
                             seen(), resources.radiance);
    else
      commands.clear(resources.radiance);
  }

  void makePicture() const {
    commands.prepare(resources.radiance,
                     plan.backdrop ? gpu::Access::StorageWrite : gpu::Access::TransferWrite);
    if (plan.sight)
      passes.surface.draw(commands, seen(), cutOuts(), samplePattern(plan.samples),
                          {.backdrop = plan.backdrop, .lights = plan.visibleLights});
    beginPicture();
    passes::forEachBand(resources.surfaces, [&](std::uint32_t firstRow) {
      findSurfaces(firstRow, plan.samples);
      shade(firstRow);
    });
  }

  void lookAtCentres() const {
    passes::SeenCentres& centres = resources.centres;
    passes.surface.draw(commands, seen(), cutOuts(), samplePattern(1), {});
    for (gpu::GpuImage* image : {&centres.position, &centres.normal, &centres.exitance})
      commands.clear(*image);
    passes::forEachBand(resources.surfaces, [&](std::uint32_t firstRow) {
      findSurfaces(firstRow, 1);
      passes.centres.record(commands, seen(), resources.tables, resources.exitance, atFragments(),
                            centres);
    });
    if (plan.seenSurfels) findSurfels();
    if (plan.irradiance) showIrradiance();
  }
};

}  // namespace

void lookAtCentres(const FrameContext& frame) {
  PictureOfFrame{frame}.lookAtCentres();
}

void makePicture(const FrameContext& frame) {
  PictureOfFrame{frame}.makePicture();
}

}  // namespace opaline
