#pragma once

#include "opaline/render_options.h"

namespace opaline::test {

/// Frames that take next to no time, since there is one for each call that fails.
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
