// The cost of motion: frames of one mesh, still and moved in every supported way, as ratios.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "arguments.h"
#include "opaline/renderer.h"

namespace opaline::bench {

namespace {

using nlohmann::json;

constexpr int framesInARow = 4;

RenderOptions options() {
  RenderOptions options;
  options.transport = Transport::Dipole;
  options.site = Site::Fragment;
  options.antialias = 1;
  return options;
}

/// Adds a node, a clip that turns it, and a rig with the mesh unchanged.
Rig& addRig(Scene& scene) {
  Node node;
  node.morphWeights = {0};
  scene.nodes = {node, node};
  scene.nodes[1].parent = 0;
  Rig rig;
  rig.positions = scene.objects[0].mesh.positionsMm;
  rig.normals = scene.objects[0].mesh.normals;
  scene.objects[0].rig = rig;
  return *scene.objects[0].rig;
}

/// Four influences per vertex, as in games.
Scene skinned(Scene scene) {
  Rig& rig = addRig(scene);
  rig.joints.resize(2);
  rig.joints[1].node = 1;
  for (const Vec3& p : rig.positions) {
    rig.firstInfluence.push_back(static_cast<std::uint32_t>(rig.influences.size()));
    const float weight = 0.5F + 0.5F * std::sin(p[1] / 5);
    for (const Influence& influence :
         {Influence{0, 0.5F * weight}, Influence{1, 0.5F * weight},
          Influence{0, 0.5F - 0.5F * weight}, Influence{1, 0.5F - 0.5F * weight}})
      rig.influences.push_back(influence);
  }
  rig.firstInfluence.push_back(static_cast<std::uint32_t>(rig.influences.size()));
  scene.clips = {{"turn",
                  1,
                  {{1,
                    TrackTarget::Rotation,
                    Interpolation::Linear,
                    {0, 1},
                    {0, 0, 0, 1, 0, 0.3F, 0, 0.954F}}}}};
  return scene;
}

/// Morph targets with `normals`, or without, so that normals must be computed from the triangles.
Scene morphed(Scene scene, bool normals) {
  Rig& rig = addRig(scene);
  MorphTarget target;
  for (std::size_t v = 0; v < rig.positions.size(); ++v) {
    const Vec3& n = rig.normals[v];
    target.positions.push_back({2 * n[0], 2 * n[1], 2 * n[2]});
    if (normals) target.normals.push_back({0.01F * n[1], 0, 0});
  }
  rig.targets = {target};
  scene.clips = {
      {"swell", 1, {{0, TrackTarget::MorphWeights, Interpolation::Linear, {0, 1}, {0, 1}}}}};
  return scene;
}

Scene deformed(Scene scene) {
  scene.deformers = {{DeformerKind::Twist, 0.5F, 2}, {DeformerKind::Wobble, 0.03F, 1}};
  return scene;
}

/// One way of moving, and the times of its frames.
struct Way {
  const char* name;
  double allowed;  ///< ratio to still frames
  Scene scene;
  bool fromHost = false;
  std::unique_ptr<Renderer> renderer;
  std::optional<View> view;
  std::vector<Vec3> positions;
  std::vector<double> milliseconds;
  int frame = 0;

  void start(const std::string& device) {
    renderer = std::make_unique<Renderer>(RendererOptions{.device = device});
    renderer->setScene(scene);
    view.emplace(*renderer, options());
    positions = scene.objects[0].mesh.positionsMm;
  }

  void submit() {
    renderer->setTime({.seconds = 0.02 * ++frame});
    if (fromHost) {
      for (Vec3& p : positions) p[1] += 0.01F;
      renderer->replacePositions(0, positions);
    }
    view->submit();
  }

  /// Renders consecutive frames with as many under way as allowed. Wall time counts, and so the
  /// host's work does too.
  void run(Frame& done) {
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < framesInARow; ++i) {
      submit();
      if (i > 0) view->collect(done);
    }
    view->collect(done);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
    milliseconds.push_back(took.count() / framesInARow);
  }

  double median() const {
    std::vector<double> sorted(milliseconds.begin() + 1, milliseconds.end());
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
  }
};

void run(int count, char** values) {
  const Arguments arguments = parse("opaline_motion_bench", count, values, 6);
  const Scene scene = loadModel();
  std::vector<Way> ways;
  ways.push_back({"still", 1, scene});
  ways.push_back({"skin", 1.1, skinned(scene)});
  ways.push_back({"morph", 1.1, morphed(scene, true)});
  ways.push_back({"morph, normals anew", 1.1, morphed(scene, false)});
  ways.push_back({"procedural", 1.1, deformed(scene)});
  ways.push_back({"host", 1.25, scene, true});
  for (Way& way : ways) way.start(arguments.device);
  // One way after the other, again and again, so that other load on the machine affects all alike.
  Frame done;
  for (int i = 0; i < arguments.frames; ++i)
    for (Way& way : ways) way.run(done);

  json rows = json::array();
  for (const Way& way : ways)
    rows.push_back({{"motion", way.name},
                    {"frame_ms", way.median()},
                    {"ratio", way.median() / ways[0].median()},
                    {"allowed", way.allowed}});
  const json result{{"scene", scene.name},
                    {"vertices", scene.objects[0].mesh.positionsMm.size()},
                    {"device", ways[0].view->report().device.name},
                    {"rows", rows}};
  if (arguments.json) return fmt::print("{}\n", result.dump(2));
  fmt::print("{}, {} vertices, 1024 x 1024, fragment, on {}\n", scene.name,
             result["vertices"].get<std::size_t>(), result["device"].get<std::string>());
  for (const json& row : rows)
    fmt::print("  {:<20}{:>9.2f} ms a frame{:>8.3f} of the still ({})\n",
               row["motion"].get<std::string>(), row["frame_ms"].get<double>(),
               row["ratio"].get<double>(),
               row["ratio"].get<double>() <= row["allowed"].get<double>()
                   ? "within bounds"
                   : fmt::format("MORE than {:.2f}", row["allowed"].get<double>()));
}

}  // namespace

}  // namespace opaline::bench

int main(int count, char** values) {
  return opaline::bench::runMain(opaline::bench::run, count, values);
}
