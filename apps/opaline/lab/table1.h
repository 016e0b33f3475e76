#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/json.h"
#include "cli/output.h"
#include "opaline/log.h"
#include "opaline/renderer.h"

namespace opaline::app {

/// What to measure for Table 1 of Gong et al. 2008.
struct Table1Order {
  std::filesystem::path models;
  std::string device;
  int frames = 9;  ///< of each measurement
  LogCallback log;
  StatusCallback status = statusTaker(true);
};

struct Table1Row {
  std::string data;
  std::size_t triangles = 0;
  std::size_t vertices = 0;
  double fragmentPerSecond = 0;  ///< the paper's FTF
  double vertexPerSecond = 0;    ///< the paper's VTF
  double treePerSecond = 0;      ///< the tree, at vertices or fragments as suits the model
  double paperFragmentPerSecond = 0;
  double paperVertexPerSecond = 0;
};

struct Table1 {
  DeviceDescription device;
  std::vector<Table1Row> rows;
};

/// Throws Error when the folder lacks a model.
void requireTable1Models(const std::filesystem::path& folder);

Table1 measureTable1(const Table1Order& order);

Json toJson(const Table1& table);
std::string toReadable(const Table1& table);

}  // namespace opaline::app
