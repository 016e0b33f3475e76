#include "viewer/files/native_dialog.h"

#include <cstdlib>
#include <string_view>
#include <utility>

#include "viewer/files/folder_listing.h"

namespace opaline::app::viewer {

namespace fs = std::filesystem;

namespace {

// Patterns such as *.glb *.GLB: the dialogs match case.
std::string patterns(const FileQuestion& question) {
  std::string list;
  for (const std::string& extension : question.extensions) {
    std::string capital = extension;
    for (char& c : capital) {
      if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    }
    list += (list.empty() ? "*" : " *") + extension;
    list += " *" + capital;
  }
  return list;
}

}  // namespace

std::optional<DialogProgram> findDialogProgram() {
  const char* const desktop = std::getenv("XDG_CURRENT_DESKTOP");
  if (desktop == nullptr || *desktop == 0) return std::nullopt;
  const bool kdeFirst = std::string_view(desktop).find("KDE") != std::string_view::npos;
  for (const bool ofKde : {kdeFirst, !kdeFirst}) {
    if (auto found = findProgram(ofKde ? "kdialog" : "zenity")) {
      return DialogProgram{std::move(*found), ofKde};
    }
  }
  return std::nullopt;
}

std::vector<std::string> argumentsFor(const DialogProgram& program, const FileQuestion& question) {
  // A trailing slash makes a folder the place to begin instead of the choice.
  const std::string place = (question.folder / question.name).string();
  if (program.ofKde) {
    return {"--title", question.title, question.saves() ? "--getsavefilename" : "--getopenfilename",
            place, question.kind + " (" + patterns(question) + ")"};
  }
  std::vector<std::string> arguments{
      "--file-selection", "--title=" + question.title, "--filename=" + place,
      "--file-filter=" + question.kind + " | " + patterns(question), "--file-filter=all files | *"};
  if (question.saves()) {
    arguments.emplace_back("--save");
    arguments.emplace_back("--confirm-overwrite");
  }
  return arguments;
}

std::optional<fs::path> fileIn(const std::string& output) {
  std::string_view name = output;
  if (name.ends_with('\n')) name.remove_suffix(1);
  if (!name.starts_with('/')) return std::nullopt;
  return fs::path(name);
}

NativeDialog::NativeDialog(const DialogProgram& program, const FileQuestion& question)
    : child_(program.file, argumentsFor(program, question), ChildProcess::Output::Kept) {}

std::optional<fs::path> NativeDialog::file() {
  constexpr std::size_t longestName = 1U << 16U;
  child_.finish();
  // Both programs exit with 1 if the user chose nothing.
  constexpr int noChoice = 1;
  std::optional<fs::path> file;
  if (child_.exitStatus() == 0) file = fileIn(child_.output(longestName));
  failed_ = !file && child_.exitStatus() != noChoice;
  return file;
}

}  // namespace opaline::app::viewer
