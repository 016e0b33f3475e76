#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cli/json.h"
#include "opaline/compare.h"

namespace opaline::app {

/// Figures over some pixels of two images.
struct RegionFigures {
  compare::Figures figures;
  double flip = 0;
  std::optional<compare::BlockFigures> block;
};

struct CompareReport {
  std::filesystem::path a;
  std::filesystem::path b;
  int width = 0;
  int height = 0;
  bool pictures = false;
  RegionFigures whole;
  bool masked = false;
  std::optional<RegionFigures> inside;  ///< none where no pixel counts
  std::optional<RegionFigures> outside;
  std::optional<std::filesystem::path> heatmap;
  double heatmapTop = 0;
};

Json toJson(const CompareReport& report);
std::string toReadable(const CompareReport& report);

}  // namespace opaline::app
