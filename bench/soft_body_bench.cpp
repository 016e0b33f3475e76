// The cost of a soft body's step: the built-in bear, pulled, at several frame rates.

#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <string>

#include "arguments.h"
#include "opaline/renderer.h"
#include "opaline/soft_body.h"

namespace opaline::bench {

namespace {

using nlohmann::json;

/// Mean time of consecutive steps, of which at most two are under way; ms.
double stepMilliseconds(SoftBody& body, double seconds, int steps) {
  using Clock = std::chrono::steady_clock;
  constexpr int warmUp = 4;
  body.grab({0, 39, 0}, 4);
  Clock::time_point start;
  for (int i = 0; i < warmUp + steps; ++i) {
    if (i == warmUp) start = Clock::now();
    body.pull({i % 2 == 0 ? 15.0F : 16.0F, 45, 0});
    body.step(seconds);
  }
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count() / steps;
}

void run(int count, char** values) {
  const Arguments arguments = parse("opaline_soft_body_bench", count, values, 100);
  RendererOptions options;
  options.device = arguments.device;
  Renderer renderer(options);
  const Scene scene = builtInBear();
  renderer.setScene(scene);
  const Mesh& mesh = scene.objects[0].mesh;
  SoftBody body(renderer, 0, mesh.positionsMm, mesh.triangles);
  json rows = json::array();
  for (const double rate : {10.0, 30.0, 60.0, 240.0})
    rows.push_back({{"frames_per_second", rate},
                    {"step_ms", stepMilliseconds(body, 1 / rate, arguments.frames)}});
  if (arguments.json) return fmt::print("{}\n", json{{"rows", rows}}.dump(2));
  fmt::print("{}, {} vertices\n", scene.name, mesh.positionsMm.size());
  for (const json& row : rows)
    fmt::print("  {:>4} steps a second{:>9.3f} ms a step\n", row["frames_per_second"].get<double>(),
               row["step_ms"].get<double>());
}

}  // namespace

}  // namespace opaline::bench

int main(int count, char** values) {
  return opaline::bench::runMain(opaline::bench::run, count, values);
}
