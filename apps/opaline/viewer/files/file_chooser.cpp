#include "viewer/files/file_chooser.h"

#include <exception>
#include <system_error>
#include <utility>

#include "viewer/files/folder_listing.h"

namespace opaline::app::viewer {

namespace fs = std::filesystem;

namespace {

fs::path workingFolder() {
  std::error_code error;
  fs::path folder = fs::current_path(error);
  return error ? homeFolder() : folder;
}

}  // namespace

void FileChooser::ask(FileUse use, const fs::path& offered) {
  if (native_ || own_.isOpen()) return;
  FileQuestion question = questionFor(use);
  if (question.saves()) question.name = offered.filename().string();
  std::error_code error;
  question.folder = question.saves() ? fs::absolute(offered, error).parent_path() : openFolder_;
  if (!isFolder(question.folder)) question.folder = workingFolder();
  question_ = question;
  if (const std::optional<DialogProgram> program = findDialogProgram()) {
    try {
      native_.emplace(*program, question);
      return;
    } catch (const std::exception&) {
      native_.reset();  // our own dialog takes over
    }
  }
  own_.open(std::move(question));
}

void FileChooser::close() {
  native_.reset();
  own_.close();
}

std::optional<FileAnswer> FileChooser::takeNative() {
  if (!native_ || native_->isOpen()) return std::nullopt;
  const std::optional<fs::path> file = native_->file();
  const bool failed = native_->failed();
  native_.reset();
  if (failed) own_.open(*question_);
  if (!file) return std::nullopt;
  if (!question_->saves()) return FileAnswer{question_->use, *file, false};
  const fs::path whole = withExtension(*file, *question_);
  // The desktop's dialog has already asked whether to replace the file of that name.
  return FileAnswer{question_->use, whole, whole == *file};
}

std::optional<FileAnswer> FileChooser::draw() {
  std::optional<FileAnswer> answer = takeNative();
  if (auto given = own_.draw()) answer = std::move(given);
  if (answer && !question_->saves()) openFolder_ = answer->file.parent_path();
  return answer;
}

}  // namespace opaline::app::viewer
