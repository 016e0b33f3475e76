#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "c_interface/living.h"
#include "opaline/opaline_c.h"
#include "opaline/renderer.h"
#include "opaline/soft_body.h"
#include "opaline/view.h"

/// What handles of views, soft bodies and renderers stand for.
struct OpalineView : opaline::c::Handle<OpalineView> {
  OpalineRenderer* renderer;
  opaline::View view;
  opaline::Frame frame;         ///< kept, so that collecting allocates nothing
  bool isFrameWaiting = false;  ///< it was collected, but did not fit where it was to go
  std::optional<opaline::RenderReport> report;  ///< as it was last asked for, of the last frame
};

struct OpalineSoftBody : opaline::c::Handle<OpalineSoftBody> {
  OpalineRenderer* renderer;
  opaline::SoftBody body;
};

/// Views and soft bodies go before the renderer that they work with.
struct OpalineRenderer : opaline::c::Handle<OpalineRenderer> {
  opaline::Renderer renderer;
  std::vector<std::size_t> vertexCounts;  ///< of the scene's objects
  std::vector<std::unique_ptr<OpalineView>> views;
  std::vector<std::unique_ptr<OpalineSoftBody>> softBodies;
};

namespace opaline::c {

Aov aovOf(const OpalineAov& given);
/// One of the machine's.
DeviceDescription deviceOf(std::size_t index);
/// How a frame is ordered beside its variables, in C as ints.
FrameOrder orderOf(std::vector<Aov> aovs, std::int32_t reuseLight, std::int32_t impatient);
std::vector<Aov> aovsOf(const OpalineAov* aovs, std::size_t count);

/// A view whose frames change, and with them its report.
View& changing(OpalineView* view);

/// The device that a caller gives, in C++.
Given givenOf(const OpalineGivenVulkan& given);

/// Takes a part of a renderer out of what it keeps, if it is still there.
template <typename Part>
void destroyPart(Part* part, std::vector<std::unique_ptr<Part>> OpalineRenderer::*parts) noexcept {
  if (!isLiving(part)) return;
  std::erase_if(part->renderer->*parts,
                [&](const std::unique_ptr<Part>& kept) { return kept.get() == part; });
}

/// Makes a renderer keep a new part of it, and gives that to the caller.
template <typename Part>
void keep(Part* made, std::vector<std::unique_ptr<Part>> OpalineRenderer::*parts, Part** to) {
  std::unique_ptr<Part> part(made);
  (made->renderer->*parts).push_back(std::move(part));
  *to = made;
}

}  // namespace opaline::c
