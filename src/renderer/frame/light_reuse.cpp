#include "renderer/frame/light_reuse.h"

namespace opaline {

namespace {

// Whether the light of one frame is that of another: whether all is equal except the camera and
// what depends on it.
bool holds(const ViewResources::Lit& lit, const ViewResources::Lit& now) {
  const RenderOptions& a = lit.options;
  const RenderOptions& b = now.options;
  return lit.changes == now.changes && lit.site == now.site && lit.map >= now.map &&
         lit.rays >= now.rays && lit.means >= now.means && a.transport == b.transport &&
         a.sum == b.sum && a.tolerance == b.tolerance && a.bounces == b.bounces &&
         a.ambientOcclusion == b.ambientOcclusion;
}

}  // namespace

bool LightReuse::mustFind(const RenderOptions& options, const FramePlan& plan, bool reuse,
                          const SceneChanges& changes, ViewResources& view) {
  const bool rays = sendsRays(plan);
  const ViewResources::Lit now{options, changes, plan.site, plan.map, rays, findsMeans(plan)};
  const bool hasSurfels = options.sum != Sum::Pattern;
  const bool readsSurfels = rays || (hasSurfels && (plan.site != Site::Vertex || plan.irradiance));
  const bool there = !readsSurfels || litSurfels_ == &view;
  if (reuse && there && view.lit && holds(*view.lit, now)) return false;
  if (!plan.scatter) {  // only what surfels have gathered changes; other light stays
    if (hasSurfels && plan.irradiance) litSurfels_ = nullptr;
    return true;
  }
  view.lit = now;
  if (hasSurfels) litSurfels_ = &view;
  return true;
}

}  // namespace opaline
