#include "paths.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <system_error>

#include "core/file.h"
#include "opaline/error.h"

namespace opaline::app {

std::string extensionOf(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return extension;
}

std::filesystem::path readOutput(const Given& given, const std::vector<std::string>& extensions) {
  std::filesystem::path file = given.text;
  if (std::find(extensions.begin(), extensions.end(), extensionOf(file)) == extensions.end()) {
    throw UsageError(fmt::format("{} {}: the file's name must end in {}", given.option, given.text,
                                 fmt::join(extensions, " or ")));
  }
  return file;
}

void requireWritableFile(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
      !std::filesystem::is_directory(status)) {
    throw Error(fmt::format("{}: is no regular file and will not be replaced", file.string()));
  }
  core::requireWritable(file);
}

}  // namespace opaline::app
