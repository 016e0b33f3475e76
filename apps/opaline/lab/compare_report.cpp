#include "lab/compare_report.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace opaline::app {

namespace {

constexpr std::array<const char*, 3> channelNames{"r", "g", "b"};

struct FigureName {
  const char* name;
  double compare::ErrorFigures::*figure;
};
constexpr std::array<FigureName, 5> figureNames{{{"rel_rmse", &compare::ErrorFigures::relRmse},
                                                 {"rel_bias", &compare::ErrorFigures::relBias},
                                                 {"p95_rel", &compare::ErrorFigures::p95Rel},
                                                 {"max_abs", &compare::ErrorFigures::maxAbs},
                                                 {"psnr_db", &compare::ErrorFigures::psnrDb}}};

/// JSON has no infinity, so it becomes null.
Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

void addFigures(Json& json, const compare::ErrorFigures& figures) {
  for (const FigureName& entry : figureNames) json[entry.name] = number(figures.*entry.figure);
}

void addBlock(Json& json, const compare::BlockFigures& block) {
  Json channels = Json::object();
  for (std::size_t c = 0; c < channelNames.size(); ++c) {
    channels[channelNames[c]] = number(block.channelRelRmse[c]);
  }
  json["block"] = {{"edge_pixels", block.edgePixels},
                   {"blocks", block.blocks},
                   {"covered_blocks", block.coveredBlocks},
                   {"rel_rmse", number(block.relRmse)},
                   {"covered_rel_rmse", number(block.coveredRelRmse)},
                   {"channel_rel_rmse", std::move(channels)}};
}

void addRegion(Json& json, const RegionFigures& region) {
  json["covered_pixels"] = region.figures.coveredPixels;
  addFigures(json, region.figures.all);
  json["flip"] = region.flip;
  Json channels = Json::object();
  for (std::size_t c = 0; c < channelNames.size(); ++c) {
    addFigures(channels[channelNames[c]], region.figures.channels[c]);
  }
  json["channels"] = std::move(channels);
  if (region.block) addBlock(json, *region.block);
}

Json regionJson(const std::optional<RegionFigures>& region) {
  if (!region) return nullptr;
  Json json;
  addRegion(json, *region);
  return json;
}

std::string row(const char* name, double all, const std::array<double, 3>& rgb) {
  return fmt::format("{:<12}{:>12.4g}{:>12.4g}{:>12.4g}{:>12.4g}\n", name, all, rgb[0], rgb[1],
                     rgb[2]);
}

std::string table(const RegionFigures& region) {
  std::string text = fmt::format("{:<12}{:>12}{:>12}{:>12}{:>12}\n", "", "all", "r", "g", "b");
  const auto& channels = region.figures.channels;
  for (const FigureName& entry : figureNames) {
    text += row(entry.name, region.figures.all.*entry.figure,
                {channels[0].*entry.figure, channels[1].*entry.figure, channels[2].*entry.figure});
  }
  if (region.block) text += row("block rmse", region.block->relRmse, region.block->channelRelRmse);
  text += fmt::format("{:<12}{:>12.4g}\n", "flip", region.flip);
  if (region.block) {
    text += fmt::format(
        "blocks of {0}x{0} pixels: {1}, covered {2}; over covered blocks alone block rmse is "
        "{3:.4g}\n",
        region.block->edgePixels, region.block->blocks, region.block->coveredBlocks,
        region.block->coveredRelRmse);
  }
  return text;
}

std::string regionText(const char* name, const std::optional<RegionFigures>& region) {
  if (!region) return fmt::format("{} the mask: no pixel\n", name);
  return fmt::format("{} the mask: {} pixels\n", name, region->figures.coveredPixels) +
         table(*region);
}

}  // namespace

Json toJson(const CompareReport& report) {
  Json json = {{"a", report.a.string()},
               {"b", report.b.string()},
               {"size", {report.width, report.height}},
               {"values", report.pictures ? "picture" : "linear"}};
  addRegion(json, report.whole);
  json["regions"] = Json::object();
  if (report.masked) {
    json["regions"]["inside"] = regionJson(report.inside);
    json["regions"]["outside"] = regionJson(report.outside);
  }
  if (report.heatmap) {
    json["heatmap"] = {{"file", report.heatmap->string()}, {"top", report.heatmapTop}};
  }
  return json;
}

std::string toReadable(const CompareReport& report) {
  std::string text = fmt::format("{} against {}: {}x{}, {}, {} pixels covered by both\n",
                                 report.a.string(), report.b.string(), report.width, report.height,
                                 report.pictures ? "tone-mapped pictures" : "linear values",
                                 report.whole.figures.coveredPixels);
  text += table(report.whole);
  if (report.masked) {
    text += regionText("inside", report.inside) + regionText("outside", report.outside);
  }
  return text;
}

}  // namespace opaline::app
