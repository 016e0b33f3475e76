#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/child_process.h"
#include "viewer/files/file_question.h"

namespace opaline::app::viewer {

/// A program that shows the desktop's own dialog.
struct DialogProgram {
  std::filesystem::path file;
  bool ofKde = false;  ///< kdialog; else zenity
};

/// The one that suits the desktop that runs; nothing where none runs or none is installed.
std::optional<DialogProgram> findDialogProgram();

/// What it is called with.
std::vector<std::string> argumentsFor(const DialogProgram& program, const FileQuestion& question);

/// The file that its output names: one name and a line's end, whatever the name holds. Nothing
/// where it names none.
std::optional<std::filesystem::path> fileIn(const std::string& output);

/// The desktop's own dialog, in a window of another program.
class NativeDialog {
 public:
  /// Throws Error when the program cannot be started.
  NativeDialog(const DialogProgram& program, const FileQuestion& question);

  bool isOpen() const { return child_.isRunning(); }
  /// Once it is not open any more: the file, or nothing where the user chose none.
  std::optional<std::filesystem::path> file();
  /// Whether the program could not do what it is for. After file().
  bool failed() const { return failed_; }

 private:
  ChildProcess child_;
  bool failed_ = false;
};

}  // namespace opaline::app::viewer
