#include "renderer/frame/sight_reuse.h"

#include <cstdint>
#include <optional>
#include <utility>

namespace opaline {

bool mustFindSight(const RenderOptions& options, const FramePlan& plan, bool reuse,
                   const SceneChanges& changes, const CameraView& camera, ViewResources& view) {
  if (plan.centre) view.sight.reset();  // it takes the same room
  if (plan.samples == 0) return true;
  const ViewResources::Sight now{changes.withoutLight(), camera,          options.antialias,
                                 plan.roughness,         plan.mirrorsSky, plan.backdrop};
  const auto before = std::exchange(view.sight, now);
  // Of several bands the room holds the last. A backdrop asks what each sample sees, before a list
  // of surfaces takes the place of that; it may show lights, too.
  const auto rows = static_cast<std::uint32_t>(options.height);
  const bool whole = view.made().surfaces.rowsOfBand >= rows;
  return !(reuse && whole && !plan.backdrop && before == now);
}

}  // namespace opaline
