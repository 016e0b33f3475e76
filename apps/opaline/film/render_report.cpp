#include "film/render_report.h"

#include "cli/picture_options.h"

namespace opaline::app {

Json renderReportJson(const RenderReport& report, const RenderOptions& options,
                      const std::vector<std::string>& outputs) {
  Json passes = Json::array();
  for (const PassTime& pass : report.passes) {
    passes.push_back({{"name", pass.name}, {"ms", pass.milliseconds}});
  }
  Json solutions = Json::array();
  for (const Solution& solution : report.solutions) {
    solutions.push_back({{"steps", solution.steps}, {"residual", solution.residual}});
  }
  return {{"device", deviceJson(report.device)},
          {"size", {options.width, options.height}},
          {"transport", options::nameOf(report.transport)},
          {"sum", options::nameOf(report.sum)},
          {"site", options::nameOf(report.site)},
          {"triangles", report.triangles},
          {"vertices", report.vertices},
          {"sources", report.sources},
          {"clusters", report.clusters},
          {"solutions", std::move(solutions)},
          {"passes", std::move(passes)},
          {"frame_ms", report.frameMilliseconds},
          {"dispatches", report.dispatches},
          {"barriers", report.barriers},
          {"recordings", report.recordings},
          {"peak_memory_mb", report.peakMemoryMegabytes},
          {"outputs", outputs}};
}

}  // namespace opaline::app
