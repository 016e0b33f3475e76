#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

namespace opaline::test {

/// What some tests need and the repository is too small for; they are skipped where it is missing.

/// The folder that OPALINE_MODELS names, else the one beside the repository.
inline std::optional<std::filesystem::path> modelsFolder() {
  const char* named = std::getenv("OPALINE_MODELS");
  const std::filesystem::path folder =
      named != nullptr ? std::filesystem::path(named)
                       : std::filesystem::path(OPALINE_SOURCE_DIR) / ".." / "shared" / "models";
  if (!std::filesystem::is_directory(folder)) return std::nullopt;
  return folder;
}

inline std::optional<std::filesystem::path> fileOf(
    const std::optional<std::filesystem::path>& folder, const std::string& name) {
  if (!folder || !std::filesystem::is_regular_file(*folder / name)) return std::nullopt;
  return *folder / name;
}

inline std::optional<std::filesystem::path> sharedModel(const std::string& name) {
  return fileOf(modelsFolder(), name);
}

/// A table of published values, in the folder that OPALINE_REFERENCE names, else beside the models.
inline std::optional<std::filesystem::path> referenceTable(const std::string& name) {
  if (const char* named = std::getenv("OPALINE_REFERENCE")) return fileOf(named, name);
  const auto models = modelsFolder();
  if (!models) return std::nullopt;
  return fileOf(*models / ".." / "reference", name);
}

}  // namespace opaline::test
