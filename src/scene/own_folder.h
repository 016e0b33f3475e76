#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace opaline::scene {

/// The folder of a file, canonical. Throws Error where there is none.
std::string folderOf(const std::filesystem::path& file);

/// Where a file is that a model names, or, in `refusal`, why a model in that folder may not read
/// it: nothing outside of the folder is. `kind` says what it is.
std::optional<std::filesystem::path> fileInFolder(const std::string& folder,
                                                  const std::string& name, std::string_view kind,
                                                  std::string& refusal);

/// The same beside a model's file. Throws Error with the refusal.
std::filesystem::path fileBeside(const std::filesystem::path& model, const std::string& name,
                                 std::string_view kind);

}  // namespace opaline::scene
