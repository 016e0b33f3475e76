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

/// What a handle of a view points to.
struct OpalineView : opaline::c::Handle<OpalineView> {
  OpalineRenderer* renderer;
  opaline::View view;
  opaline::Frame frame;         ///< kept so that collecting allocates nothing
  bool isFrameWaiting = false;  ///< it was collected, but the caller's targets did not fit
  std::optional<opaline::RenderReport> report;  ///< the last that was requested; none if another
                                                ///< frame has been made since
};

struct OpalineSoftBody : opaline::c::Handle<OpalineSoftBody> {
  OpalineRenderer* renderer;
  opaline::SoftBody body;
};

/// What a handle of a renderer points to. Its views and soft bodies are destroyed before the
/// renderer.
struct OpalineRenderer : opaline::c::Handle<OpalineRenderer> {
  opaline::Renderer renderer;
  std::vector<std::size_t> vertexCounts;  ///< of the scene's objects
  std::vector<std::unique_ptr<OpalineView>> views;
  std::vector<std::unique_ptr<OpalineSoftBody>> softBodies;
};

namespace opaline::c {

Aov aovOf(const OpalineAov& given);
/// One of the machine's devices.
DeviceDescription deviceOf(std::size_t index);
/// The order of a frame with these variables; the other options are C's ints.
FrameOrder orderOf(std::vector<Aov> aovs, std::int32_t reuseLight, std::int32_t impatient);
std::vector<Aov> aovsOf(const OpalineAov* aovs, std::size_t count);

/// The view of a handle, for a call that makes a frame: its report becomes outdated.
View& changing(OpalineView* view);

/// The device that a caller gives, in C++.
Given givenOf(const OpalineGivenVulkan& given);

/// Destroys a part that a renderer keeps, if it still exists.
template <typename Part>
void destroyPart(Part* part, std::vector<std::unique_ptr<Part>> OpalineRenderer::*parts) noexcept {
  if (!isLiving(part)) return;
  std::erase_if(part->renderer->*parts,
                [&](const std::unique_ptr<Part>& kept) { return kept.get() == part; });
}

/// Makes a renderer keep a new part, and gives the caller its handle.
template <typename Part>
void keep(Part* made, std::vector<std::unique_ptr<Part>> OpalineRenderer::*parts, Part** to) {
  std::unique_ptr<Part> part(made);
  (made->renderer->*parts).push_back(std::move(part));
  *to = made;
}

}  // namespace opaline::c
