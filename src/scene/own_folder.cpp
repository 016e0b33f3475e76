#include "scene/own_folder.h"

#include <fmt/format.h>

#include <algorithm>

#include "opaline/error.h"
#include "scene/text.h"

namespace opaline::scene {

namespace fs = std::filesystem;

std::string folderOf(const fs::path& file) {
  std::error_code problem;
  const fs::path parent = file.parent_path();
  std::string folder = fs::canonical(parent.empty() ? fs::path(".") : parent, problem).string();
  if (problem)
    throw Error(fmt::format("{}: its folder cannot be found", cleanText(file.string(), 1000)));
  return folder;
}

std::optional<fs::path> fileInFolder(const std::string& folder, const std::string& name,
                                     std::string_view kind, std::string& refusal) {
  const fs::path relative(name);
  const bool climbs = std::any_of(relative.begin(), relative.end(),
                                  [](const fs::path& part) { return part == ".."; });
  const std::string shown = cleanText(name, 100);
  if (relative.is_absolute() || climbs || name.find('\0') != std::string::npos) {
    refusal = fmt::format("its {} '{}' lies outside of the model's folder", kind, shown);
    return std::nullopt;
  }
  if (name.starts_with("http://") || name.starts_with("https://")) {
    refusal = fmt::format("its {} '{}' is on the network, but only files are read", kind, shown);
    return std::nullopt;
  }
  std::error_code problem;
  const fs::path real = fs::canonical(fs::path(folder) / relative, problem);
  if (problem) {
    refusal = fmt::format("its {} '{}' does not exist", kind, shown);
    return std::nullopt;
  }
  const fs::path root(folder);
  if (std::mismatch(root.begin(), root.end(), real.begin(), real.end()).first != root.end()) {
    refusal = fmt::format("its {} '{}' leads out of the model's folder", kind, shown);
    return std::nullopt;
  }
  return real;
}

fs::path fileBeside(const fs::path& model, const std::string& name, std::string_view kind) {
  std::string refusal;
  const auto file = fileInFolder(folderOf(model), name, kind, refusal);
  if (!file) throw Error(refusal);
  return *file;
}

}  // namespace opaline::scene
