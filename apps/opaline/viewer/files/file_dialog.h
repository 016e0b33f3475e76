#pragma once

#include <imgui.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "viewer/files/file_question.h"
#include "viewer/files/folder_listing.h"
#include "viewer/window/window.h"

namespace opaline::app::viewer {

/// A dialog of our own to choose a file in, over everything else of the window.
class FileDialog {
 public:
  void open(FileQuestion question);
  void close() { question_.reset(); }
  bool isOpen() const { return question_.has_value(); }

  /// All keys are the dialog's while it is open.
  void useKeys(const std::vector<KeyPress>& presses);
  /// Draws it with Dear ImGui's functions; the answer, once it is given.
  std::optional<FileAnswer> draw();

 private:
  void goTo(const std::filesystem::path& folder);
  void list();
  void select(std::size_t entry);
  void step(long by);
  void type(std::string text);
  void accept();
  void take(const std::filesystem::path& file);
  void drawAll();
  void drawPlace();
  void drawList();
  void drawName();
  void drawButtons();
  static int atEdit(ImGuiInputTextCallbackData* data);

  std::optional<FileQuestion> question_;
  std::filesystem::path folder_;
  FolderListing listing_;
  bool allFiles_ = false;
  std::string name_;  // as typed
  std::optional<std::size_t> selected_;
  std::string said_;                      // why the last choice was none
  std::filesystem::path wouldReplace_;    // asked about, and not yet answered
  std::optional<std::string> replacing_;  // what the name becomes while it is being typed
  bool showSelected_ = false;             // the list is to scroll there
  bool enter_ = false;                    // the key was pressed
  bool typeHere_ = false;                 // the name is to take the keys
  std::optional<FileAnswer> answer_;
};

}  // namespace opaline::app::viewer
