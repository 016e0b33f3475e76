#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "opaline/scene.h"

namespace opaline::bench {

struct Arguments {
  bool json = false;
  int frames = 0;
  std::string device;  ///< as RendererOptions::device
};

/// --json, --frames N and --device NAME|INDEX. Throws UsageError for anything else.
Arguments parse(std::string_view program, int count, char** values, int defaultFrames);

/// The bunny among the models, or the built-in bear if there are none, 50 mm.
Scene loadModel(const char* medium = "marble");

/// The built-in bear in marble, 50 mm.
Scene loadBear();

/// The scenes whose frames are measured with default settings, each 50 mm: bunnies, bears, and a
/// walking man if there are models.
std::vector<Scene> loadScenes();

/// Runs a benchmark. An exception becomes a sentence on standard error and an exit status.
int runMain(void (*run)(int count, char** values), int count, char** values);

}  // namespace opaline::bench
