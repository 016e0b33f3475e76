#include "renderer/frame/frame.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "renderer/frame/camera_view.h"

namespace opaline {

namespace {

passes::ScatterTransport scatterTransport(Transport transport) {
  return transport == Transport::Dipole ? passes::ScatterTransport::Dipole
                                        : passes::ScatterTransport::BetterDipole;
}

passes::ScatterSite scatterSite(Site site) {
  switch (site) {
    case Site::Vertex:
      return passes::ScatterSite::Vertices;
    case Site::Fragment:
      return passes::ScatterSite::Fragments;
    case Site::Auto:
      break;
  }
  return passes::ScatterSite::PerObject;
}

// The solver's residuals in tolerances: less than 1, because what is seen may be far darker than
// where the light enters.
constexpr float residualOfLight = 0.3F;
constexpr float residualOfBounce = 1;
// Behind opaque things in a body it is darker yet, and that what leaves there is a small difference
// of large sums: as many times less.
constexpr float residualBehindLinings = 0.1F;

constexpr float widestOpening = 0.5F;

// Of nodes in the sums over clusters: their error goes with its square and a half, so that it
// follows the tolerance.
float openingAngleOf(float tolerance) {
  return std::clamp(0.25F * std::pow(tolerance / 0.01F, 0.4F), 0.05F, widestOpening);
}

// Light from everywhere is even, and light that enters again a tenth or two of all, so that their
// points may be taken together from nearer.
float openingAngleOfEverywhere(float ofLight) {
  return std::min(1.4F * ofLight, widestOpening);
}

// What every step of a frame needs.
struct FrameContext {
  gpu::CommandList& commands;
  const Passes& passes;
  const FramePlan& plan;
  passes::DeformedMesh& mesh;
  FrameResources& resources;

  void changeMaterials(SceneResources& scene) const {
    if (!resources.materials) return;
    resources.materials->record(commands, plan.time, scene.opaque, resources.tables);
    if (resources.materials->changesOpaque() && resources.tables.opaqueShares)
      passes.opaque.recordShares(commands, mesh, scene.surfels, scene.clusters, scene.opaque,
                                 resources.tables);
  }

  void fit(const FrameUpload& upload) const {
    passes.fit.record(commands, upload.buffer, upload.offset, mesh, resources.view);
  }

  passes::CutOuts cutOuts(SceneResources& scene) const { return {resources.tables, scene.opaque}; }

  // All that does not ask for light. Rays from clusters come last: they keep few of a GPU's
  // processors busy, and what follows does not wait for them.
  void findShape(SceneResources& scene) const {
    if (sendsRays(plan)) passes.rays.record(commands, mesh, scene.surfels, scene.rays);
    if (!usesClusters(plan)) return;
    const passes::ClusterPass::ShapeInputs inputs{mesh,
                                                  resources.tables,
                                                  resources.sky,
                                                  scene.surfels,
                                                  scene.rays,
                                                  openingAngleOf(plan.tolerance),
                                                  looksAround(plan)};
    passes.clusters.recordShape(commands, inputs, scene.clusters);
    if (solves(plan) && keepsCoefficients(scene))
      passes.solver.recordCoefficients(commands, openingAngleOf(plan.tolerance), resources.tables,
                                       scene.clusters, scene.solver);
    passes.clusters.recordSurvey(commands, inputs, scene.clusters);
  }

  void gather(SceneResources& scene) const {
    if (!onSurfels(plan) && !plan.map) return;
    passes.shadow.record(commands, resources.view, mesh, cutOuts(scene), resources.shadows);
    // Clusters read what is visible of lights from where surfels have gathered it, and surfels how
    // much of the sky is seen from clusters.
    if (onSurfels(plan))
      passes.surfels.gather(commands,
                            {resources.view, mesh, resources.tables, resources.shadows,
                             resources.sky, usesClusters(plan), !plan.occludesSky},
                            scene.surfels);
    findEntries(scene);
    if (onSurfels(plan)) finishSurfels(scene);
    const bool occluded = plan.ambientOcclusion && plan.occludesSky;
    if (plan.map)
      passes.paper->gather(commands, onPaper(scene), occluded ? &scene.clusters : nullptr);
  }

  // Clusters read what is visible of lights from where surfels have gathered it, and surfels how
  // much of the sky is seen from clusters.
  void findEntries(SceneResources& scene) const {
    const bool areaLights = onSurfels(plan) && plan.areaLights > 0;
    if (areaLights)
      passes.areaLights.record(commands,
                               {resources.view, mesh, resources.tables, scene.rays,
                                plan.lights - plan.areaLights, plan.lights},
                               scene.surfels);
    if (usesClusters(plan))
      passes.clusters.recordEntries(commands,
                                    {resources.view, mesh, resources.tables, resources.sky,
                                     scene.surfels, plan.lights, areaLights, plan.skyIsDark},
                                    scene.clusters);
  }

  void finishSurfels(SceneResources& scene) const {
    if (plan.occludesSky)
      passes.occludedSky.record(commands, resources.tables, resources.sky, scene.clusters,
                                scene.surfels);
    if (plan.painted) passes.paint.overSources(commands, resources.tables.paint, scene.surfels);
    passes.surfels.fitTree(commands, scene.surfels);
  }

  paper::Technique::Frame onPaper(SceneResources& scene) const {
    return {resources.view,     mesh,          resources.tables,
            resources.shadows,  resources.sky, resources.surfaces,
            resources.exitance, *scene.flat,   *resources.map};
  }

  passes::ScatterSite site() const { return scatterSite(plan.site); }

  passes::SurfelSumPass::Order order(const SceneResources& scene) const {
    return {scatterTransport(plan.transport), site(), plan.tolerance, wantsEstimate(scene)};
  }

  bool boundary() const { return plan.transport == Transport::Boundary; }
  bool carries() const { return boundary() || carriesOpaque(plan); }

  passes::OpaquePass::Inputs ofOpaque() const {
    return {resources.view, resources.tables, resources.shadows};
  }

  passes::OpaqueLightsPass::Inputs onOpaque(SceneResources& scene) const {
    return {resources.view, resources.tables, scene.surfels, scene.rays, plan.areaLights};
  }

  void giveBack(passes::OpaquePass::From from, SceneResources& scene) const {
    if (carriesOpaque(plan))
      passes.opaque.overClusters(commands, ofOpaque(), from, plan.bounces, scene.clusters);
  }

  // Kept ones are rounded, which moves a picture by up to 3e-4 of its mean: too much for finer
  // tolerances, and behind linings.
  bool keepsCoefficients(const SceneResources& scene) const {
    constexpr float finestTolerance = 0.002F;
    return plan.tolerance >= finestTolerance && !scene.clusters.haveLinings;
  }

  // What leaves through the clusters: of the light that enters from outside, and of what leaves and
  // enters again.
  void solveBoundary(SceneResources& scene) const {
    passes::Clusters& clusters = scene.clusters;
    const float openingAngle = openingAngleOf(plan.tolerance);
    const passes::BeamPass::Inputs inputs{resources.view,
                                          resources.tables,
                                          scene.surfels,
                                          scene.rays,
                                          openingAngle,
                                          openingAngleOfEverywhere(openingAngle),
                                          keepsCoefficients(scene)};
    for (int bounce = 0; bounce <= plan.bounces; ++bounce) {
      const bool again = bounce > 0;
      if (again)
        passes.beams.recordReentry(
            commands, inputs,
            {.isFirst = bounce == 1, .isNew = plan.shape && bounce == 1 && plan.skyIsDark},
            clusters);
      else
        passes.beams.recordLights(
            commands, inputs,
            {.sky = !plan.skyIsDark, .bounces = plan.bounces > 0, .isNew = plan.shape}, clusters);
      const float tolerance = (again ? residualOfBounce : residualOfLight) * plan.tolerance *
                              (clusters.haveLinings ? residualBehindLinings : 1);
      passes.solver.record(commands,
                           {.solution = static_cast<std::uint32_t>(bounce),
                            .openingAngle = openingAngle,
                            .tolerance = tolerance,
                            .adds = again,
                            .isDiffuse = again || !plan.skyIsDark,
                            .keepsCoefficients = inputs.keepsCoefficients},
                           resources.tables, clusters, scene.solver);
      using From = passes::OpaquePass::From;
      giveBack(again ? From::Clusters : From::Lights, scene);
      using Bounce = passes::SolverPass::Bounce;
      if (plan.bounces > 1 && bounce > 0 && bounce + 1 >= plan.bounces) {
        const bool isLast = bounce == plan.bounces;
        passes.solver.recordFurtherBounces(commands, isLast ? Bounce::Last : Bounce::LastButOne,
                                           resources.tables, clusters);
        if (isLast) giveBack(From::FurtherBounces, scene);
      }
    }
  }

  // Under boundary transport nothing but the half-space's detail between clusters is seen, from
  // which most of the errors cancel. Coarse surfels need to know what is negligible.
  bool wantsEstimate(const SceneResources& scene) const {
    constexpr float errorWithout = 0.001F;  // of what is seen, at most
    return !boundary() || scene.surfels.coarse || plan.tolerance < 5 * errorWithout;
  }

  // Sums the half-space where its mean over clusters is taken from.
  void meansOverClusters(SceneResources& scene) const {
    using From = passes::CarryPass::From;
    if (plan.sumsAtVertices)
      return passes.carry.recordMeans(commands, From::Vertices, resources.exitance.vertices,
                                      scene.surfels, scene.clusters);
    // Coarse surfels are as large as what they resolve.
    const bool bySurfels = scene.surfels.coarse;
    if (!bySurfels) passes.carry.recordPatches(commands, scene.surfels, scene.clusters);
    const passes::Places places = bySurfels ? passes::surfelsOf(scene.surfels, scene.clusters)
                                            : passes::patchesOf(scene.surfels, scene.clusters);
    passes::SurfelSumPass::Order how = order(scene);
    how.site = passes::ScatterSite::Vertices;
    sumOver(places, Sum::Tree, how, scene);
    passes.carry.recordMeans(commands, bySurfels ? From::Surfels : From::Patches, places.exitances,
                             scene.surfels, scene.clusters);
  }

  void sumOver(const passes::Places& places, Sum sum, const passes::SurfelSumPass::Order& how,
               SceneResources& scene) const {
    const passes::SurfelSumPass::OverPlaces over{resources.tables, scene.surfels, places};
    if (sum == Sum::Tree)
      passes.sum.treeOverPlaces(commands, how, over);
    else
      passes.sum.allOverPlaces(commands, how, over);
    if (scene.surfels.coarse)
      passes.nearby.overPlaces(commands, how.transport, how.site, nearbyInputs(scene), places);
  }

  passes::Places placesOfVertices(SceneResources& scene) const {
    return passes::verticesOf(mesh, scene.surfels, resources.exitance);
  }

  // The half-space, everything where the site is the vertices; else what is always summed there.
  void sumAtVertices(SceneResources& scene) const {
    if (plan.sum == Sum::Pattern) {
      using Part = paper::Technique::VertexPart;
      return passes.paper->scatterAtVertices(
          commands, scatterTransport(plan.transport),
          plan.site == Site::Vertex ? Part::Everything : Part::FarSamples, onPaper(scene));
    }
    if (plan.sum == Sum::Tree || plan.site != Site::Fragment)
      sumOver(placesOfVertices(scene), plan.sum, order(scene), scene);
  }

  // What that sum has not.
  void carryToVertices(SceneResources& scene) const {
    if (plan.sum == Sum::Pattern) return;
    const passes::Places vertices = placesOfVertices(scene);
    if (carriesOpaque(plan)) {
      passes.opaque.overVertices(commands, ofOpaque(), site(), vertices);
      if (plan.areaLights > 0 && plan.site != Site::Fragment)
        passes.opaqueLights.overVertices(commands, onOpaque(scene), site(), vertices);
    }
    if (!carries()) return;
    if (boundary()) meansOverClusters(scene);
    if (plan.site != Site::Fragment)
      passes.carry.overVertices(commands, site(), resources.tables, scene.clusters, vertices,
                                resources.exitance.origins);
  }

  passes::SeenSurfaces seen() const { return {resources.view, mesh, resources.surfaces}; }

  // The sum of the half-space.
  void sumWhereAsked(passes::Asked asked, SceneResources& scene) const {
    const passes::SurfelSumPass::Fragments over{resources.tables, scene.surfels, seen(),
                                                resources.exitance, asked};
    if (plan.sum == Sum::Tree)
      passes.sum.treeOverFragments(commands, order(scene), over);
    else
      passes.sum.allOverFragments(commands, order(scene), over);
  }

  passes::InterpolationPass::Inputs between(std::uint32_t firstRow, SceneResources& scene) const {
    return {resources.tables, scene.surfels, resources.exitance, firstRow, site(), plan.tolerance};
  }

  void scatterAtFragments(SceneResources& scene) const {
    passes::Surfels& surfels = scene.surfels;
    sumWhereAsked(passes::Asked::Knots, scene);
    if (surfels.coarse)
      passes.nearby.overFragments(commands, scatterTransport(plan.transport), site(),
                                  nearbyInputs(scene), seen());
  }

  passes::NearbyPass::Inputs nearbyInputs(SceneResources& scene) const {
    return {resources.view, resources.tables, resources.shadows,
            resources.sky,  scene.surfels,    scene.opaque};
  }

  void findSurfels(SceneResources& scene) const {
    // Clusters come with the rays, here or in the frame whose light is taken.
    if (!usesClusters(plan)) passes.rays.record(commands, mesh, scene.surfels, scene.rays);
    passes.rays.recordBoxes(commands, scene.surfels, scene.rays);
    passes.seenSurfels.record(
        commands,
        {resources.tables, resources.centres, scene.surfels, scene.rays,
         boundary() ? &scene.clusters : nullptr, static_cast<std::uint32_t>(plan.treeLevel)},
        resources.seenSurfels);
  }

  void showIrradiance(SceneResources& scene) const {
    if (plan.sum == Sum::Pattern)
      passes.paper->showIrradiance(commands, onPaper(scene), resources.seenIrradiance);
    else
      passes.seenIrradiance.record(commands, resources.seenSurfels, scene.surfels,
                                   resources.seenIrradiance);
  }

  bool atFragments() const { return plan.scatter && plan.site != Site::Vertex; }
  bool onSurfelsAtFragments() const { return atFragments() && plan.sum != Sum::Pattern; }

  void carryWhereAsked(passes::Asked asked, SceneResources& scene) const {
    passes.carry.overFragments(commands, resources.tables, scene.clusters, asked, seen());
  }

  // The surfaces of a band of the picture, and what is summed there.
  void findSurfaces(std::uint32_t firstRow, int samples, SceneResources& scene) const {
    passes.surface.list(commands, seen(), firstRow, static_cast<std::uint32_t>(samples));
    const bool interpolates = plan.sum == Sum::Tree;
    if (onSurfelsAtFragments()) {
      passes.interpolation.listKnots(commands, between(firstRow, scene),
                                     static_cast<std::uint32_t>(samples), interpolates, seen());
      scatterAtFragments(scene);
    } else if (atFragments()) {
      passes.paper->scatterAtFragments(commands, scatterTransport(plan.transport), onPaper(scene));
    }
    if (carriesOpaque(plan)) {
      passes.opaque.overFragments(commands, ofOpaque(), scene.opaque, site(), seen());
      using Side = passes::OpaqueLightsPass::Side;
      if (plan.areaLights > 0 && atFragments())
        passes.opaqueLights.overFragments(commands, onOpaque(scene), site(), Side::Seen, firstRow,
                                          seen());
      if (plan.letsThrough && atFragments()) {
        passes.opaque.behindFragments(commands, ofOpaque(), scene.clusters, seen());
        if (plan.areaLights > 0)
          passes.opaqueLights.overFragments(commands, onOpaque(scene), site(), Side::Other,
                                            firstRow, seen());
      }
    }
    if (!onSurfelsAtFragments()) return;
    if (carries()) carryWhereAsked(passes::Asked::Knots, scene);
    using Blocks = passes::InterpolationPass::Blocks;
    for (const Blocks blocks : {Blocks::Wide, Blocks::Narrow}) {
      if (!interpolates) break;
      passes.interpolation.interpolate(commands, between(firstRow, scene), blocks, seen());
      const passes::Asked asked =
          blocks == Blocks::Wide ? passes::Asked::InWideBlocks : passes::Asked::InNarrowBlocks;
      sumWhereAsked(asked, scene);
      if (carries()) carryWhereAsked(asked, scene);
    }
    if (plan.painted)
      passes.paint.overFragments(commands, resources.tables, scene.opaque, carries(), seen());
  }

  void shade(std::uint32_t firstRow, SceneResources& scene) const {
    if (plan.ownSurfaces)
      passes.ownSurfaces.record(commands, resources.tables, scene.opaque, plan.roughness, seen());
    if (plan.mirrorsSky)
      passes.reflectedSky.record(commands,
                                 {resources.tables, scene.surfels, scene.rays,
                                  static_cast<std::uint32_t>(plan.samples), plan.roughness},
                                 firstRow, seen());
    const passes::ShadePass::Inputs inputs{
        resources.tables, resources.shadows, resources.exitance, resources.sky, plan.roughness,
        atFragments(), plan.specular, plan.mirrorsSky, plan.mirrorsBodies,
        // Jensen et al. 2001, Eq. 5.
        plan.transport == Transport::Dipole, leavesByOrigin(plan)};
    if (plan.specular && (carriesOpaque(plan) || plan.mirrorsBodies))
      passes.mirroredScene.record(commands,
                                  {resources.tables, scene.surfels, scene.rays, scene.clusters,
                                   plan.mirrorsBodies, boundary(), plan.roughness},
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

  void makePicture(SceneResources& scene) const {
    commands.prepare(resources.radiance,
                     plan.backdrop ? gpu::Access::StorageWrite : gpu::Access::TransferWrite);
    passes.surface.draw(commands, seen(), cutOuts(scene), samplePattern(plan.samples),
                        {.backdrop = plan.backdrop, .lights = plan.visibleLights});
    beginPicture();
    passes::forEachBand(resources.surfaces, [&](std::uint32_t firstRow) {
      findSurfaces(firstRow, plan.samples, scene);
      shade(firstRow, scene);
    });
  }

  void lookAtCentres(SceneResources& scene) const {
    passes::SeenCentres& centres = resources.centres;
    passes.surface.draw(commands, seen(), cutOuts(scene), samplePattern(1), {});
    for (gpu::GpuImage* image : {&centres.position, &centres.normal, &centres.exitance})
      commands.clear(*image);
    passes::forEachBand(resources.surfaces, [&](std::uint32_t firstRow) {
      findSurfaces(firstRow, 1, scene);
      passes.centres.record(commands, seen(), resources.tables, resources.exitance, atFragments(),
                            centres);
    });
    if (plan.seenSurfels) findSurfels(scene);
    if (plan.irradiance) showIrradiance(scene);
  }
};

}  // namespace

void recordFrame(gpu::CommandList& commands, const Passes& passes, const FramePlan& plan,
                 const FrameUpload& upload, SceneMotion& motion, SceneResources& scene,
                 FrameResources& resources) {
  assert(plan.site != Site::Auto || plan.sum != Sum::Pattern);
  assert(plan.map || plan.sum != Sum::Pattern);
  assert(!plan.seenSurfels || (plan.centre && plan.sum != Sum::Pattern));
  assert(!plan.seenSurfels || plan.scatter || plan.irradiance);
  assert(!plan.irradiance || plan.centre);
  assert(plan.samples == 0 || plan.scatter);
  assert(plan.light || !plan.shape);
  const FrameContext context{commands, passes, plan, scene.mesh, resources};
  if (plan.light) context.changeMaterials(scene);
  if (plan.shape) motion.record(commands, passes.deform, plan.time, scene.mesh);
  context.fit(upload);
  if (plan.shape) context.findShape(scene);
  if (plan.light) context.gather(scene);
  if (plan.light && plan.scatter) {
    context.sumAtVertices(scene);
    if (plan.transport == Transport::Boundary)
      context.solveBoundary(scene);
    else if (carriesOpaque(plan))
      context.giveBack(passes::OpaquePass::From::Lights, scene);
    context.carryToVertices(scene);
  }

  // What the picture's pixels see stays, for whoever composes it with something else.
  if (plan.centre) context.lookAtCentres(scene);
  if (plan.samples > 0) context.makePicture(scene);
}

}  // namespace opaline
