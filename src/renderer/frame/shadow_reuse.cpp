#include "renderer/frame/shadow_reuse.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include <glm/vec3.hpp>

namespace opaline {

namespace {

// Whether two lights cast the same shadows, whatever their brightness.
bool castsAlike(const shared::LightData& a, const shared::LightData& b) {
  return a.kind == b.kind && glm::vec3(a.place) == glm::vec3(b.place) && a.axis == b.axis &&
         a.cone == b.cone;
}

}  // namespace

passes::ShadowViews shadowsToDraw(const FramePlan& plan, bool reuse, const SceneChanges& changes,
                                  const shared::FrameData& frame, ViewResources& view) {
  passes::ShadowViews views;
  if (!plan.light || !drawsShadows(plan)) return views;
  ViewResources::Shadows now{changes.withoutLight(), {}};
  std::copy_n(frame.lights, now.lights.size(), now.lights.begin());
  const auto before = std::exchange(view.shadows, now);
  const bool kept = reuse && before && before->changes == now.changes;
  for (std::uint32_t i = 0; i < frame.counts.x; ++i) {
    const shared::LightData& light = now.lights[i];
    if (kept && castsAlike(before->lights[i], light)) continue;
    for (std::uint32_t k = 0; k < light.kind.z; ++k) views.set(light.kind.y + k);
  }
  return views;
}

}  // namespace opaline
