#include "renderer/frame/shape_reuse.h"

namespace opaline {

bool ShapeReuse::mustFind(const RenderOptions& options, const FramePlan& plan, bool reuse,
                          const SceneChanges& changes) {
  Shape now{changes,
            options.transport,
            options.tolerance,
            usesClusters(plan),
            sendsRays(plan),
            looksAround(plan),
            looksThrough(plan),
            solves(plan),
            entersFromEverywhere(plan)};
  now.changes.lights = 0;
  if (reuse && shape_ == now) return false;
  shape_ = now;
  return true;
}

}  // namespace opaline
