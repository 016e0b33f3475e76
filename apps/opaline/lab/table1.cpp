#include "lab/table1.h"

#include <fmt/format.h>

#include <array>
#include <span>
#include <system_error>

#include "cli/output.h"
#include "lab/frame_medians.h"
#include "opaline/error.h"
#include "opaline/media.h"
#include "opaline/scene.h"

namespace opaline::app {

namespace fs = std::filesystem;

namespace {

/// Gong et al. 2008, Table 1: frames per second on an NVidia 7600 GS. Figure 8 gives the size of
/// the pictures, 1024 × 1024.
struct PaperRow {
  const char* data;
  const char* file;
  const char* morphTo;  ///< none: a still model
  double fragmentPerSecond;
  double vertexPerSecond;
};

constexpr std::array paperRows{
    PaperRow{"Teapot", "teapot.ply", nullptr, 53.74, 91.80},
    PaperRow{"Buddha", "buddha.ply", nullptr, 29.95, 23.01},
    PaperRow{"Max Planck", "max_planck.ply", nullptr, 35.62, 28.93},
    PaperRow{"Bunny", "bunny.ply", nullptr, 27.73, 20.48},
    PaperRow{"Bunny/Egg", "bunny_egg_a.ply", "bunny_egg_b.ply", 29.19, 24.12},
};

constexpr int edgePixels = 1024;
constexpr float modelDiagonalMm = 50;
constexpr double framesPerClip = 30;

/// `opaline render --method paper`, except for the site.
RenderOptions paperOptions(Site site) {
  RenderOptions options;
  options.width = options.height = edgePixels;
  options.transport = Transport::Dipole;
  options.sum = Sum::Pattern;
  options.site = site;
  options.antialias = 1;
  return options;
}

Scene loadRow(const PaperRow& row, const Table1Order& order) {
  LoadOptions options;
  options.diagonalMm = modelDiagonalMm;
  options.medium = findMedium("marble");
  if (row.morphTo != nullptr) options.morphTo = order.models / row.morphTo;
  options.log = order.log;
  return loadScene(order.models / row.file, options);
}

/// `opaline render --transport dipole`: the paper's transport with another sum.
RenderOptions treeOptions() {
  RenderOptions options;
  options.width = options.height = edgePixels;
  options.transport = Transport::Dipole;
  options.antialias = 1;
  return options;
}

/// The tree does not use the paper's atlas, so each method has a renderer with only what it needs.
struct Renderers {
  Renderer paper;
  Renderer tree;
};

/// One kind of frame and its times.
struct Table1Way {
  Renderer& renderer;
  View view;
  double& perSecond;
  FrameMedians medians;
};

/// Renders one frame of each way in turn, again and again, so that other load on the machine
/// affects all alike. The time advances, so that no frame equals the previous one.
void measureInTurns(std::span<Table1Way> ways, double clipSeconds, int frames) {
  Frame done;
  for (int frame = 0; frame <= frames; ++frame)
    for (Table1Way& way : ways) {
      way.renderer.setTime({.seconds = clipSeconds * frame / framesPerClip});
      renderFrame(way.view, {}, done);
      way.medians.add(done);
    }
  for (Table1Way& way : ways) {
    const double median = way.medians.frameMilliseconds();
    way.perSecond = median > 0 ? 1000 / median : 0;
  }
}

Table1Row measureRow(Renderers& renderers, const PaperRow& paper, const Table1Order& order,
                     DeviceDescription& device) {
  Table1Row row;
  row.data = paper.data;
  row.paperFragmentPerSecond = paper.fragmentPerSecond;
  row.paperVertexPerSecond = paper.vertexPerSecond;
  const Scene scene = loadRow(paper, order);
  renderers.paper.setScene(scene);
  renderers.tree.setScene(scene);
  std::array ways{
      Table1Way{renderers.paper,
                View(renderers.paper, paperOptions(Site::Fragment)),
                row.fragmentPerSecond,
                {}},
      Table1Way{renderers.paper,
                View(renderers.paper, paperOptions(Site::Vertex)),
                row.vertexPerSecond,
                {}},
      Table1Way{renderers.tree, View(renderers.tree, treeOptions()), row.treePerSecond, {}},
  };
  measureInTurns(ways, scene.clips.empty() ? 1 : double{scene.clips.front().seconds}, order.frames);
  const RenderReport report = ways.back().view.report();
  row.triangles = report.triangles;
  row.vertices = report.vertices;
  device = report.device;
  return row;
}

}  // namespace

void requireTable1Models(const fs::path& folder) {
  for (const PaperRow& row : paperRows) {
    for (const char* name : {row.file, row.morphTo}) {
      std::error_code error;
      if (name == nullptr || fs::is_regular_file(folder / name, error)) continue;
      throw Error(fmt::format(
          "there is no {} in {}: --models or OPALINE_MODELS names the folder of the models", name,
          folder.string()));
    }
  }
}

Table1 measureTable1(const Table1Order& order) {
  requireTable1Models(order.models);
  Renderers renderers{Renderer({order.device, false, order.log}),
                      Renderer({order.device, false, order.log})};
  Table1 table;
  for (const PaperRow& row : paperRows) {
    order.status(fmt::format("measuring {}", row.data));
    table.rows.push_back(measureRow(renderers, row, order, table.device));
  }
  clearStatus();
  return table;
}

Json toJson(const Table1& table) {
  Json rows = Json::array();
  for (const Table1Row& row : table.rows) {
    rows.push_back({{"data", row.data},
                    {"triangles", row.triangles},
                    {"vertices", row.vertices},
                    {"ftf_fps", row.fragmentPerSecond},
                    {"vtf_fps", row.vertexPerSecond},
                    {"paper_ftf_fps", row.paperFragmentPerSecond},
                    {"paper_vtf_fps", row.paperVertexPerSecond},
                    {"tree_fps", row.treePerSecond}});
  }
  return {{"device", deviceJson(table.device)}, {"rows", std::move(rows)}};
}

std::string toReadable(const Table1& table) {
  std::string text = fmt::format(
      "Frames per second at {0}x{0} on {1} ({2}),\n"
      "from the GPU time of the median frame; the paper's on an NVidia 7600 GS\n"
      "{3:<12}{4:>10}{5:>10}{6:>9}{7:>9}{8:>9}{9:>11}{10:>11}\n",
      edgePixels, table.device.name, table.device.type, "data", "triangles", "vertices", "FTF",
      "VTF", "tree", "paper FTF", "paper VTF");
  for (const Table1Row& row : table.rows) {
    text += fmt::format("{:<12}{:>10}{:>10}{:>9.2f}{:>9.2f}{:>9.2f}{:>11.2f}{:>11.2f}\n", row.data,
                        row.triangles, row.vertices, row.fragmentPerSecond, row.vertexPerSecond,
                        row.treePerSecond, row.paperFragmentPerSecond, row.paperVertexPerSecond);
  }
  return text;
}

}  // namespace opaline::app
