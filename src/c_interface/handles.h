#pragma once

#include <cstddef>
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
  opaline::Frame frame;  ///< kept, so that collecting allocates nothing
  int width = 0;
  int height = 0;
};

namespace opaline::c {

Aov aovOf(OpalineAov given);
std::vector<Aov> aovsOf(const OpalineAov* aovs, std::size_t count);

/// The device that a caller gives, in C++.
Given givenOf(const OpalineGivenVulkan& given);

}  // namespace opaline::c
