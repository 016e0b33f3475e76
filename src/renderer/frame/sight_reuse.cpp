#include "renderer/frame/sight_reuse.h"

#include <cstdint>
#include <optional>
#include <utility>

namespace opaline {

bool mustFindSight(const RenderOptions& options, const FramePlan& plan, bool reuse,
                   const SceneChanges& changes, const CameraView& camera, ViewResources& view) {
  if (plan.centre) view.sight.reset();  // centres overwrite the same memory
  if (plan.samples == 0) return true;
  const ViewResources::Sight now{changes.withoutLight(), camera,          options.antialias,
                                 plan.roughness,         plan.mirrorsSky, plan.backdrop};
  const auto before = std::exchange(view.sight, now);
  // With several bands, the memory holds only the last. A backdrop needs what each sample sees,
  // which the list of surfaces overwrites; it may show lights, too.
  const auto rows = static_cast<std::uint32_t>(options.height);
  const bool whole = view.made().surfaces.rowsOfBand >= rows;
  return !(reuse && whole && !plan.backdrop && before == now);
}

}  // namespace opaline
