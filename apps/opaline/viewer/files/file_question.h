#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace opaline::app::viewer {

/// What a file is chosen for.
enum class FileUse { OpenScene, OpenEnvironment, SavePicture, SaveExr, SaveScene, SaveFilm };

/// What the user is asked for. How it is asked is another's business.
struct FileQuestion {
  FileUse use = FileUse::OpenScene;
  std::string title;
  std::string kind;                     ///< of file, as people call it: "models and scenes"
  std::vector<std::string> extensions;  ///< in lower case, with their dots
  std::filesystem::path folder;         ///< to begin in, absolute
  std::string name;                     ///< that is offered; empty: none

  bool saves() const;
};

/// The question for a use, with all but folder and name.
FileQuestion questionFor(FileUse use);

/// A file that was chosen.
struct FileAnswer {
  FileUse use = FileUse::OpenScene;
  std::filesystem::path file;
  bool mayReplace = false;  ///< the user has said so of the file that stands there
};

/// The name as it is written where the question saves: with an extension of that kind.
std::filesystem::path withExtension(std::filesystem::path file, const FileQuestion& question);

}  // namespace opaline::app::viewer
