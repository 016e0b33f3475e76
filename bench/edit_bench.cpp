// The time of a frame while somebody edits a still scene: with everything computed anew, while a
// light is dragged, and while the camera moves. Options are those of the window on a slow device:
// one sample per pixel, light at vertices, coarse clusters, surfels and shadow maps.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "arguments.h"
#include "gpu/pass_timer.h"
#include "opaline/renderer.h"
#include "renderer/frame/timing.h"

namespace opaline::bench {

namespace {

using Json = nlohmann::ordered_json;

constexpr float turnOfFrame = 0.01F;  // rad

RenderOptions optionsOfWindow() {
  RenderOptions options;
  options.width = 592;
  options.height = 480;
  options.antialias = 1;
  options.site = Site::Vertex;
  options.tolerance = 0.05F;
  options.maxClusters = 1024;
  options.maxSurfels = 24576;
  options.shadowSize = 512;
  return options;
}

/// Turns a vector about the vertical axis.
Vec3 turned(const Vec3& v, float angle) {
  return {v[0] * std::cos(angle) + v[2] * std::sin(angle), v[1],
          v[2] * std::cos(angle) - v[0] * std::sin(angle)};
}

Lighting turned(Lighting lighting, float angle) {
  Vec3& direction = lighting.directional.front().directionToLight;
  direction = turned(direction, angle);
  return lighting;
}

Camera turned(Camera camera, float angle) {
  camera.positionMm = turned(camera.positionMm, angle);
  return camera;
}

struct Way {
  const char* name;
  bool movesLight;
  bool movesCamera;
  bool reuses;
  Renderer renderer;
  View view{renderer, optionsOfWindow()};
  FrameTimes times{};

  void render(const Scene& scene, float angle) {
    if (movesLight) renderer.setLighting(turned(scene.lighting, angle));
    if (movesCamera) renderer.setCamera(turned(scene.camera, angle));
    const RenderReport report =
        view.render({.aovs = {}, .onDevice = true, .reuseLight = reuses}).report;
    std::vector<gpu::PassTiming> passes;
    for (const PassTime& pass : report.passes) passes.push_back({pass.name, pass.milliseconds});
    times.add(report.frameMilliseconds, passes);
  }
};

Json measure(const Arguments& arguments, const Scene& scene) {
  const RendererOptions on{.device = arguments.device};
  std::array ways{Way{"all anew", true, true, false, Renderer(on)},
                  Way{"a light is dragged", true, false, true, Renderer(on)},
                  Way{"the camera moves", false, true, true, Renderer(on)}};
  for (Way& way : ways) {
    way.renderer.setScene(scene);
    way.render(scene, 0);
    way.times.clear();
  }
  // In turns, so that other load on the machine affects all alike.
  for (int i = 1; i <= arguments.frames; ++i)
    for (Way& way : ways) way.render(scene, turnOfFrame * static_cast<float>(i));
  Json result{{"scene", scene.name}, {"rows", Json::array()}};
  for (const Way& way : ways) {
    Json row{{"way", way.name}, {"frame_ms", way.times.frameMilliseconds()}};
    row["of_all_anew"] = way.times.frameMilliseconds() / ways[0].times.frameMilliseconds();
    for (const PassTime& pass : way.times.passes()) row["passes_ms"][pass.name] = pass.milliseconds;
    result["rows"].push_back(row);
  }
  return result;
}

void print(const Json& row) {
  fmt::print("{}: {:.2f} ms, {:.2f} of all anew\n", row["way"].get<std::string>(),
             row["frame_ms"].get<double>(), row["of_all_anew"].get<double>());
  for (const auto& [name, milliseconds] : row["passes_ms"].items())
    fmt::print("  {:<24}{:>10.2f} ms\n", name, milliseconds.get<double>());
}

void run(int count, char** values) {
  const Arguments arguments = parse("opaline_edit_bench", count, values, 21);
  const Json result = measure(arguments, loadBear());
  if (arguments.json) return fmt::print("{}\n", result.dump(2));
  for (const Json& row : result["rows"]) print(row);
}

}  // namespace

}  // namespace opaline::bench

int main(int count, char** values) {
  return opaline::bench::runMain(opaline::bench::run, count, values);
}
