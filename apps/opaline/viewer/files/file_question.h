#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace opaline::app::viewer {

/// What a file is chosen for.
enum class FileUse { OpenScene, OpenEnvironment, SavePicture, SaveExr, SaveScene, SaveFilm };

/// What the user is asked for, whichever dialog asks.
struct FileQuestion {
  FileUse use = FileUse::OpenScene;
  std::string title;
  std::string kind;                     ///< of file, in plain words: "models and scenes"
  std::vector<std::string> extensions;  ///< in lower case, with their dots
  std::filesystem::path folder;         ///< where to begin, absolute
  std::string name;                     ///< offered name; empty: none

  bool saves() const;
};

/// The question for a use; folder and name are left empty.
FileQuestion questionFor(FileUse use);

/// A file that the user chose.
struct FileAnswer {
  FileUse use = FileUse::OpenScene;
  std::filesystem::path file;
  bool mayReplace = false;  ///< the user agreed to replace the existing file
};

/// The name to be used. When saving, it gets an extension of that kind.
std::filesystem::path withExtension(std::filesystem::path file, const FileQuestion& question);

}  // namespace opaline::app::viewer
