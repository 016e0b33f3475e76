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
/// window goes on meanwhile.
class FileChooser {
 public:
  /// `openFolder` is where models and environments were opened from last; empty: not known.
  explicit FileChooser(std::filesystem::path openFolder) : openFolder_(std::move(openFolder)) {}

  /// Asks for a file; `offered` is a name to save under. While one is asked for, no other is.
  void ask(FileUse use, const std::filesystem::path& offered = {});
  /// Whether our own dialog has the window.
  bool isModal() const { return own_.isOpen(); }
  /// Whether there is a dialog of another program, whose end is no event of the window.
  bool isWaiting() const { return native_.has_value(); }
  void close();

  void useKeys(const std::vector<KeyPress>& presses) { own_.useKeys(presses); }
  /// Draws our own dialog; the answer, once it is given.
  std::optional<FileAnswer> draw();

  const std::filesystem::path& openFolder() const { return openFolder_; }

 private:
  std::optional<FileAnswer> takeNative();

  std::filesystem::path openFolder_;
  std::filesystem::path saveFolder_;  // where something was saved last
  std::optional<FileQuestion> question_;
  std::optional<NativeDialog> native_;
  FileDialog own_;
};

}  // namespace opaline::app::viewer
