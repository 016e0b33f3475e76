#include "viewer/files/file_dialog.h"

#include <fmt/format.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include <GLFW/glfw3.h>

#include "cli/frame_names.h"
#include "viewer/panels/controls.h"
#include "viewer/window/glyphs.h"

namespace opaline::app::viewer {

namespace fs = std::filesystem;

namespace {

constexpr const char* filePopup = "file";
constexpr long page = 12;  // entries that Page Up and Page Down move by

bool isThere(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

}  // namespace

void FileDialog::open(FileQuestion question) {
  question_ = std::move(question);
  allFiles_ = false;
  answer_.reset();
  enter_ = false;
  goTo(question_->folder);
  type(question_->name);
  typeHere_ = true;
}

void FileDialog::goTo(const fs::path& folder) {
  folder_ = folder;
  type({});
  list();
}

void FileDialog::list() {
  listing_ = listFolder(folder_, allFiles_ ? std::vector<std::string>() : question_->extensions,
                        allFiles_);
  selected_.reset();
  showSelected_ = true;
  said_.clear();
  wouldReplace_.clear();
}

// The text field keeps its own copy of the name while it has keyboard focus.
void FileDialog::type(std::string text) {
  name_ = text;
  replacing_ = std::move(text);
}

void FileDialog::select(std::size_t entry) {
  selected_ = entry;
  said_.clear();
  wouldReplace_.clear();
  type(listing_.entries[entry].text);
}

void FileDialog::step(long by) {
  const auto count = static_cast<long>(listing_.entries.size());
  if (count == 0) return;
  long to = by > 0 ? by - 1 : 0;
  if (selected_) {
    // The first step goes to the entry that begins with the typed text.
    const bool named = name_ == listing_.entries[*selected_].text;
    to = static_cast<long>(*selected_) + (named ? by : 0);
  }
  select(static_cast<std::size_t>(std::clamp(to, 0L, count - 1)));
  showSelected_ = true;
}

void FileDialog::useKeys(const std::vector<KeyPress>& presses) {
  for (const KeyPress& press : presses) {
    switch (press.key) {
      case GLFW_KEY_ESCAPE:
        if (wouldReplace_.empty()) return close();
        wouldReplace_.clear();
        break;
      case GLFW_KEY_ENTER:
      case GLFW_KEY_KP_ENTER:
        enter_ = true;  // handled once the text typed before it has arrived
        break;
      case GLFW_KEY_UP:
        if (press.alt) {
          goTo(folder_.parent_path());
        } else {
          step(-1);
        }
        break;
      case GLFW_KEY_DOWN:
        step(1);
        break;
      case GLFW_KEY_PAGE_UP:
        step(-page);
        break;
      case GLFW_KEY_PAGE_DOWN:
        step(page);
        break;
      default:
        break;
    }
  }
}

// The file that the name means: the selected entry, whose name may have characters that cannot be
// typed, or a path.
void FileDialog::accept() {
  if (!wouldReplace_.empty()) {
    answer_ = {question_->use, wouldReplace_, true};
    return;
  }
  if (selected_ && name_ == listing_.entries[*selected_].text) {
    return take(folder_ / listing_.entries[*selected_].name);
  }
  if (name_.empty()) return;
  take(typedPath(folder_, name_));
}

void FileDialog::take(const fs::path& file) {
  if (isFolder(file)) return goTo(file);
  if (!question_->saves()) {
    // A name with a mark for the number stands for many files.
    if (isThere(file) || FrameNames::parse(file.string())) {
      answer_ = {question_->use, file, false};
    } else {
      said_ = fmt::format("There is no {}.", shownName(file));
    }
    return;
  }
  const fs::path whole = withExtension(file, *question_);
  if (!isFolder(whole.parent_path())) {
    said_ = fmt::format("There is no folder {}.", shownName(whole.parent_path()));
  } else if (isFolder(whole)) {
    said_ = fmt::format("{} is a folder.", shownName(whole));
  } else if (isThere(whole)) {
    wouldReplace_ = whole;
  } else {
    answer_ = {question_->use, whole, false};
  }
}

void FileDialog::drawPlace() {
  ImGui::BeginDisabled(!folder_.has_relative_path());
  if (controls::button("parent", "The folder above this one. Keys: Alt and up.")) {
    goTo(folder_.parent_path());
  }
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (controls::button("home", "Your home folder.")) goTo(homeFolder());
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  const std::string place = shownName(folder_);
  glyphs::want(place);
  ImGui::TextUnformatted(place.c_str());
}

void FileDialog::drawList() {
  const float below = 3.6F * ImGui::GetFrameHeightWithSpacing();
  ImGui::BeginChild("list", {0, -below}, true);
  if (!listing_.error.empty()) {
    ImGui::TextWrapped("%s", listing_.error.c_str());
  } else if (listing_.entries.empty()) {
    ImGui::TextDisabled("no folders, and no %s", allFiles_ ? "files" : question_->kind.c_str());
  }
  const float line = ImGui::GetTextLineHeightWithSpacing();
  if (std::exchange(showSelected_, false)) {
    const float at = line * static_cast<float>(selected_.value_or(0));
    const float room = ImGui::GetWindowHeight() - 2 * line;
    const float top = ImGui::GetScrollY();
    if (at < top || at > top + room) ImGui::SetScrollY(std::max(0.0F, at - room / 2));
  }
  std::optional<std::size_t> opened;
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(listing_.entries.size()), line);
  while (clipper.Step()) {
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
      const auto index = static_cast<std::size_t>(row);
      const FolderEntry& entry = listing_.entries[index];
      ImGui::PushID(row);
      const std::string text = entry.isFolder ? entry.text + "/" : entry.text;
      if (ImGui::Selectable("##entry", selected_ == index, ImGuiSelectableFlags_AllowDoubleClick)) {
        select(index);
        if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) opened = index;
      }
      controls::note(text.c_str());
      glyphs::want(text);
      ImGui::SameLine(0, 0);
      ImGui::TextUnformatted(text.c_str());
      ImGui::PopID();
    }
  }
  ImGui::EndChild();
  if (opened) take(folder_ / listing_.entries[*opened].name);
}

int FileDialog::atEdit(ImGuiInputTextCallbackData* data) {
  auto& dialog = *static_cast<FileDialog*>(data->UserData);
  if (data->EventFlag == ImGuiInputTextFlags_CallbackEdit) {
    const std::string_view typed(data->Buf, static_cast<std::size_t>(data->BufTextLen));
    dialog.said_.clear();
    dialog.wouldReplace_.clear();
    dialog.selected_ = firstWith(dialog.listing_, typed);
    dialog.showSelected_ = true;
  } else if (dialog.replacing_) {
    data->DeleteChars(0, data->BufTextLen);
    data->InsertChars(0, dialog.replacing_->c_str());
    dialog.replacing_.reset();
  }
  return 0;
}

void FileDialog::drawName() {
  if (std::exchange(typeHere_, false)) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  constexpr ImGuiInputTextFlags flags =
      ImGuiInputTextFlags_CallbackAlways | ImGuiInputTextFlags_CallbackEdit |
      ImGuiInputTextFlags_AutoSelectAll;  // the first letter replaces the offered name
  ImGui::InputTextWithHint("##name", "a name, or a path", &name_, flags, atEdit, this);
  controls::note("name");
  if (!ImGui::IsItemActive()) replacing_.reset();
}

void FileDialog::drawButtons() {
  if (!wouldReplace_.empty()) {
    ImGui::TextWrapped("%s already exists. Replace it?",
                       shownName(wouldReplace_.filename()).c_str());
    if (controls::button("replace", "Its contents are lost. Key: Enter.")) accept();
    ImGui::SameLine();
    if (controls::button("keep", "Choose another name. Key: Escape.")) wouldReplace_.clear();
    return;
  }
  if (!said_.empty()) {
    ImGui::TextWrapped("%s", said_.c_str());
  } else {
    ImGui::TextDisabled("%s", question_->saves() ? "The ending is added if it is missing."
                                                 : "A file can also be dropped on the window.");
  }
  if (controls::button(question_->saves() ? "save" : "open", "Key: Enter.")) accept();
  ImGui::SameLine();
  if (controls::button("cancel", "Key: Escape.")) return close();
  ImGui::SameLine();
  if (controls::checkbox("all files", allFiles_,
                         "Also shows files of other kinds, and hidden ones.")) {
    list();
  }
}

void FileDialog::drawAll() {
  const controls::Group group("File");
  ImGui::TextUnformatted(question_->title.c_str());
  drawPlace();
  drawList();
  drawName();
  if (std::exchange(enter_, false)) accept();
  drawButtons();
}

std::optional<FileAnswer> FileDialog::draw() {
  if (!question_ && !ImGui::IsPopupOpen(filePopup)) return std::nullopt;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float font = ImGui::GetFontSize();
  ImGui::SetNextWindowSize(
      {std::min(0.94F * screen.x, 46 * font), std::min(0.94F * screen.y, 36 * font)});
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
  if (!ImGui::IsPopupOpen(filePopup)) ImGui::OpenPopup(filePopup);
  constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                     ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoNav |
                                     ImGuiWindowFlags_NoSavedSettings;
  if (ImGui::BeginPopupModal(filePopup, nullptr, flags)) {
    if (question_) drawAll();
    if (!question_ || answer_) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
  }
  if (answer_) close();
  return std::exchange(answer_, std::nullopt);
}

}  // namespace opaline::app::viewer
