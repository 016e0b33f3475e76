#include "paths.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

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

}  // namespace opaline::app
