#pragma once

#include "opaline/render_options.h"

namespace opaline::test {

/// Frames that take hardly any time, since one is rendered for each failing call.
inline RenderOptions tinyOptions() {
  RenderOptions options;
  options.width = options.height = 16;
  options.maxSurfels = 1024;
  options.maxClusters = 64;
  options.shadowSize = 64;
  options.antialias = 1;
  return options;
}

}  // namespace opaline::test
