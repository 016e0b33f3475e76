#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace opaline::scene {

/// The canonical folder of a file. Throws Error where it does not exist.
std::string folderOf(const std::filesystem::path& file);

/// The path of a file that a model names. A model may only read files in its own folder; `refusal`
/// says why another file is refused. `kind` says what the file is.
std::optional<std::filesystem::path> fileInFolder(const std::string& folder,
                                                  const std::string& name, std::string_view kind,
                                                  std::string& refusal);

/// The same for a file beside a model's own. Throws Error with the refusal.
std::filesystem::path fileBeside(const std::filesystem::path& model, const std::string& name,
                                 std::string_view kind);

}  // namespace opaline::scene
