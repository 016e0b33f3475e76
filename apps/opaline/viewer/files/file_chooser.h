#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "viewer/files/file_dialog.h"
#include "viewer/files/file_question.h"
#include "viewer/files/native_dialog.h"
#include "viewer/window/window.h"

namespace opaline::app::viewer {

/// Lets the user choose files: in the desktop's own dialog where there is one, else in ours. The
/// window stays alive meanwhile.
class FileChooser {
 public:
  /// `openFolder` is where a model or an environment was last opened; empty: unknown.
  explicit FileChooser(std::filesystem::path openFolder) : openFolder_(std::move(openFolder)) {}

  /// Asks for a file; `offered` is a path to save under. Only one question is open at a time.
  void ask(FileUse use, const std::filesystem::path& offered = {});
  /// Whether our own dialog is open.
  bool isModal() const { return own_.isOpen(); }
  /// Whether another program's dialog is open, whose end causes no event of the window.
  bool isWaiting() const { return native_.has_value(); }
  void close();

  void useKeys(const std::vector<KeyPress>& presses) { own_.useKeys(presses); }
  /// Draws our own dialog. Returns the answer once it is given.
  std::optional<FileAnswer> draw();

  const std::filesystem::path& openFolder() const { return openFolder_; }

 private:
  std::optional<FileAnswer> takeNative();

  std::filesystem::path openFolder_;
  std::optional<FileQuestion> question_;
  std::optional<NativeDialog> native_;
  FileDialog own_;
};

}  // namespace opaline::app::viewer
