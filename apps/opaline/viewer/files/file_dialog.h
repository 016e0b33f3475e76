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

/// Our own file dialog, above everything else in the window.
class FileDialog {
 public:
  void open(FileQuestion question);
  void close() { question_.reset(); }
  bool isOpen() const { return question_.has_value(); }

  /// The dialog takes all keys while it is open.
  void useKeys(const std::vector<KeyPress>& presses);
  /// Draws it with Dear ImGui. Returns the answer once it is given.
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
  std::string said_;                      // why the last choice was refused
  std::filesystem::path wouldReplace_;    // the user is asked, and has not answered
  std::optional<std::string> replacing_;  // new content of the name's field while it is edited
  bool showSelected_ = false;             // the list must scroll there
  bool enter_ = false;                    // Enter was pressed
  bool typeHere_ = false;                 // the name's field must take the focus
  std::optional<FileAnswer> answer_;
};

}  // namespace opaline::app::viewer
