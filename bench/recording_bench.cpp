// What View::record() of a steady frame takes of the host: processor time of the calling thread,
// which other programs on the machine change little.

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

/// Of each of some frames, in which time and camera move.
std::vector<double> timesOf(Renderer& renderer, const Scene& scene, const RenderOptions& options,
                            int frames) {
  View view(renderer, options);
  Caller caller(renderer);
  const FrameOrder order{.aovs = {}, .onDevice = true};
  std::vector<double> times;
  for (int i = 0; i < warmUp + frames; ++i) {
    renderer.setTime({.seconds = i / 60.0});
    Camera camera = scene.camera;
    camera.positionMm[0] += 0.1F * static_cast<float>(i);
    view.setCamera(camera);
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
  for (const Transport transport : {Transport::Boundary, Transport::BetterDipole}) {
    RenderOptions options;
    options.width = options.height = 128;  // the host does not care
    options.transport = transport;
    const std::vector<double> times = timesOf(renderer, scene, options, arguments.frames);
    const char* name = transport == Transport::Boundary ? "boundary" : "better dipole";
    results.push_back({{"transport", name},
                       {"record_ms", median(times)},
                       {"longest_ms", *std::max_element(times.begin(), times.end())}});
    if (!arguments.json)
      fmt::print("{}: record() takes {:.3f} ms of the host, median of {}; longest {:.3f}\n", name,
                 median(times), times.size(), *std::max_element(times.begin(), times.end()));
  }
  if (arguments.json) fmt::print("{}\n", results.dump(2));
}

}  // namespace

}  // namespace opaline::bench

int main(int count, char** values) {
  return opaline::bench::runMain(opaline::bench::run, count, values);
}
