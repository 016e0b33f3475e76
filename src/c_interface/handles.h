#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "opaline/opaline_c.h"
#include "opaline/renderer.h"
#include "opaline/view.h"

/// What handles of renderers and views stand for.
struct OpalineRenderer {
  opaline::Renderer renderer;
};

struct OpalineView {
  opaline::View view;
  opaline::Frame frame;          ///< kept, so that collecting allocates nothing
  opaline::RenderReport report;  ///< as it was last asked for, so that names of passes live
};

namespace opaline::c {

Aov aovOf(const OpalineAov& given);
/// One of the machine's.
DeviceDescription deviceOf(std::size_t index);
/// How a frame is ordered beside its variables, in C as ints.
FrameOrder orderOf(std::vector<Aov> aovs, std::int32_t reuseLight, std::int32_t impatient);
std::vector<Aov> aovsOf(const OpalineAov* aovs, std::size_t count);

/// The device that a caller gives, in C++.
Given givenOf(const OpalineGivenVulkan& given);

}  // namespace opaline::c
