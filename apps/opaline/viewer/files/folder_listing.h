#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace opaline::app::viewer {

/// One line of a folder's list.
struct FolderEntry {
  std::filesystem::path name;  ///< without the folder
  std::string text;            ///< the name as it can be shown
  bool isFolder = false;
};

/// What a folder holds.
struct FolderListing {
  std::vector<FolderEntry> entries;  ///< folders first, each by name
  std::string error;                 ///< one sentence where it cannot be read, else empty
};

/// Folders, and files with one of the extensions, or all files where none is given; hidden ones,
/// whose names begin with a dot, only with `hidden`.
FolderListing listFolder(const std::filesystem::path& folder,
                         const std::vector<std::string>& extensions, bool hidden);

/// A name in one line of valid UTF-8: what cannot be shown of it becomes '?'.
std::string shownName(const std::filesystem::path& name);

/// The first entry whose name begins with the text, whether letters are capital or not.
std::optional<std::size_t> firstWith(const FolderListing& listing, std::string_view text);

/// What is meant by a name that was typed while a folder was shown: absolute, or within the folder,
/// or with ~ for the user's own folder.
std::filesystem::path typedPath(const std::filesystem::path& folder, std::string_view typed);

/// The user's own folder; / where the environment names none.
std::filesystem::path homeFolder();

}  // namespace opaline::app::viewer
