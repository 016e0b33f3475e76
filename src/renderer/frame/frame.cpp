#include "renderer/frame/frame.h"

#include <cassert>

#include "renderer/frame/frame_context.h"
#include "renderer/frame/frame_light.h"
#include "renderer/frame/frame_picture.h"

namespace opaline {

namespace {

void changeMaterials(const FrameContext& frame) {
  passes::SceneTables& tables = frame.resources.tables;
  MaterialMotion* const materials = frame.resources.materials.get();
  if (!materials) return;
  SceneResources& scene = frame.scene;
  materials->record(frame.commands, frame.plan.time, scene.opaque, tables);
  if (materials->changesOpaque() && tables.opaqueShares)
    frame.passes.opaque.recordShares(frame.commands, scene.mesh, scene.surfels, scene.clusters,
                                     scene.opaque, tables);
}

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
  assert(plan.sight || !plan.centre);
  const FrameContext frame{commands, passes, plan, scene, resources};
  if (plan.light) changeMaterials(frame);
  if (plan.shape) motion.record(commands, passes.deform, plan.time, scene.mesh);
  passes.fit.record(commands, upload.buffer, upload.offset, scene.mesh, resources.view);
  if (plan.shape) findShape(frame);
  if (plan.light) findLight(frame);
  // The picture comes last, so that composition finds what its pixels see.
  if (plan.centre) lookAtCentres(frame);
  if (plan.samples > 0) makePicture(frame);
}

}  // namespace opaline
