#include "renderer/scene/prepared_scene.h"

#include <utility>

#include "gpu/device.h"
#include "renderer/frame/frame.h"
#include "renderer/frame/light_views.h"

namespace opaline {

namespace {

// The half-spaces' integral is over all of the surface. The surface of what boundary transport
// solves has no parts within others, unless these may move apart.
bool keepsOverlaps(const RenderOptions& options, const EditedScene& scene) {
  return options.transport != Transport::Boundary || scene.partsMove();
}

}  // namespace

PreparedScene::PreparedScene(gpu::Device& device, Passes& passes, LogCallback log)
    : device_(device), passes_(passes), log_(std::move(log)) {}

void PreparedScene::prepare(const RenderOptions& options, const FramePlan& plan, bool patient,
                            EditedScene& scene) {
  const Lighting& lighting = scene.lighting();
  const SceneNeeds needs = needsOf(options, plan, scene);
  if (!resources_ || resources_->needs != needs || hasOtherSolids(scene))
    make(scene, needs, options.site);
  else
    followMedia(scene, patient);
  if (needs.maxClusters || !lighting.areas.empty()) followLights(lightCount(lighting));
  if (plan.map) layFlat(options.dsmSize);
  // Clusters may exist only for the occlusion of the sky, without coefficients.
  if (solves(plan) && !resources_->solver.coefficients) {
    passes::SolverPass::makeCoefficients(device_, resources_->clusters, resources_->solver);
    passes::BeamPass::makeCoefficients(device_, resources_->clusters);
  }
  // Most frames do not show surfels, so boxes are made on demand.
  if (plan.seenSurfels && !resources_->rays.boxes)
    resources_->rays = passes::RayPass::makeBoxes(device_, resources_->surfels);
}

bool PreparedScene::fits(const RenderOptions& options, const FramePlan& plan,
                         const EditedScene& scene) const {
  if (!resources_) return true;
  const auto agree = [](const std::optional<int>& had, const std::optional<int>& wanted) {
    return !had || had == wanted;
  };
  const SceneNeeds wanted = needsOf(options, plan, scene);
  const bool otherOverlaps =
      resources_->within.overlapAtRest && resources_->needs.keepsOverlaps != wanted.keepsOverlaps;
  return !otherOverlaps && agree(resources_->needs.maxSurfels, wanted.maxSurfels) &&
         agree(resources_->needs.maxClusters, wanted.maxClusters);
}

SceneChanges PreparedScene::changes(const EditedScene& scene) const {
  SceneChanges changes = scene.changes();
  changes.whole = made_;
  return changes;
}

void PreparedScene::clear() {
  divider_.forget();
  resources_.reset();
}

SceneNeeds PreparedScene::needsOf(const RenderOptions& options, const FramePlan& plan,
                                  const EditedScene& scene) const {
  const Lighting& lighting = scene.lighting();
  SceneNeeds needs = resources_ ? resources_->needs : SceneNeeds{};
  if (options.transport == Transport::Boundary || occludesSky(plan, lighting))
    needs.maxClusters = options.maxClusters;
  if (plan.opaque && options.sum != Sum::Pattern) needs.maxClusters = options.maxClusters;
  const bool sendsRays = mirrorsSky(plan) || !lighting.areas.empty();
  if (sendsRays && !needs.maxClusters) needs.rays = true;
  if (options.sum != Sum::Pattern || needs.rays || needs.maxClusters)
    needs.maxSurfels = options.maxSurfels;
  // Where no parts overlap, it makes no difference.
  if (!resources_ || !resources_->needs.maxClusters || resources_->within.overlapAtRest)
    needs.keepsOverlaps = keepsOverlaps(options, scene);
  return needs;
}

void PreparedScene::make(EditedScene& scene, const SceneNeeds& needs, Site site) {
  clear();
  made_ = scene.noteMaking();
  resources_ = makeSceneResources(device_, scene.scene(), scene.merged(), needs, log_);
  noteSite(scene.scene(), *resources_, site, log_);
  media_ = scene.changes().media;
  orderDivision(scene);
}

void PreparedScene::followMedia(EditedScene& scene, bool patient) {
  if (media_ != scene.changes().media) {
    takeMedia(device_, scene.scene(), *resources_);
    orderDivision(scene);
  }
  media_ = scene.changes().media;
  if (!isProvisional()) return;
  divider_.want(wanted_, scene.merged(), resources_->within);
  const std::optional<Division> division = divider_.take(patient);
  if (!division || !(division->order == wanted_)) return;
  takeDivision(device_, *division, *resources_);
  scene.noteDivision();  // tables contain the places of surfels
  media_ = scene.changes().media;
}

void PreparedScene::followLights(std::uint32_t lights) {
  resources_->clusters.lights = lights;
  if (lights <= resources_->surfels.lights) return;
  passes::SurfelPass::makeRoomForLights(device_, lights, resources_->surfels);
}

void PreparedScene::orderDivision(const EditedScene& scene) {
  if (resources_->needs.maxSurfels) wanted_ = orderFor(device_, scene.scene(), *resources_);
}

bool PreparedScene::hasOtherSolids(const EditedScene& scene) const {
  return media_ != scene.changes().media && !stillHolds(resources_->within, scene.scene());
}

bool PreparedScene::isProvisional() const {
  return resources_->needs.maxSurfels && !(resources_->divided == wanted_);
}

// Made on demand, as few frames use the paper's method or show its map.
void PreparedScene::layFlat(int mapSize) {
  if (!passes_.paper) passes_.paper = std::make_unique<const paper::Technique>(device_);
  std::optional<paper::FlatScene>& flat = resources_->flat;
  if (flat && flat->mapSize == mapSize) return;
  flat.reset();  // freed before memory for the next is allocated
  flat = paper::Technique::layFlat(device_, surfaceOf(*resources_->merged), mapSize);
}

}  // namespace opaline
