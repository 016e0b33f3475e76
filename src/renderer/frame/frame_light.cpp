#include "renderer/frame/frame_light.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace opaline {

namespace {

// The solver's residuals in units of the tolerance. They are less than 1 because visible places may
// be far darker than those where light enters.
constexpr float residualOfLight = 0.3F;
constexpr float residualOfBounce = 1;
// A factor for bodies with linings. Behind opaque things it is darker still, and the light that
// leaves there is a small difference of large sums.
constexpr float residualBehindLinings = 0.1F;

constexpr float widestOpening = 0.5F;

// The opening angle of nodes in sums over clusters. Their error grows with its power of 2.5, so the
// angle follows the tolerance.
float openingAngleOf(float tolerance) {
  return std::clamp(0.25F * std::pow(tolerance / 0.01F, 0.4F), 0.05F, widestOpening);
}

// Light from everywhere is even, and light that enters again is a tenth or two of all light, so a
// larger angle suffices for their points.
float openingAngleOfEverywhere(float ofLight) {
  return std::min(1.4F * ofLight, widestOpening);
}

struct LightOfFrame : FrameContext {
  // All that does not depend on light. Rays from clusters come last: they keep few of a GPU's
  // processors busy, and the next passes do not wait for them.
  void findShape() const {
    if (sendsRays(plan)) passes.rays.record(commands, scene.mesh, scene.surfels, scene.rays);
    if (!usesClusters(plan)) return;
    const passes::ClusterPass::ShapeInputs inputs{scene.mesh,        resources.tables,
                                                  resources.sky,     scene.surfels,
                                                  scene.rays,        openingAngleOf(plan.tolerance),
                                                  looksAround(plan), looksThrough(plan)};
    passes.clusters.recordShape(commands, inputs, scene.clusters);
    if (solves(plan) && keepsCoefficients())
      passes.solver.recordCoefficients(commands, openingAngleOf(plan.tolerance), resources.tables,
                                       scene.clusters, scene.solver);
    passes.clusters.recordSurvey(commands, inputs, scene.clusters);
  }

  void gather() const {
    if (!drawsShadows(plan)) return;
    passes.shadow.record(commands, resources.view, scene.mesh, cutOuts(), plan.shadows,
                         resources.shadows);
    if (onSurfels(plan))
      passes.surfels.gather(commands,
                            {resources.view, scene.mesh, resources.tables, resources.shadows,
                             resources.sky, usesClusters(plan), !plan.occludesSky},
                            scene.surfels);
    findEntries();
    if (onSurfels(plan)) finishSurfels();
    const bool occluded = plan.ambientOcclusion && plan.occludesSky;
    if (plan.map) passes.paper->gather(commands, onPaper(), occluded ? &scene.clusters : nullptr);
  }

  // Clusters read the visibility of lights that surfels have gathered. Surfels read how much of the
  // sky clusters see.
  void findEntries() const {
    const bool areaLights = onSurfels(plan) && plan.areaLights > 0;
    if (areaLights)
      passes.areaLights.record(commands,
                               {resources.view, scene.mesh, resources.tables, scene.rays,
                                plan.lights - plan.areaLights, plan.lights},
                               scene.surfels);
    if (usesClusters(plan))
      passes.clusters.recordEntries(commands,
                                    {resources.view, scene.mesh, resources.tables, resources.sky,
                                     scene.surfels, plan.lights, areaLights, plan.skyIsDark},
                                    scene.clusters);
  }

  void finishSurfels() const {
    if (plan.occludesSky)
      passes.occludedSky.record(commands, resources.tables, resources.sky, scene.clusters,
                                scene.surfels);
    if (plan.painted) passes.paint.overSources(commands, resources.tables.paint, scene.surfels);
    passes.surfels.fitTree(commands, scene.surfels);
  }

  void giveBack(passes::OpaquePass::From from) const {
    if (carriesOpaque(plan))
      passes.opaque.overClusters(commands, ofOpaque(), from, plan.bounces, scene.clusters);
  }

  // Stored coefficients are rounded, which changes a picture by up to 3e-4 of its mean. That is too
  // much for finer tolerances and behind linings.
  bool keepsCoefficients() const {
    constexpr float finestTolerance = 0.002F;
    return plan.tolerance >= finestTolerance && !scene.clusters.haveLinings;
  }

  // Finds the light that leaves through clusters: of light that enters from outside, then of light
  // that leaves and enters again.
  void solveBoundary() const {
    passes::Clusters& clusters = scene.clusters;
    const float openingAngle = openingAngleOf(plan.tolerance);
    const passes::BeamPass::Inputs inputs{
        resources.view,     resources.tables, scene.surfels,
        scene.rays,         openingAngle,     openingAngleOfEverywhere(openingAngle),
        keepsCoefficients()};
    for (int bounce = 0; bounce <= plan.bounces; ++bounce) {
      const bool again = bounce > 0;
      if (again) {
        passes.reentry.record(commands, resources.tables, bounce == 1, clusters);
        const bool isNew = plan.shape && bounce == 1 && plan.skyIsDark;
        passes.beams.recordAgain(commands, inputs, isNew, clusters);
      } else {
        passes.beams.recordLights(
            commands, inputs,
            {.sky = !plan.skyIsDark, .bounces = plan.bounces > 0, .isNew = plan.shape}, clusters);
      }
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
      giveBack(again ? From::Clusters : From::Lights);
      using Bounce = passes::SolverPass::Bounce;
      if (plan.bounces > 1 && bounce > 0 && bounce + 1 >= plan.bounces) {
        const bool isLast = bounce == plan.bounces;
        passes.solver.recordFurtherBounces(commands, isLast ? Bounce::Last : Bounce::LastButOne,
                                           resources.tables, clusters);
        if (isLast) giveBack(From::FurtherBounces);
      }
    }
  }

  // Sums the half-space at the places from which its mean over clusters is computed.
  void meansOverClusters() const {
    using From = passes::CarryPass::From;
    if (plan.sumsAtVertices)
      return passes.carry.recordMeans(commands, From::Vertices, resources.exitance.vertices,
                                      scene.surfels, scene.clusters);
    // Coarse surfels themselves serve as places; fine ones are joined to patches.
    const bool bySurfels = scene.surfels.coarse;
    if (!bySurfels) passes.carry.recordPatches(commands, scene.surfels, scene.clusters);
    const passes::Places places = bySurfels ? passes::surfelsOf(scene.surfels, scene.clusters)
                                            : passes::patchesOf(scene.surfels, scene.clusters);
    passes::SurfelSumPass::Order how = order();
    how.site = passes::ScatterSite::Vertices;
    sumOver(places, Sum::Tree, how);
    passes.carry.recordMeans(commands, bySurfels ? From::Surfels : From::Patches, places.exitances,
                             scene.surfels, scene.clusters);
  }

  void sumOver(const passes::Places& places, Sum sum,
               const passes::SurfelSumPass::Order& how) const {
    const passes::SurfelSumPass::OverPlaces over{resources.tables, scene.surfels, places};
    if (sum == Sum::Tree)
      passes.sum.treeOverPlaces(commands, how, over);
    else
      passes.sum.allOverPlaces(commands, how, over);
    if (scene.surfels.coarse)
      passes.nearby.overPlaces(commands, how.transport, how.site, nearbyInputs(), places);
  }

  passes::Places placesOfVertices() const {
    return passes::verticesOf(scene.mesh, scene.surfels, resources.exitance);
  }

  // Sums the half-space at vertices: all of it if that is the site, else the parts that are always
  // summed there.
  void sumAtVertices() const {
    if (plan.sum == Sum::Pattern) {
      using Part = paper::Technique::VertexPart;
      return passes.paper->scatterAtVertices(
          commands, transport(), plan.site == Site::Vertex ? Part::Everything : Part::FarSamples,
          onPaper());
    }
    if (plan.sum == Sum::Tree || plan.site != Site::Fragment)
      sumOver(placesOfVertices(), plan.sum, order());
  }

  // Adds what the clusters know and that sum lacks.
  void carryToVertices() const {
    if (plan.sum == Sum::Pattern) return;
    const passes::Places vertices = placesOfVertices();
    if (carriesOpaque(plan)) {
      passes.opaque.overVertices(commands, ofOpaque(), site(), vertices);
      if (plan.areaLights > 0 && plan.site != Site::Fragment)
        passes.opaqueLights.overVertices(commands, onOpaque(), site(), vertices);
    }
    if (!carries()) return;
    if (findsMeans(plan)) meansOverClusters();
    if (plan.site != Site::Fragment)
      passes.carry.overVertices(commands, site(), resources.tables, scene.clusters, vertices,
                                resources.exitance.origins);
  }

  void find() const {
    gather();
    if (!plan.scatter) return;
    sumAtVertices();
    if (boundary())
      solveBoundary();
    else if (carriesOpaque(plan))
      giveBack(passes::OpaquePass::From::Lights);
    carryToVertices();
  }
};

}  // namespace

void findShape(const FrameContext& frame) {
  LightOfFrame{frame}.findShape();
}

void findLight(const FrameContext& frame) {
  LightOfFrame{frame}.find();
}

}  // namespace opaline
