// Times of the passes of the paper's method on this machine, and how they compare with an opaque
// frame of the same mesh.

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "arguments.h"
#include "opaline/renderer.h"
#include "opaque_frame.h"

namespace opaline::bench {

namespace {

using nlohmann::json;

/// The frame of `opaline render --method paper` at a site.
RenderOptions paperOptions(Site site) {
  RenderOptions options;
  options.site = site;
  options.dsmSize = 512;
  options.antialias = 1;
  return options;
}

std::size_t coveredPixels(Renderer& renderer, const RenderOptions& options) {
  const Image object = renderer.render(options, {Aov::Object}).images[0];
  std::size_t covered = 0;
  for (std::size_t i = 3; i < object.rgba.size(); i += 4) covered += object.rgba[i] > 0 ? 1U : 0U;
  return covered;
}

json describe(const FrameTimes& times) {
  json description;
  description["frame_ms"] = times.frameMilliseconds();
  for (const PassTime& pass : times.passes()) {
    description["passes_ms"][pass.name] = pass.milliseconds;
  }
  return description;
}

void renderPaper(Renderer& renderer, const RenderOptions& options, FrameTimes& times) {
  const RenderReport report = renderer.render(options).report;
  std::vector<gpu::PassTiming> passes;
  for (const PassTime& pass : report.passes) passes.push_back({pass.name, pass.milliseconds});
  times.add(report.frameMilliseconds, passes);
}

/// One kind of frame after the other, again and again, so that what else the machine does falls on
/// all of them alike.
struct Times {
  FrameTimes fragment;
  FrameTimes vertex;
  FrameTimes opaque;
};

Times timeFrames(Renderer& renderer, OpaqueFrame& opaque, int frames) {
  Times times;
  for (int i = 0; i < frames; ++i) {
    renderPaper(renderer, paperOptions(Site::Fragment), times.fragment);
    opaque.render(times.opaque);
    renderPaper(renderer, paperOptions(Site::Vertex), times.vertex);
  }
  return times;
}

double passMilliseconds(const json& frame, const std::string& name) {
  return frame["passes_ms"].value(name, 0.0);
}

json measure(const Arguments& arguments) {
  const Scene scene = loadModel();
  Renderer renderer;
  renderer.setScene(scene);

  const RenderOptions options = paperOptions(Site::Fragment);
  OpaqueFrame opaqueFrame(scene, options);
  const Times times = timeFrames(renderer, opaqueFrame, arguments.frames);
  const RenderReport report = renderer.render(options).report;

  json result;
  const int block = 2 * options.pattern.nearRings + 1;
  const int farTaps = 8;
  const int taps = block * block + farTaps;
  const std::size_t covered = coveredPixels(renderer, options);
  result["scene"] = scene.name;
  result["device"] = report.device.name;
  result["width"] = options.width;
  result["height"] = options.height;
  result["dsm_size"] = options.dsmSize;
  result["triangles"] = report.triangles;
  result["vertices"] = report.vertices;
  result["covered_pixels"] = covered;
  result["taps"] = taps;
  result["fragment"] = describe(times.fragment);
  result["vertex"] = describe(times.vertex);
  result["opaque"] = describe(times.opaque);
  const double opaque = times.opaque.frameMilliseconds();
  result["fragment"]["opaque_frames"] = times.fragment.frameMilliseconds() / opaque;
  result["vertex"]["opaque_frames"] = times.vertex.frameMilliseconds() / opaque;
  result["fragment"]["ns_per_pixel_and_tap"] =
      passMilliseconds(result["fragment"], "scatter") * 1e6 /
      (static_cast<double>(std::max<std::size_t>(covered, 1)) * taps);
  result["vertex"]["ns_per_vertex_and_tap"] = passMilliseconds(result["vertex"], "scatter") * 1e6 /
                                              (static_cast<double>(report.vertices) * taps);
  return result;
}

void printFrame(const char* title, const json& frame) {
  fmt::print("\n{}\n", title);
  for (const auto& [name, milliseconds] : frame["passes_ms"].items())
    fmt::print("  {:<24}{:>10.2f} ms\n", name, milliseconds.get<double>());
  fmt::print("  {:<24}{:>10.2f} ms\n", "whole frame", frame["frame_ms"].get<double>());
}

void print(const json& r) {
  fmt::print("{}, {} triangles, {} x {} pixels, map of {} texels, on {}\n",
             r["scene"].get<std::string>(), r["triangles"].get<std::size_t>(),
             r["width"].get<int>(), r["height"].get<int>(), r["dsm_size"].get<int>(),
             r["device"].get<std::string>());
  fmt::print("medians of warm frames; {} covered pixels, {} vertices, {} taps\n",
             r["covered_pixels"].get<std::size_t>(), r["vertices"].get<std::size_t>(),
             r["taps"].get<int>());
  printFrame("pattern over fragments", r["fragment"]);
  fmt::print("  {:<24}{:>10.2f} opaque frames\n", "", r["fragment"]["opaque_frames"].get<double>());
  fmt::print("  {:<24}{:>10.2f} ns a covered pixel and tap\n", "",
             r["fragment"]["ns_per_pixel_and_tap"].get<double>());
  printFrame("pattern over vertices", r["vertex"]);
  fmt::print("  {:<24}{:>10.2f} opaque frames\n", "", r["vertex"]["opaque_frames"].get<double>());
  fmt::print("  {:<24}{:>10.2f} ns a vertex and tap\n", "",
             r["vertex"]["ns_per_vertex_and_tap"].get<double>());
  printFrame("opaque frame", r["opaque"]);
}

void run(int count, char** values) {
  const Arguments arguments = parse("opaline_frame_bench", count, values, 11);
  const json result = measure(arguments);
  if (arguments.json) {
    fmt::print("{}\n", result.dump(2));
  } else {
    print(result);
  }
}

}  // namespace

}  // namespace opaline::bench

int main(int count, char** values) {
  return opaline::bench::runMain(opaline::bench::run, count, values);
}
