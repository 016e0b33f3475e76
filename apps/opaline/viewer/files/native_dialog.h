#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/child_process.h"
#include "viewer/files/file_question.h"

namespace opaline::app::viewer {

/// A program that shows the desktop's file dialog.
struct DialogProgram {
  std::filesystem::path file;
  bool ofKde = false;  ///< kdialog; else zenity
};

/// The program that suits the running desktop. None where no desktop runs or no program is
/// installed.
std::optional<DialogProgram> findDialogProgram();

/// The arguments to start it with.
std::vector<std::string> argumentsFor(const DialogProgram& program, const FileQuestion& question);

/// The file that its output names: one name and a line end, whatever the name contains. None where
/// it names none.
std::optional<std::filesystem::path> fileIn(const std::string& output);

/// The desktop's own dialog, which another program shows.
class NativeDialog {
 public:
  /// Throws Error when the program cannot be started.
  NativeDialog(const DialogProgram& program, const FileQuestion& question);

  bool isOpen() const { return child_.isRunning(); }
  /// The chosen file, once the dialog is closed; none if the user chose nothing.
  std::optional<std::filesystem::path> file();
  /// Whether the program could not do its work. Call after file().
  bool failed() const { return failed_; }

 private:
  ChildProcess child_;
  bool failed_ = false;
};

}  // namespace opaline::app::viewer
