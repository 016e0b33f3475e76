// Half-spaces and boundary transport, each above its difference from light traced through the body.

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "figures.h"
#include "opaline/compare.h"
#include "opaline/error.h"
#include "opaline/image_file.h"

namespace opaline::figures {

namespace {

constexpr int mapPixels = 256;
constexpr int blockPixels = 8;
constexpr double mapTop = 0.5;

/// Two independent runs; `make figures` traces them.
struct Truth {
  std::array<Image, 2> runs;
  Image mean;
};

Image meanOf(const Image& a, const Image& b) {
  Image mean = a;
  for (std::size_t i = 0; i < mean.rgba.size(); ++i) mean.rgba[i] = 0.5F * (a.rgba[i] + b.rgba[i]);
  return mean;
}

Truth readTruth(std::string_view name) {
  const std::filesystem::path folder =
      std::filesystem::path(OPALINE_SOURCE_DIR) / "build" / "truth";
  Truth truth;
  for (std::size_t i = 0; i < truth.runs.size(); ++i) {
    const std::filesystem::path file = folder / fmt::format("{}_{}.exr", name, i + 1);
    if (!std::filesystem::exists(file))
      throw Error(fmt::format("there is no {}: make figures traces it", file.string()));
    truth.runs[i] = readHdrImage(file);
  }
  truth.mean = meanOf(truth.runs[0], truth.runs[1]);
  return truth;
}

RenderOptions dipoleExact() {
  RenderOptions options = objectSpace();
  options.transport = Transport::Dipole;
  options.site = Site::Fragment;
  options.tolerance = 0.001F;
  return options;
}

RenderOptions boundary() {
  RenderOptions options = objectSpace();
  options.transport = Transport::Boundary;
  return options;
}

/// Removes the scale at the right, which is the same for all maps.
Image8 mapAlone(const Image8& drawn) {
  Image8 map{mapPixels, mapPixels, {}};
  for (int y = 0; y < mapPixels; ++y) {
    const auto row = drawn.rgba.begin() + std::ptrdiff_t{4} * y * drawn.width;
    map.rgba.insert(map.rgba.end(), row, row + std::ptrdiff_t{4} * mapPixels);
  }
  return map;
}

Image8 heatmap(const char* what, const Image& found, const Image& truth) {
  const compare::Selection selection = compare::commonPixels(found, truth);
  if (const auto figures = compare::blockFiguresOver(found, truth, selection, blockPixels))
    fmt::print("{}: {:.3f} of the mean, r {:.3f} g {:.3f} b {:.3f}\n", what, figures->relRmse,
               figures->channelRelRmse[0], figures->channelRelRmse[1], figures->channelRelRmse[2]);
  return mapAlone(compare::drawHeatmap(
      compare::relativeBlockErrors(found, truth, selection, blockPixels), selection, mapTop));
}

void compareTransports(Studio& studio, const char* name, Scene scene, const Truth& truth,
                       float stops) {
  constexpr float irradiance = 3.14159265F;
  scene.lighting = {};
  scene.lighting.directional = {{{0.45F, 0.35F, -0.82F}, {irradiance, irradiance, irradiance}}};
  studio.renderer.setScene(scene);
  std::vector<Image8> pictures;
  std::vector<Image8> maps;
  const auto show = [&](const char* what, const Image& found, const Image& held) {
    pictures.push_back(develop(held, stops));
    maps.push_back(heatmap(what, found, truth.mean));
  };
  for (auto [what, options] :
       {std::pair{"paper", paperMethod()}, std::pair{"dipole", dipoleExact()},
        std::pair{"boundary", boundary()}}) {
    options.width = options.height = mapPixels;
    const Image found = studio.renderer.render(options, {Aov::Exitance}).images.at(0);
    show(what, found, found);
  }
  // The truth's own error: half of the difference between its two runs.
  show("truth", truth.runs[0], truth.mean);
  const int columns = static_cast<int>(pictures.size());
  pictures.insert(pictures.end(), maps.begin(), maps.end());
  publish(studio, name, sheet(pictures, columns, gapPixels, white));
}

void bunny(Studio& studio, const char* name) {
  compareTransports(studio, name, load(studio, "bunny_closed.ply", "marble", 50),
                    readTruth("bunny"), 0);
}

void gummyBear(Studio& studio, const char* name) {
  compareTransports(studio, name, bear("gummy-red", 50), readTruth("bear"), 0);
}

}  // namespace

std::span<const Figure> boundaryFigures() {
  static constexpr std::array all{Figure{"boundary_bunny", bunny},
                                  Figure{"boundary_bear", gummyBear}};
  return all;
}

}  // namespace opaline::figures
