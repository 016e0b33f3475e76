// The host's cost of View::record() for a steady frame: processor time of the calling thread, which
// other programs on the machine hardly change.

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "arguments.h"
#include "caller.h"

namespace opaline::bench {

namespace {

using nlohmann::json;

constexpr int warmUp = 6;

double threadMilliseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Matrices of a caller's orthographic camera that looks along the z axis, in mm.
CameraMatrices matricesAt(float xMm) {
  CameraMatrices made;
  made.worldToView = {1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0, -xMm, 0, 200, 1};
  made.viewToClip = {0.02F, 0, 0, 0, 0, 0.02F, 0, 0, 0, 0, 0.0025F, 0, 0, 0, 0, 1};
  return made;
}

/// The times of some frames in which scene time and camera change.
std::vector<double> timesOf(Renderer& renderer, const RenderOptions& options,
                            const FrameOrder& order, int frames) {
  View view(renderer, options);
  Caller caller(renderer);
  std::vector<double> times;
  for (int i = 0; i < warmUp + frames; ++i) {
    renderer.setTime({.seconds = i / 60.0});
    view.setCamera(matricesAt(0.1F * static_cast<float>(i)));
    const FrameRecording recording = caller.begin();
    const double before = threadMilliseconds();
    view.record(recording, order);
    if (i >= warmUp) times.push_back(threadMilliseconds() - before);
    caller.submit(recording);
  }
  Frame frame;
  for (int i = 0; i < View::framesInFlight; ++i) view.collect(frame);
  return times;
}

void run(int count, char** values) {
  const Arguments arguments = parse("opaline_recording_bench", count, values, 24);
  Renderer renderer({.device = arguments.device});
  Scene scene = loadModel();
  scene.deformers = {{DeformerKind::Twist, 0.5F, 2}};
  renderer.setScene(scene);
  json results = json::array();
  struct Case {
    const char* name;
    Transport transport;
    FrameOrder order;
  };
  const FrameOrder radiance{.aovs = {}, .onDevice = true};
  const FrameOrder all{.aovs = {},
                       .onDevice = true,
                       .exitance = true,
                       .aovsOnDevice = {Aov::Exitance, Aov::Irradiance, Aov::Position, Aov::Normal,
                                        Aov::Depth, Aov::Evaluations, Aov::Object, Aov::Surfels}};
  for (const Case& each : {Case{"boundary", Transport::Boundary, radiance},
                           Case{"boundary, all variables", Transport::Boundary, all},
                           Case{"better dipole", Transport::BetterDipole, radiance}}) {
    RenderOptions options;
    options.width = options.height = 128;  // the size does not matter to the host
    options.site = each.order.exitance ? Site::Vertex : Site::Auto;
    options.transport = each.transport;
    const std::vector<double> times = timesOf(renderer, options, each.order, arguments.frames);
    const double longest = *std::max_element(times.begin(), times.end());
    results.push_back(
        {{"transport", each.name}, {"record_ms", median(times)}, {"longest_ms", longest}});
    if (!arguments.json)
      fmt::print("{}: record() takes {:.3f} ms of the host, median of {}; longest {:.3f}\n",
                 each.name, median(times), times.size(), longest);
  }
  if (arguments.json) fmt::print("{}\n", results.dump(2));
}

}  // namespace

}  // namespace opaline::bench

int main(int count, char** values) {
  return opaline::bench::runMain(opaline::bench::run, count, values);
}
