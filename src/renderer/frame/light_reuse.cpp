#include "renderer/frame/light_reuse.h"

namespace opaline {

namespace {

// Whether light found for one frame is that of another: all but the camera and what is made of it.
bool holds(const PreparedFrame::Lit& lit, const PreparedFrame::Lit& now) {
  const RenderOptions& a = lit.options;
  const RenderOptions& b = now.options;
  return lit.changes == now.changes && lit.site == now.site && lit.map >= now.map &&
         lit.rays >= now.rays && a.transport == b.transport && a.sum == b.sum &&
         a.tolerance == b.tolerance && a.bounces == b.bounces;
}

}  // namespace

bool LightReuse::mustFind(const RenderOptions& options, const FramePlan& plan,
                          const SceneChanges& changes, PreparedFrame& frame) {
  const bool rays = plan.mirrorsSky || plan.transport == Transport::Boundary;
  const PreparedFrame::Lit now{options, changes, plan.site, plan.map, rays};
  const bool readsSurfels = rays || (options.sum != Sum::Pattern && plan.site != Site::Vertex);
  const bool there = !readsSurfels || litSurfels_ == &frame;
  if (options.reuseLight && there && frame.lit && holds(*frame.lit, now)) return false;
  if (!plan.scatter) return true;  // leaves the light that was there
  frame.lit = now;
  if (options.sum != Sum::Pattern) litSurfels_ = &frame;
  return true;
}

}  // namespace opaline
