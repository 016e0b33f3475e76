#include "cli/paths.h"

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

void requireNoInput(const std::vector<Output>& outputs,
                    const std::vector<std::filesystem::path>& inputs) {
  std::error_code ignored;  // a file that cannot be looked at counts as absent
  for (const Output& output : outputs) {
    if (!std::filesystem::exists(output.file, ignored)) continue;
    for (const std::filesystem::path& input : inputs) {
      if (!std::filesystem::equivalent(output.file, input, ignored)) continue;
      throw UsageError(fmt::format("{} {}: it is read as {}; name another file to write",
                                   output.option, output.file.string(), input.string()));
    }
  }
}

std::string nameText(const std::filesystem::path& file, const std::filesystem::path& wanted) {
  if (file == wanted) return file.string();
  return fmt::format("{}, because {} exists", file.string(), wanted.string());
}

std::filesystem::path readOutput(const Given& given, const std::vector<std::string>& extensions) {
  std::filesystem::path file = given.text;
  if (std::find(extensions.begin(), extensions.end(), extensionOf(file)) == extensions.end()) {
    std::string list = extensions.front();
    for (std::size_t i = 1; i < extensions.size(); ++i)
      list += (i + 1 < extensions.size() ? ", " : " or ") + extensions[i];
    throw UsageError(
        fmt::format("{} {}: the file's name must end in {}", given.option, given.text, list));
  }
  return file;
}

}  // namespace opaline::app
