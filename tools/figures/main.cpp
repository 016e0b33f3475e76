// Makes the pictures of docs/ and of the README: all of them, or those named.

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "figures.h"
#include "opaline/error.h"

namespace opaline::figures {

namespace {

namespace fs = std::filesystem;

fs::path modelFolder() {
  const char* models = std::getenv("OPALINE_MODELS");
  return models != nullptr ? fs::path(models)
                           : fs::path(OPALINE_SOURCE_DIR) / ".." / "shared" / "models";
}

void requireModels(const fs::path& folder) {
  for (const char* file : {"bunny.ply", "bunny_closed.ply", "buddha.ply", "bunny_egg_a.ply",
                           "bunny_egg_b.ply", "gltf/CesiumMan.glb", "env/venice_sunset_1k.hdr"}) {
    std::error_code error;
    if (fs::is_regular_file(folder / file, error)) continue;
    throw Error(fmt::format("there is no {} in {}: OPALINE_MODELS names the folder of the models",
                            file, folder.string()));
  }
}

std::vector<Figure> allFigures() {
  std::vector<Figure> all;
  for (const std::span<const Figure> some :
       {stillFigures(), cubeFigures(), sumFigures(), boundaryFigures(), motionFigures(),
        variableFigures(), lightFigures()}) {
    all.insert(all.end(), some.begin(), some.end());
  }
  std::sort(all.begin(), all.end(), [](const Figure& a, const Figure& b) {
    return std::string_view(a.name) < std::string_view(b.name);
  });
  return all;
}

std::vector<Figure> named(const std::vector<std::string_view>& names) {
  const std::vector<Figure> all = allFigures();
  if (names.empty()) return all;
  std::vector<Figure> chosen;
  for (const std::string_view name : names) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const Figure& figure) { return figure.name == name; });
    if (found == all.end()) {
      std::string known;
      for (const Figure& figure : all) known += fmt::format(" {}", figure.name);
      throw UsageError(fmt::format("there is no figure {}; there are{}", name, known));
    }
    chosen.push_back(*found);
  }
  return chosen;
}

/// Removes an option and its value from the arguments.
std::optional<std::string> takeValue(std::vector<std::string_view>& arguments,
                                     std::string_view option) {
  const auto found = std::find(arguments.begin(), arguments.end(), option);
  if (found == arguments.end()) return std::nullopt;
  if (found + 1 == arguments.end()) throw UsageError(fmt::format("{} needs a value", option));
  const std::string value(*(found + 1));
  arguments.erase(found, found + 2);
  return value;
}

/// opaline_figures [--into FOLDER] [--shrunk N] [FIGURE...]
void run(std::vector<std::string_view> arguments) {
  const fs::path output =
      takeValue(arguments, "--into").value_or(OPALINE_SOURCE_DIR "/docs/images");
  const std::string shrunk = takeValue(arguments, "--shrunk").value_or("1");
  if (shrunk != "1" && shrunk != "2" && shrunk != "4")
    throw UsageError(fmt::format("--shrunk {}: must be 1, 2 or 4", shrunk));
  const std::vector<Figure> chosen = named(arguments);
  const fs::path models = modelFolder();
  requireModels(models);
  Studio studio{models, output, Renderer(), std::stoi(shrunk)};
  for (const Figure& figure : chosen) figure.make(studio, figure.name);
}

}  // namespace

}  // namespace opaline::figures

int main(int count, char** values) {
  try {
    opaline::figures::run({values + 1, values + count});
    return 0;
  } catch (const opaline::UsageError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
