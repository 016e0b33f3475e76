#pragma once

#include <string>
#include <vector>

#include "cli/json.h"
#include "cli/motion_options.h"
#include "opaline/renderer.h"

namespace opaline::app {

/// What `render --report` writes.
Json renderReportJson(const RenderReport& report, const RenderOptions& options,
                      const std::vector<std::string>& outputs);

}  // namespace opaline::app
