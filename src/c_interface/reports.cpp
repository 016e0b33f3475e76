#include <optional>
#include <string_view>
#include <vector>

#include "c_interface/handles.h"
#include "c_interface/status.h"
#include "c_interface/values.h"
#include "opaline/view.h"

namespace opaline::c {

namespace {

void giveDevice(const DeviceDescription& device, OpalineDeviceFacts* to) {
  OpalineDeviceFacts whole{};
  give(device.name, whole.name, sizeof whole.name, "name");
  give(device.type, whole.type, sizeof whole.type, "type");
  give(device.driver, whole.driver, sizeof whole.driver, "driver");
  whole.rayQueries = device.rayQueries ? 1 : 0;
  give(whole, to, "facts");
}

/// The last report, or a new one if a frame has been made since.
const RenderReport& reportOf(OpalineView* view) {
  std::optional<RenderReport>& report = required(view, "view").report;
  if (!report) report = view->view.report();
  return *report;
}

void givePass(const std::vector<PassTime>& passes, std::size_t pass, OpalinePassTime* to) {
  const PassTime& time = oneOf(passes, pass, "pass", "there are");
  give({0, time.name.c_str(), time.milliseconds}, to, "time");
}

}  // namespace
}  // namespace opaline::c

using namespace opaline;
using opaline::c::guarded;
using opaline::c::required;

extern "C" {

OpalineStatus opalineDeviceFacts(size_t device, OpalineDeviceFacts* facts) {
  return guarded([&] { c::giveDevice(c::deviceOf(device), facts); });
}

OpalineStatus opalineFrameReport(const OpalineView* view, OpalineFrameReport* report) {
  return guarded([&] {
    const Frame& frame = required(view, "view").frame;
    c::give({0, frame.milliseconds, frame.provisional ? 1 : 0, frame.passes.size(),
             frame.solutions.size()},
            report, "report");
  });
}

OpalineStatus opalineFramePass(const OpalineView* view, size_t pass, OpalinePassTime* time) {
  return guarded([&] { c::givePass(required(view, "view").frame.passes, pass, time); });
}

OpalineStatus opalineFrameSolution(const OpalineView* view, size_t index,
                                   OpalineSolution* solution) {
  return guarded([&] {
    const Solution& found =
        c::oneOf(required(view, "view").frame.solutions, index, "solution", "there are");
    OpalineSolution whole{};
    whole.steps = found.steps;
    std::copy_n(found.residual.begin(), 3, whole.residual);
    c::give(whole, solution, "solution");
  });
}

OpalineStatus opalineViewReport(OpalineView* view, OpalineViewReport* report) {
  return guarded([&] {
    const RenderReport& made = required(view, "view").report.emplace(view->view.report());
    c::give({.size = 0,
             .transport = static_cast<OpalineTransport>(made.transport),
             .sum = static_cast<OpalineSum>(made.sum),
             .site = static_cast<OpalineSite>(made.site),
             .triangles = made.triangles,
             .vertices = made.vertices,
             .sources = made.sources,
             .clusters = made.clusters,
             .frameMilliseconds = made.frameMilliseconds,
             .dispatches = made.dispatches,
             .barriers = made.barriers,
             .recordings = made.recordings,
             .peakMemoryMegabytes = made.peakMemoryMegabytes,
             .passCount = made.passes.size()},
            report, "report");
  });
}

OpalineStatus opalineViewPass(OpalineView* view, size_t pass, OpalinePassTime* time) {
  return guarded([&] { c::givePass(c::reportOf(view).passes, pass, time); });
}

OpalineStatus opalineViewDevice(OpalineView* view, OpalineDeviceFacts* facts) {
  return guarded([&] { c::giveDevice(c::reportOf(view).device, facts); });
}

}  // extern "C"
