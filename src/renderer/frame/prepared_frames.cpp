#include "renderer/frame/prepared_frames.h"

#include <algorithm>

#include "gpu/device.h"
#include "renderer/frame/frame.h"
#include "renderer/frame/light_views.h"

namespace opaline {

namespace {

// Of one method, too: each keeps its picture while another one's is made.
bool sameResources(const RenderOptions& a, const RenderOptions& b) {
  return a.width == b.width && a.height == b.height && a.transport == b.transport &&
         a.sum == b.sum && a.site == b.site && a.pattern.nearRings == b.pattern.nearRings &&
         a.pattern.nearSpacing == b.pattern.nearSpacing &&
         a.pattern.farDistance == b.pattern.farDistance && a.shadowSize == b.shadowSize &&
         a.roughness == b.roughness;
}

}  // namespace

PreparedFrames::PreparedFrames(gpu::Device& device, const Passes& passes)
    : device_(device), passes_(passes) {}

PreparedFrame& PreparedFrames::of(const RenderOptions& options, SceneResources& scene,
                                  const Lighting& lighting, const SceneChanges& changes) {
  const auto fits = [&](const Slot& slot) {
    return slot.frame && sameResources(slot.frame->options, options);
  };
  auto found = std::find_if(slots_.begin(), slots_.end(), fits);
  if (found == slots_.end()) {
    found = std::min_element(slots_.begin(), slots_.end(),
                             [](const Slot& a, const Slot& b) { return a.lastUse < b.lastUse; });
    device_.waitIdle();
    found->frame.reset();  // before memory for the next is taken
    found->frame.emplace().options = options;
  }
  found->lastUse = ++uses_;
  PreparedFrame& frame = *found->frame;
  if (frame.whole)
    renew(frame, scene, lighting, changes);
  else
    make(frame, scene, lighting);
  frame.changes = changes;
  return frame;
}

void PreparedFrames::make(PreparedFrame& frame, SceneResources& scene, const Lighting& lighting) {
  keepOnlyPicture(frame.resources);
  frame.whole = false;
  frame.lit.reset();
  makeFrameResources(device_, passes_, scene, lighting, frame.options, frame.resources);
  frame.whole = true;
}

void PreparedFrames::renew(PreparedFrame& frame, SceneResources& scene, const Lighting& lighting,
                           const SceneChanges& changes) {
  const bool media = frame.changes.media != changes.media;
  const bool sky = frame.changes.sky != changes.sky;
  const bool views = frame.resources.view.shadowViews != shadowViewCount(lighting);
  if (media || sky || views) device_.waitIdle();
  if (media) {
    frame.resources.map.reset();  // its neighbourhoods reach as far as their patterns
    remakeTables(device_, scene, frame.options, frame.resources);
  }
  if (sky) remakeSky(device_, passes_, lighting, frame.options, frame.resources);
  if (views) remakeShadows(device_, lighting, frame.options, frame.resources);
}

void PreparedFrames::dropMaps() {
  for (Slot& slot : slots_)
    if (slot.frame) slot.frame->resources.map.reset();
}

void PreparedFrames::clear() {
  for (Slot& slot : slots_) {
    if (!slot.frame) continue;
    keepOnlyPicture(slot.frame->resources);
    slot.frame->whole = false;
    slot.frame->lit.reset();
  }
}

}  // namespace opaline
