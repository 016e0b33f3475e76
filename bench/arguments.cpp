#include "arguments.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "opaline/error.h"
#include "opaline/media.h"

namespace opaline::bench {

namespace {

std::optional<std::filesystem::path> findModel(const char* name) {
  const char* models = std::getenv("OPALINE_MODELS");
  const std::filesystem::path folder =
      models != nullptr ? std::filesystem::path(models)
                        : std::filesystem::path(OPALINE_SOURCE_DIR) / ".." / "shared" / "models";
  std::filesystem::path file = folder / name;
  if (std::filesystem::exists(file)) return file;
  return std::nullopt;
}

LoadOptions optionsFor(const char* medium) {
  LoadOptions options;
  options.diagonalMm = 50;
  options.medium = findMedium(medium);
  return options;
}

int positive(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 2 || value > 1'000'000)
    throw UsageError(fmt::format("--frames takes a whole number from 2 to 1000000, not {}", text));
  return value;
}

}  // namespace

Arguments parse(std::string_view program, int count, char** values, int defaultFrames) {
  Arguments arguments{.json = false, .frames = defaultFrames, .device = {}};
  for (int i = 1; i < count; ++i) {
    const std::string_view argument = values[i];
    if (argument == "--json") {
      arguments.json = true;
    } else if (argument == "--frames" && i + 1 < count) {
      arguments.frames = positive(values[++i]);
    } else if (argument == "--device" && i + 1 < count) {
      arguments.device = values[++i];
    } else {
      throw UsageError(
          fmt::format("usage: {} [--json] [--frames N] [--device NAME|INDEX]; {} is unknown",
                      program, argument));
    }
  }
  return arguments;
}

Scene loadModel(const char* medium) {
  const LoadOptions options = optionsFor(medium);
  if (const auto bunny = findModel("bunny.ply")) return loadScene(*bunny, options);
  fmt::print(
      stderr,
      "no bunny.ply in the folder that OPALINE_MODELS names; the built-in bear stands in for it\n");
  return builtInBear(options);
}

Scene loadBear() {
  return builtInBear(optionsFor("marble"));
}

std::vector<Scene> loadScenes() {
  std::vector<Scene> scenes;
  for (const char* medium : {"marble", "skin1"}) scenes.push_back(loadModel(medium));
  for (const char* medium : {"gummy-red", "jade"})
    scenes.push_back(builtInBear(optionsFor(medium)));
  if (const auto man = findModel("gltf/CesiumMan.glb"))
    scenes.push_back(loadScene(*man, optionsFor("marble")));
  return scenes;
}

int runMain(void (*run)(int count, char** values), int count, char** values) {
  try {
    run(count, values);
    return 0;
  } catch (const UsageError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}

}  // namespace opaline::bench
