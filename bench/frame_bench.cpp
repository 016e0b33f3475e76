// The cost of a translucent frame of a deforming body on this machine: by the paper's method, by
// the tree, and by boundary transport. Each is given as multiples of an opaque frame of the same
// mesh, of the paper's frame and of the tree's.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "arguments.h"
#include "opaline/compare.h"
#include "opaline/renderer.h"
#include "opaque_frame.h"

namespace opaline::bench {

namespace {

using Json = nlohmann::ordered_json;  // passes in the order they run

constexpr double secondsPerFrame = 0.02;
/// The smallest tolerance allowed, as a reference for errors.
constexpr double finestTolerance = 1e-4;

/// Makes everything move from frame to frame.
Scene deforming(Scene scene) {
  scene.deformers = {{DeformerKind::Twist, 0.5F, 2}, {DeformerKind::Wobble, 0.03F, 1}};
  return scene;
}

/// The only light of docs/accuracy.md. Surfels that face the camera send out little light, so the
/// tree has little to do for them.
Scene litFromBehind(Scene scene) {
  constexpr float pi = 3.14159F;
  constexpr Vec3 towards{0.45F, 0.35F, -0.82F};
  const float length = std::hypot(towards[0], towards[1], towards[2]);
  scene.lighting = {};
  scene.lighting.directional = {
      {{towards[0] / length, towards[1] / length, towards[2] / length}, {pi, pi, pi}}};
  return scene;
}

RenderOptions optionsFor(Sum sum, Site site) {
  RenderOptions options;
  options.transport = Transport::Dipole;
  options.sum = sum;
  options.site = site;
  options.antialias = 1;
  return options;
}

RenderOptions boundaryFor(int bounces) {
  RenderOptions options = optionsFor(Sum::Tree, Site::Auto);
  options.transport = Transport::Boundary;
  options.bounces = bounces;
  return options;
}

/// The most frames of another kind that one may cost.
struct Limits {
  std::optional<double> papers = std::nullopt;  ///< frames of the paper's method, at fragments
  std::optional<double> trees = std::nullopt;   ///< frames of the tree's dipole
};

/// One kind of translucent frame.
struct Way {
  const char* name;
  RenderOptions options;
  Limits most;
  Renderer& renderer;
  View view{renderer, options};
  FrameTimes times{};
  Site site = Site::Auto;  ///< the site that was chosen
  std::size_t sources = 0;
  std::size_t clusters = 0;
  std::vector<Solution> solutions;
  std::uint32_t dispatches = 0;
  std::uint32_t barriers = 0;

  void render(double seconds) {
    renderer.setTime({.seconds = seconds});
    const RenderReport report = view.render().report;
    std::vector<gpu::PassTiming> passes;
    for (const PassTime& pass : report.passes) passes.push_back({pass.name, pass.milliseconds});
    times.add(report.frameMilliseconds, passes);
    site = report.site;
    sources = report.sources;
    clusters = report.clusters;
    solutions = report.solutions;
    dispatches = report.dispatches;
    barriers = report.barriers;
  }
};

const char* nameOf(Site site) {
  switch (site) {
    case Site::Vertex:
      return "vertex";
    case Site::Fragment:
      return "fragment";
    case Site::Auto:
      break;
  }
  return "auto";
}

/// The frames to compare with.
struct Yardsticks {
  double opaqueMs;
  double paperMs;
  double treeMs;
};

Json describe(const Way& way, double opaqueMs) {
  Json result;
  result["way"] = way.name;
  result["site"] = nameOf(way.site);
  result["sources"] = way.sources;
  result["frame_ms"] = way.times.frameMilliseconds();
  result["dispatches"] = way.dispatches;
  result["barriers"] = way.barriers;
  for (const PassTime& pass : way.times.passes())
    result["passes_ms"][pass.name] = pass.milliseconds;
  result["opaque_frames"] = way.times.frameMilliseconds() / opaqueMs;
  if (way.options.transport == Transport::Boundary) {
    result["clusters"] = way.clusters;
    for (const Solution& solution : way.solutions) result["steps"].push_back(solution.steps);
  }
  return result;
}

Json compareWith(Way& way, const Image& finest, const Yardsticks& yardsticks) {
  Json result = describe(way, yardsticks.opaqueMs);
  result["papers"] = way.times.frameMilliseconds() / yardsticks.paperMs;
  if (way.most.papers) result["papers_allowed"] = *way.most.papers;
  result["trees"] = way.times.frameMilliseconds() / yardsticks.treeMs;
  if (way.most.trees) result["trees_allowed"] = *way.most.trees;

  way.renderer.setTime({});
  const std::vector<Image> found =
      way.view.render({.aovs = {Aov::Exitance, Aov::Evaluations}}).images;
  if (way.options.sum != Sum::Pattern) result["evaluations"] = compare::meanOverCovered(found[1]);
  // The error only makes sense for the dipole: other transports do not approximate it.
  if (way.options.transport != Transport::Dipole) return result;
  const auto figures =
      compare::figuresOver(found[0], finest, compare::commonPixels(found[0], finest));
  if (figures) {
    result["rel_rmse"] = figures->all.relRmse;
    result["p95_rel"] = figures->all.p95Rel;
  }
  return result;
}

Json headOf(const Scene& scene, const RenderReport& report, const RenderOptions& options,
            const FrameTimes& opaque) {
  const DeviceDescription& device = report.device;
  return {{"scene", scene.name},
          {"device", {{"name", device.name}, {"type", device.type}, {"driver", device.driver}}},
          {"size", {options.width, options.height}},
          {"triangles", report.triangles},
          {"vertices", report.vertices},
          {"opaque_ms", opaque.frameMilliseconds()},
          {"rows", Json::array()}};
}

/// Measures frames with default settings.
Json measureDefault(const Arguments& arguments, const Scene& scene) {
  Renderer renderer({arguments.device, false, {}});
  renderer.setScene(scene);
  OpaqueFrame opaqueFrame(scene, optionsFor(Sum::Tree, Site::Auto), arguments.device);
  Way way{"default", {}, {}, renderer};
  FrameTimes opaque;
  for (int i = 0; i < arguments.frames; ++i) {
    opaqueFrame.render(secondsPerFrame * i, opaque);
    way.render(secondsPerFrame * i);
  }
  Json result = headOf(scene, way.view.render().report, way.options, opaque);
  result["medium"] = scene.objects.front().medium.name;
  result["rows"].push_back(describe(way, opaque.frameMilliseconds()));
  return result;
}

Json measure(const Arguments& arguments, const Scene& scene, const char* lighting) {
  // Each renderer has only what its own sum needs.
  Renderer paper({arguments.device, false, {}});
  Renderer tree({arguments.device, false, {}});
  Renderer boundary({arguments.device, false, {}});
  paper.setScene(scene);
  tree.setScene(scene);
  boundary.setScene(scene);
  OpaqueFrame opaqueFrame(scene, optionsFor(Sum::Tree, Site::Auto), arguments.device);
  std::array ways{Way{"paper fragment", optionsFor(Sum::Pattern, Site::Fragment), {}, paper},
                  Way{"paper vertex", optionsFor(Sum::Pattern, Site::Vertex), {}, paper},
                  Way{"tree auto", optionsFor(Sum::Tree, Site::Auto), {.papers = 1}, tree},
                  Way{"tree fragment", optionsFor(Sum::Tree, Site::Fragment), {.papers = 3}, tree},
                  Way{"boundary, no bounces", boundaryFor(0), {.trees = 2}, boundary},
                  Way{"boundary, two bounces", boundaryFor(2), {.trees = 3}, boundary}};
  constexpr std::size_t paperFragment = 0;
  constexpr std::size_t treeAuto = 2;

  // One frame of each kind in turn, again and again, so that other load on the machine affects all
  // alike.
  FrameTimes opaque;
  for (int i = 0; i < arguments.frames; ++i) {
    const double seconds = secondsPerFrame * i;
    opaqueFrame.render(seconds, opaque);
    for (Way& way : ways) way.render(seconds);
  }

  RenderOptions finest = optionsFor(Sum::Tree, Site::Fragment);
  finest.tolerance = static_cast<float>(finestTolerance);
  tree.setTime({});
  const RenderResult exact = tree.render(finest, {Aov::Exitance});
  Json result = headOf(scene, exact.report, finest, opaque);
  result["lighting"] = lighting;
  result["finest_tolerance"] = finestTolerance;
  const Yardsticks yardsticks{opaque.frameMilliseconds(),
                              ways[paperFragment].times.frameMilliseconds(),
                              ways[treeAuto].times.frameMilliseconds()};
  for (Way& way : ways) result["rows"].push_back(compareWith(way, exact.images[0], yardsticks));
  return result;
}

/// `yardstick` is "papers" or "trees".
std::string verdict(const Json& row, const std::string& yardstick) {
  const std::string limit = yardstick + "_allowed";
  if (!row.contains(limit)) return "";
  const double allowed = row[limit].get<double>();
  return row[yardstick].get<double>() <= allowed ? fmt::format(" (within {:g})", allowed)
                                                 : fmt::format(" (MORE than {:g})", allowed);
}

void printHead(const Json& result, const std::string& what) {
  fmt::print("{}, deforming, {}, {} triangles, {} vertices, {} x {} pixels, on {}, {}\n",
             result["scene"].get<std::string>(), what, result["triangles"].get<std::size_t>(),
             result["vertices"].get<std::size_t>(), result["size"][0].get<int>(),
             result["size"][1].get<int>(), result["device"]["name"].get<std::string>(),
             result["device"]["driver"].get<std::string>());
  fmt::print("medians of warm frames in turns; an opaque frame takes {:.2f} ms\n",
             result["opaque_ms"].get<double>());
}

void printFrame(const Json& row) {
  fmt::print("\n{}, {} sources, at {}\n", row["way"].get<std::string>(),
             row["sources"].get<std::size_t>(), row["site"] == "vertex" ? "vertices" : "fragments");
  for (const auto& [name, milliseconds] : row["passes_ms"].items())
    fmt::print("  {:<24}{:>10.2f} ms\n", name, milliseconds.get<double>());
  fmt::print("  {:<24}{:>10.2f} ms\n", "whole frame", row["frame_ms"].get<double>());
  fmt::print("  {:<24}{:>10} dispatches, {} barriers\n", "", row["dispatches"].get<std::uint32_t>(),
             row["barriers"].get<std::uint32_t>());
  fmt::print("  {:<24}{:>10.2f} opaque frames\n", "", row["opaque_frames"].get<double>());
  if (row.contains("steps"))
    fmt::print("  {:<24}{:>10} of {} unknowns\n", "solved in steps", row["steps"].dump(),
               row["clusters"].get<std::size_t>());
}

void printWays(const Json& result) {
  printHead(result, result["lighting"].get<std::string>());
  for (const Json& row : result["rows"]) {
    printFrame(row);
    fmt::print("  {:<24}{:>10.2f} frames of the paper{}\n", "", row["papers"].get<double>(),
               verdict(row, "papers"));
    fmt::print("  {:<24}{:>10.2f} frames of the tree's dipole{}\n", "", row["trees"].get<double>(),
               verdict(row, "trees"));
    if (row.contains("evaluations"))
      fmt::print("  {:<24}{:>10.1f} a {}\n", "evaluations", row["evaluations"].get<double>(),
                 row["site"] == "vertex" ? "vertex" : "pixel");
    if (row.contains("rel_rmse"))
      fmt::print("  {:<24}{:>10.2f} % rms, {:.2f} % at the 95th percentile\n",
                 fmt::format("to tolerance {:g}", result["finest_tolerance"].get<double>()),
                 100 * row["rel_rmse"].get<double>(), 100 * row["p95_rel"].get<double>());
  }
}

void run(int count, char** values) {
  const Arguments arguments = parse("opaline_frame_bench", count, values, 11);
  const Scene scene = deforming(loadModel());
  Json results{{"ways", Json::array()}, {"defaults", Json::array()}};
  results["ways"].push_back(measure(arguments, litFromBehind(scene), "lit from behind"));
  results["ways"].push_back(measure(arguments, scene, "in the default lights"));
  for (const Scene& model : loadScenes())
    results["defaults"].push_back(measureDefault(arguments, deforming(model)));
  if (arguments.json) return fmt::print("{}\n", results.dump(2));
  for (const Json& result : results["ways"]) {
    printWays(result);
    fmt::print("\n\n");
  }
  for (const Json& result : results["defaults"]) {
    printHead(result, "of " + result["medium"].get<std::string>());
    printFrame(result["rows"].front());
    fmt::print("\n\n");
  }
}

}  // namespace

}  // namespace opaline::bench

int main(int count, char** values) {
  return opaline::bench::runMain(opaline::bench::run, count, values);
}
