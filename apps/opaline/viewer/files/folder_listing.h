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
  std::string text;            ///< the name in a form that can be shown
  bool isFolder = false;
};

/// The content of a folder.
struct FolderListing {
  std::vector<FolderEntry> entries;  ///< folders first, each by name
  std::string error;                 ///< one sentence if it cannot be read, else empty
};

/// Lists folders, and files with one of the extensions, or all files where none is given. Names
/// that begin with a dot are listed only with `hidden`.
FolderListing listFolder(const std::filesystem::path& folder,
                         const std::vector<std::string>& extensions, bool hidden);

/// Also false for what cannot be accessed.
bool isFolder(const std::filesystem::path& path);

/// A name as one line of valid UTF-8, with '?' for what cannot be shown.
std::string shownName(const std::filesystem::path& name);

/// The first entry whose name begins with the text, regardless of case.
std::optional<std::size_t> firstWith(const FolderListing& listing, std::string_view text);

/// The path meant by a name that was typed while a folder was shown: absolute, relative to the
/// folder, or with ~ for the user's home.
std::filesystem::path typedPath(const std::filesystem::path& folder, std::string_view typed);

/// The user's home; / where the environment names none.
std::filesystem::path homeFolder();

}  // namespace opaline::app::viewer
