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

/// The bunny of the models, or the built-in bear where there are none, 50 mm.
Scene loadModel(const char* medium = "marble");

/// The built-in bear of marble, 50 mm.
Scene loadBear();

/// What frames of default settings are measured of, each 50 mm: bunnies, bears, and a walking man
/// where the models are there.
std::vector<Scene> loadScenes();

/// Runs a benchmark; what it throws becomes a sentence on standard error and an exit status.
int runMain(void (*run)(int count, char** values), int count, char** values);

}  // namespace opaline::bench
